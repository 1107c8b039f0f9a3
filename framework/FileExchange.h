#pragma once
/// \file
/// How instances reach outside programs as files, and how their answers come back. Whoever knows file formats
/// implements it (Catalog::files); the names are those of Catalog::formats.

#include "framework/model/Instance.h"
#include "framework/model/Schedule.h"

#include <filesystem>
#include <optional>
#include <string>

namespace mrpp
{

class FileExchange
{
public:
    FileExchange() = default;
    virtual ~FileExchange() = default;
    FileExchange(const FileExchange &) = delete;
    FileExchange &operator=(const FileExchange &) = delete;

    /// ".graphml", …: what files of the format are called.
    [[nodiscard]] virtual std::string extensionOf(const std::string &format) const = 0;

    /// Throws InputError where the format cannot hold that graph, and FileError where the file cannot be
    /// written.
    virtual void writeGraph(const std::string &format, const Graph &graph,
                            const std::filesystem::path &file) const = 0;

    /// \param graphFile what the instance names where its format does not hold the graph
    /// Throws as writeGraph() does.
    virtual void writeInstance(const std::string &format, const Instance &instance,
                               const std::filesystem::path &graphFile,
                               const std::filesystem::path &file) const = 0;

    /// The answer in that file; nothing where the file itself says that there is none. Throws InputError
    /// where it is malformed, or holds a move that no motion rule allows. \param format empty where the
    /// contents tell it
    [[nodiscard]] virtual std::optional<Schedule> readSolution(const std::string &format,
                                                               const Instance &instance,
                                                               const std::filesystem::path &file) const = 0;
};

} // namespace mrpp

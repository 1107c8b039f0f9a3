#pragma once
/// \file
/// The formats of this folder for outside programs.

#include "framework/FileExchange.h"

namespace mrpp
{

/// Writes graphs and instances in every format that has one, and reads solutions of every format.
class Exchange final : public FileExchange
{
public:
    [[nodiscard]] std::string extensionOf(const std::string &format) const override;
    void writeGraph(const std::string &format, const Graph &graph,
                    const std::filesystem::path &file) const override;
    void writeInstance(const std::string &format, const Instance &instance,
                       const std::filesystem::path &graphFile,
                       const std::filesystem::path &file) const override;
    [[nodiscard]] std::optional<Schedule> readSolution(const std::string &format, const Instance &instance,
                                                       const std::filesystem::path &file) const override;
};

} // namespace mrpp

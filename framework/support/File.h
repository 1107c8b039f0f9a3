#pragma once
/// \file
/// Files read whole and written atomically: to a temporary name beside the target, flushed to the disk, then
/// renamed, so that a reader or a crash never meets half a file.

#include <filesystem>
#include <string>
#include <string_view>

namespace mrpp
{

/// The file's bytes. Throws FileError where it cannot be read or is a folder.
[[nodiscard]] std::string readFile(const std::filesystem::path &path);

/// Replaces the file as a whole or not at all; makes its folder where that is missing. Throws FileError.
void writeFile(const std::filesystem::path &path, std::string_view contents);

/// The same for contents that come piece by piece and need not fit into the memory.
///
/// \code
/// FileWriter file("moves.txt");
/// file.write("a piece");
/// file.commit();
/// \endcode
class FileWriter
{
public:
    /// Makes a temporary file beside the target, and the target's folder where that is missing. Throws
    /// FileError.
    explicit FileWriter(std::filesystem::path path);
    /// Drops what was not committed.
    ~FileWriter();
    FileWriter(const FileWriter &) = delete;
    FileWriter &operator=(const FileWriter &) = delete;

    /// Throws FileError.
    void write(std::string_view contents);
    /// Replaces the target by what was written. Throws FileError. To be called once, as the last.
    void commit();

private:
    [[noreturn]] void fail(const char *step) const;

    std::filesystem::path path_;
    std::string temporary_; ///< empty once it is gone
    int file_ = -1;
};

} // namespace mrpp

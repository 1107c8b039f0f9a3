#pragma once
/// \file
/// Files read whole and written atomically: to a temporary name beside the target, flushed to the disk, then
/// renamed, so that a reader or a crash never meets half a file.

#include <filesystem>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

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
    /// FileError, also where the target is a folder.
    explicit FileWriter(std::filesystem::path path);
    /// Drops what was not committed.
    ~FileWriter();
    FileWriter(const FileWriter &) = delete;
    FileWriter &operator=(const FileWriter &) = delete;

    /// Throws FileError.
    void write(std::string_view contents);
    /// Flushes what was written to the disk. Throws FileError. Nothing can be written any more.
    void finish();
    /// Replaces the target by what was written. Throws FileError. To be called once, as the last.
    void commit();

    /// Removes the temporary file of what was not committed.
    void abandon();

    [[nodiscard]] const std::filesystem::path &path() const { return path_; }

private:
    [[noreturn]] void fail(const char *step) const;

    std::filesystem::path path_;
    std::string temporary_; ///< empty once it is gone
    int file_ = -1;
};

/// Several files that are written together: whatever cannot be made or written leaves all targets as they
/// were.
///
/// \code
/// FileSet files;
/// files.add("g.graphml").write(graph);
/// files.add("g.instance").write(instance);
/// files.commit();
/// \endcode
class FileSet
{
public:
    /// One more file, to be written before the commit. Throws FileError as FileWriter does, and for a file
    /// that is in the set already.
    FileWriter &add(const std::filesystem::path &path);
    /// Replaces all targets, once everything is on the disk. Throws FileError. To be called once, as the
    /// last.
    void commit();

    /// Removes what was not committed. For another thread, which ends the process now: whoever uses the set
    /// afterwards waits for ever.
    void abandon();

private:
    std::mutex mutex_; ///< guards files_, and the renaming
    std::vector<std::unique_ptr<FileWriter>> files_;
};

} // namespace mrpp

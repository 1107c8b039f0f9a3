#pragma once
/// \file
/// A folder of one's own that disappears with the object; and if the process is killed, with the next look
/// for such folders.

#include "framework/system/Descriptor.h"

#include <cstdint>
#include <filesystem>

namespace mrpp
{

class TemporaryFolder
{
public:
    /// Makes $TMPDIR/mrppsim-XXXXXX, and in it a locked file that says whose it is and that he lives. Throws
    /// FileError where that fails.
    TemporaryFolder();
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder &) = delete;
    TemporaryFolder &operator=(const TemporaryFolder &) = delete;

    /// Absolute.
    [[nodiscard]] const std::filesystem::path &path() const { return path_; }

private:
    std::filesystem::path path_;
    Descriptor lock_;
};

/// Removes the folders of processes that were killed: those whose lock nobody holds.
void removeStaleTemporaryFolders() noexcept;

/// Whether the file system of that folder has no room left, for bytes or for files.
[[nodiscard]] bool isFull(const std::filesystem::path &folder);

/// Bytes of all files below that folder.
[[nodiscard]] std::uintmax_t bytesIn(const std::filesystem::path &folder);

} // namespace mrpp

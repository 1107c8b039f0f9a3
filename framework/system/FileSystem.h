#pragma once
/// \file
/// What file systems offer beside reading and writing, which not all of them do: network file systems and
/// folders of another system mounted into a virtual machine lack some of it.

#include <filesystem>

namespace mrpp
{

struct FileSystemAbilities
{
    bool locks = true;        ///< of files, as fcntl() and flock() give them
    bool sharedMemory = true; ///< files that several processes map and write (mmap with MAP_SHARED)
};

/// Of the folder's file system, tried out on a file that is gone afterwards. Where no file can be made,
/// everything is taken to be there.
[[nodiscard]] FileSystemAbilities abilitiesOf(const std::filesystem::path &folder);

/// Whether `errno` says that the file system has no locks (and not that somebody holds one).
[[nodiscard]] bool saysNoLocks(int error);

/// Whether that file can be locked, without locking it; true where it cannot be opened.
[[nodiscard]] bool hasLocks(const std::filesystem::path &file);

} // namespace mrpp

#pragma once
/// \file
/// One campaign a folder at a time: a lock that the system takes back when its holder ends, however it ends.

#include <filesystem>

namespace mrpp
{

class FolderLock
{
public:
    /// Locks DIR/.lock, a file of its own: SQLite's locks on the database would be lost with it. Throws
    /// FileError where another holds the lock (naming it), or where the folder cannot be written.
    explicit FolderLock(const std::filesystem::path &folder);
    ~FolderLock();
    FolderLock(const FolderLock &) = delete;
    FolderLock &operator=(const FolderLock &) = delete;

private:
    int file_ = -1;
};

} // namespace mrpp

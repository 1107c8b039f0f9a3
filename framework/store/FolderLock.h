#pragma once
/// \file
/// One campaign a folder at a time: a lock that the system takes back when its holder ends, however it ends.

#include <filesystem>
#include <string>

namespace mrpp
{

class FolderLock
{
public:
    /// Locks DIR/.lock, a file of its own: SQLite's locks on the database would be lost with it. Throws
    /// FileError where another holds the lock (naming it), or where the folder cannot be written. Where the
    /// file system has no locks, the name in the file has to do: it keeps out processes of this host only.
    explicit FolderLock(const std::filesystem::path &folder);
    ~FolderLock();
    FolderLock(const FolderLock &) = delete;
    FolderLock &operator=(const FolderLock &) = delete;

private:
    [[noreturn]] void refuse(const std::filesystem::path &folder, const std::string &reason);

    int file_ = -1;
    bool isLock_ = true; ///< and not only a name
};

} // namespace mrpp

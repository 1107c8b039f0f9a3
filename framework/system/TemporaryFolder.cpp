#include "framework/system/TemporaryFolder.h"

#include "framework/support/Error.h"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <string>
#include <string_view>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/statvfs.h>

namespace mrpp
{

namespace
{

namespace fs = std::filesystem;

constexpr std::string_view kPrefix = "mrppsim-";
constexpr std::string_view kRandom = "XXXXXX"; // of mkdtemp
constexpr const char *kLock = ".mrppsim-lock";

fs::path parentFolder()
{
    std::error_code error;
    const fs::path parent = fs::temp_directory_path(error);
    return error ? fs::path("/tmp") : fs::absolute(parent, error);
}

/// The lock, held from now on; none, and errno says why, where another process holds it (EWOULDBLOCK), there
/// is no such file, or the file system has no locks.
Descriptor lockOf(const fs::path &folder, int flags)
{
    constexpr mode_t kOwn = 0600;
    Descriptor lock(::open((folder / kLock).c_str(), flags | O_RDWR | O_CLOEXEC | O_NOFOLLOW, kOwn));
    if (lock.number() < 0 || ::flock(lock.number(), LOCK_EX | LOCK_NB) == 0)
        return lock;
    const int reason = errno;
    lock.close();
    errno = reason;
    return lock;
}

/// Programs may leave folders in which nothing can be removed.
void removeWhole(const fs::path &folder)
{
    std::error_code error;
    fs::remove_all(folder, error);
    if (!error)
        return;
    fs::permissions(folder, fs::perms::owner_all, fs::perm_options::add, error);
    fs::recursive_directory_iterator entry(folder, fs::directory_options::skip_permission_denied, error);
    for (; !error && entry != fs::recursive_directory_iterator(); entry.increment(error))
        if (std::error_code ignored; entry->is_directory(ignored) && !entry->is_symlink(ignored))
            fs::permissions(entry->path(), fs::perms::owner_all, fs::perm_options::add, ignored);
    fs::remove_all(folder, error);
}

} // namespace

TemporaryFolder::TemporaryFolder()
{
    constexpr int kMostTries = 100; // a look for stale folders may take a new one before it is locked
    for (int i = 0; i < kMostTries; ++i)
    {
        std::string name = (parentFolder() / (std::string(kPrefix) + std::string(kRandom))).string();
        if (::mkdtemp(name.data()) == nullptr)
            throw FileError({name}, std::string("cannot make a temporary folder: ") + std::strerror(errno));
        path_ = name;
        lock_ = lockOf(path_, O_CREAT);
        const bool wasFaster = lock_.number() < 0 && (errno == EWOULDBLOCK || errno == ENOENT);
        if (std::error_code error; !wasFaster && fs::exists(path_, error))
            return; // perhaps without a lock: not every file system has them, and then nobody collects it
    }
    throw FileError({path_.string()}, "cannot make a temporary folder: others remove it");
}

TemporaryFolder::~TemporaryFolder()
{
    removeWhole(path_);
}

void removeStaleTemporaryFolders() noexcept
try
{
    std::error_code error;
    fs::directory_iterator entry(parentFolder(), error);
    for (; !error && entry != fs::directory_iterator(); entry.increment(error))
    {
        const std::string name = entry->path().filename().string();
        if (!name.starts_with(kPrefix) || name.size() != kPrefix.size() + kRandom.size())
            continue;
        struct stat status = {};
        if (::lstat(entry->path().c_str(), &status) != 0 || !S_ISDIR(status.st_mode) ||
            status.st_uid != ::geteuid())
            continue;
        if (const Descriptor lock = lockOf(entry->path(), 0); lock.number() >= 0)
            removeWhole(entry->path());
    }
}
catch (...)
{
    // Another time.
}

bool isFull(const fs::path &folder)
{
    constexpr std::uintmax_t kLittle = std::uintmax_t{64} << 10; // bytes
    struct statvfs system = {};
    if (::statvfs(folder.c_str(), &system) != 0)
        return false;
    const auto blocks = ::geteuid() == 0 ? system.f_bfree : system.f_bavail;
    return std::uintmax_t{blocks} * system.f_frsize < kLittle || (system.f_files > 0 && system.f_favail == 0);
}

std::uintmax_t bytesIn(const fs::path &folder)
{
    std::uintmax_t sum = 0;
    std::error_code error;
    fs::recursive_directory_iterator entry(folder, fs::directory_options::skip_permission_denied, error);
    for (; !error && entry != fs::recursive_directory_iterator(); entry.increment(error))
        if (std::error_code ignored; entry->is_regular_file(ignored) && !entry->is_symlink(ignored))
            sum += entry->file_size(ignored);
    return sum;
}

} // namespace mrpp

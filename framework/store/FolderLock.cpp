#include "framework/store/FolderLock.h"

#include "framework/support/Error.h"
#include "framework/system/FileSystem.h"

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <string>
#include <sys/file.h>
#include <unistd.h>

namespace mrpp
{

namespace
{

std::string nameOf(pid_t process)
{
    std::array<char, 256> host{};
    ::gethostname(host.data(), host.size() - 1);
    return "process " + std::to_string(process) + " on " + host.data();
}

std::string whoAmI()
{
    return nameOf(::getpid());
}

/// Whether that is the name of another process of this host which has not ended.
bool isAlive(const std::string &name)
{
    pid_t process = 0;
    return std::sscanf(name.c_str(), "process %d on ", &process) == 1 && name == nameOf(process) &&
           process != ::getpid() && (::kill(process, 0) == 0 || errno != ESRCH);
}

std::string contents(int file)
{
    std::array<char, 512> text{};
    const ssize_t size = ::pread(file, text.data(), text.size(), 0);
    return size > 0 ? std::string(text.data(), static_cast<std::size_t>(size)) : "another process";
}

} // namespace

FolderLock::FolderLock(const std::filesystem::path &folder)
{
    constexpr mode_t kAsTheUmaskSays = 0666;
    const std::string path = (folder / ".lock").string();
    file_ = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, kAsTheUmaskSays);
    if (file_ < 0)
        throw FileError({folder.string()},
                        std::string("the folder cannot be written: ") + std::strerror(errno));
    constexpr const char *kHeld =
        " is running a campaign in this folder; wait for its end or use another folder";
    if (::flock(file_, LOCK_EX | LOCK_NB) != 0)
    {
        if (errno == EWOULDBLOCK)
            refuse(folder, contents(file_) + kHeld);
        if (!saysNoLocks(errno))
            refuse(folder, std::string("the folder cannot be locked: ") + std::strerror(errno));
        isLock_ = false;
        if (const std::string holder = contents(file_); isAlive(holder))
            refuse(folder, holder + kHeld);
    }
    // The name is for the message above: a disk too full for it does no harm.
    const std::string name = whoAmI();
    if (::ftruncate(file_, 0) == 0 && ::pwrite(file_, name.data(), name.size(), 0) < 0)
        errno = 0;
}

void FolderLock::refuse(const std::filesystem::path &folder, const std::string &reason)
{
    ::close(file_);
    throw FileError({folder.string()}, reason);
}

FolderLock::~FolderLock()
{
    if (!isLock_ && ::ftruncate(file_, 0) != 0)
        errno = 0; // the next one sees that this process is gone
    ::close(file_);
}

} // namespace mrpp

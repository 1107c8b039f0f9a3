#include "framework/campaign/FolderLock.h"

#include "framework/support/Error.h"

#include <array>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <string>
#include <sys/file.h>
#include <unistd.h>

namespace mrpp
{

namespace
{

std::string whoAmI()
{
    std::array<char, 256> host{};
    ::gethostname(host.data(), host.size() - 1);
    return "process " + std::to_string(::getpid()) + " on " + host.data();
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
    constexpr mode_t kReadableByAll = 0644;
    const std::string path = (folder / ".lock").string();
    file_ = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, kReadableByAll);
    if (file_ < 0)
        throw FileError({folder.string()},
                        std::string("the folder cannot be written: ") + std::strerror(errno));
    if (::flock(file_, LOCK_EX | LOCK_NB) != 0)
    {
        const bool held = errno == EWOULDBLOCK;
        const std::string reason =
            held ? contents(file_) +
                       " is running a campaign in this folder; wait for its end or use another folder"
                 : std::string("the folder cannot be locked: ") + std::strerror(errno);
        ::close(file_);
        throw FileError({folder.string()}, reason);
    }
    // The name is for the message above only: a disk too full for it does no harm.
    const std::string name = whoAmI();
    if (::ftruncate(file_, 0) == 0 && ::pwrite(file_, name.data(), name.size(), 0) < 0)
        errno = 0;
}

FolderLock::~FolderLock()
{
    ::close(file_);
}

} // namespace mrpp

#include "framework/system/FileSystem.h"

#include "framework/system/Descriptor.h"

#include <cerrno>
#include <fcntl.h>
#include <string>
#include <sys/file.h>
#include <sys/mman.h>
#include <unistd.h>

namespace mrpp
{

namespace
{

constexpr std::size_t kPage = 4096;

bool mapsShared(int file)
{
    if (::ftruncate(file, kPage) != 0)
        return true; // a full disk says nothing about maps
    void *memory = ::mmap(nullptr, kPage, PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
    if (memory == MAP_FAILED)
        return false;
    ::munmap(memory, kPage);
    return true;
}

bool locks(int file, short kind)
{
    struct flock range = {};
    range.l_type = kind;
    range.l_whence = SEEK_SET;
    range.l_len = 1;
    return ::fcntl(file, F_SETLK, &range) == 0 || !saysNoLocks(errno);
}

} // namespace

bool saysNoLocks(int error)
{
    return error == ENOLCK || error == ENOSYS || error == EOPNOTSUPP || error == EINVAL;
}

bool hasLocks(const std::filesystem::path &file)
{
    const Descriptor opened(::open(file.c_str(), O_RDONLY | O_CLOEXEC));
    if (opened.number() < 0)
        return true;
    struct flock range = {};
    range.l_type = F_RDLCK;
    range.l_whence = SEEK_SET;
    range.l_len = 1;
    return ::fcntl(opened.number(), F_GETLK, &range) == 0 || !saysNoLocks(errno);
}

FileSystemAbilities abilitiesOf(const std::filesystem::path &folder)
{
    std::string name = (folder / ".mrppsim-probe-XXXXXX").string();
    const Descriptor probe(::mkostemp(name.data(), O_CLOEXEC));
    if (probe.number() < 0)
        return {};
    const FileSystemAbilities abilities{locks(probe.number(), F_WRLCK), mapsShared(probe.number())};
    ::unlink(name.c_str());
    return abilities;
}

} // namespace mrpp

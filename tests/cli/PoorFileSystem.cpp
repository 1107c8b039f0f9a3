// Preloaded into a program, makes all file systems poor: MRPP_POOR names what they lack (locks, maps, chmod).

#include <cerrno>
#include <cstdarg>
#include <cstdlib>
#include <cstring>
#include <dlfcn.h>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/mman.h>
#include <sys/stat.h>

namespace
{

bool lacks(const char *what)
{
    const char *all = std::getenv("MRPP_POOR");
    return all != nullptr && std::strstr(all, what) != nullptr;
}

template <class Function>
Function next(const char *name)
{
    return reinterpret_cast<Function>(::dlsym(RTLD_NEXT, name));
}

int refuse(int error)
{
    errno = error;
    return -1;
}

int control(const char *name, int file, int command, void *argument)
{
    if ((command == F_SETLK || command == F_SETLKW || command == F_GETLK) && lacks("locks"))
        return refuse(ENOLCK);
    return next<int (*)(int, int, ...)>(name)(file, command, argument);
}

} // namespace

extern "C"
{

    int flock(int file, int operation) noexcept
    {
        return lacks("locks") ? refuse(ENOLCK) : next<int (*)(int, int)>("flock")(file, operation);
    }

    int fcntl(int file, int command, ...)
    {
        va_list arguments;
        va_start(arguments, command);
        void *argument = va_arg(arguments, void *);
        va_end(arguments);
        return control("fcntl", file, command, argument);
    }

    int fcntl64(int file, int command, ...)
    {
        va_list arguments;
        va_start(arguments, command);
        void *argument = va_arg(arguments, void *);
        va_end(arguments);
        return control("fcntl64", file, command, argument);
    }

    void *mmap(void *where, size_t size, int rights, int flags, int file, off_t offset) noexcept
    {
        if (file >= 0 && (flags & MAP_SHARED) != 0 && (rights & PROT_WRITE) != 0 && lacks("maps"))
        {
            errno = ENODEV;
            return MAP_FAILED;
        }
        return next<void *(*)(void *, size_t, int, int, int, off_t)>("mmap")(where, size, rights, flags, file,
                                                                             offset);
    }

    void *mmap64(void *where, size_t size, int rights, int flags, int file, off64_t offset) noexcept
    {
        return mmap(where, size, rights, flags, file, offset);
    }

    int fchmod(int file, mode_t mode) noexcept
    {
        return lacks("chmod") ? refuse(EPERM) : next<int (*)(int, mode_t)>("fchmod")(file, mode);
    }

    int chmod(const char *file, mode_t mode) noexcept
    {
        return lacks("chmod") ? refuse(EPERM) : next<int (*)(const char *, mode_t)>("chmod")(file, mode);
    }

} // extern "C"

#include "framework/support/File.h"

#include "framework/support/Error.h"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <fstream>
#include <iterator>
#include <sys/stat.h>
#include <unistd.h>

namespace mrpp
{

std::string readFile(const std::filesystem::path &path)
{
    std::error_code error;
    const auto status = std::filesystem::status(path, error);
    if (status.type() == std::filesystem::file_type::not_found)
        throw FileError({path.string()}, "there is no such file");
    if (status.type() == std::filesystem::file_type::directory)
        throw FileError({path.string()}, "is a folder, but a file is needed");
    std::ifstream stream(path, std::ios::binary);
    if (!stream)
        throw FileError({path.string()}, std::string("cannot be read: ") + std::strerror(errno));
    std::string text{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
    if (stream.bad())
        throw FileError({path.string()}, "cannot be read to its end");
    return text;
}

void writeFile(const std::filesystem::path &path, std::string_view contents)
{
    const auto fail = [&path](const char *step)
    {
        throw FileError({path.string()},
                        std::string("cannot be written (") + step + "): " + std::strerror(errno));
    };

    std::error_code error;
    if (path.has_parent_path())
        std::filesystem::create_directories(path.parent_path(), error);
    std::string temporary = path.string() + ".XXXXXX";
    const int file = ::mkostemp(temporary.data(), O_CLOEXEC);
    if (file < 0)
        fail("create");
    while (!contents.empty())
    {
        const ssize_t written = ::write(file, contents.data(), contents.size());
        if (written < 0 && errno == EINTR)
            continue;
        if (written < 0)
        {
            const int reason = errno;
            ::close(file);
            ::unlink(temporary.c_str());
            errno = reason;
            fail("write");
        }
        contents.remove_prefix(static_cast<std::size_t>(written));
    }
    constexpr mode_t kReadableByAll = 0644;
    ::fchmod(file, kReadableByAll);
    const bool flushed = ::fsync(file) == 0;
    const bool closed = ::close(file) == 0;
    if (!flushed || !closed || ::rename(temporary.c_str(), path.c_str()) != 0)
    {
        const int reason = errno;
        ::unlink(temporary.c_str());
        errno = reason;
        fail("rename");
    }
}

} // namespace mrpp

#include "framework/support/File.h"

#include "framework/support/Error.h"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <fstream>
#include <iterator>
#include <sys/stat.h>
#include <unistd.h>
#include <utility>

namespace mrpp
{

namespace
{

/// Devices, pipes, and names for what is open already (/dev/stdout): they are written to and never replaced.
bool isWrittenInPlace(const std::filesystem::path &path)
{
    using enum std::filesystem::file_type;
    std::error_code error;
    const auto type = std::filesystem::status(path, error).type();
    if (type == character || type == block || type == fifo || type == socket)
        return true;
    const std::string target = std::filesystem::read_symlink(path, error).string();
    return target.starts_with("/proc/") || target.starts_with("/dev/");
}

} // namespace

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
    FileWriter writer(path);
    writer.write(contents);
    writer.commit();
}

FileWriter::FileWriter(std::filesystem::path path) : path_(std::move(path))
{
    std::error_code error;
    if (std::filesystem::is_directory(path_, error))
        throw FileError({path_.string()}, "cannot be written: it is a folder");
    if (isWrittenInPlace(path_))
    {
        file_ = ::open(path_.c_str(), O_WRONLY | O_CLOEXEC);
        if (file_ < 0)
            fail("open");
        return;
    }
    if (path_.has_parent_path())
        std::filesystem::create_directories(path_.parent_path(), error);
    std::string name = path_.string() + ".XXXXXX";
    file_ = ::mkostemp(name.data(), O_CLOEXEC);
    if (file_ < 0)
        fail("create");
    temporary_ = std::move(name);
}

FileWriter::~FileWriter()
{
    if (file_ >= 0)
        ::close(file_);
    if (!temporary_.empty())
        ::unlink(temporary_.c_str());
}

void FileWriter::write(std::string_view contents)
{
    while (!contents.empty())
    {
        const ssize_t written = ::write(file_, contents.data(), contents.size());
        if (written < 0 && errno == EINTR)
            continue;
        if (written < 0)
            fail("write");
        contents.remove_prefix(static_cast<std::size_t>(written));
    }
}

void FileWriter::finish()
{
    if (file_ < 0)
        return;
    constexpr mode_t kReadableByAll = 0644;
    const bool inPlace = temporary_.empty();
    const bool flushed = inPlace || (::fchmod(file_, kReadableByAll) == 0 && ::fsync(file_) == 0);
    const bool closed = ::close(std::exchange(file_, -1)) == 0;
    if (!flushed || !closed)
        fail("flush");
}

void FileWriter::commit()
{
    finish();
    if (temporary_.empty())
        return;
    if (::rename(temporary_.c_str(), path_.c_str()) != 0)
        fail("rename");
    temporary_.clear();
}

void FileWriter::fail(const char *step) const
{
    throw FileError({path_.string()},
                    std::string("cannot be written (") + step + "): " + std::strerror(errno));
}

FileWriter &FileSet::add(const std::filesystem::path &path)
{
    for (const auto &file : files_)
        if (file->path().lexically_normal() == path.lexically_normal())
            throw FileError({path.string()}, "is to be written twice; every file needs a name of its own");
    return *files_.emplace_back(std::make_unique<FileWriter>(path));
}

void FileSet::commit()
{
    for (const auto &file : files_)
        file->finish();
    for (const auto &file : files_)
        file->commit();
}

} // namespace mrpp

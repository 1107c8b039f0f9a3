#include "framework/system/File.h"

#include "framework/support/Error.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <ctime>
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

/// A name beside the file, no longer than names may be. \param attempt counts those that were taken
std::string temporaryName(const std::filesystem::path &path, int attempt)
{
    constexpr std::size_t kLongest = 200; // bytes, of 255 that file systems take
    std::string name = path.filename().string();
    std::size_t end = std::min(name.size(), kLongest);
    while (end > 0 && end < name.size() && (static_cast<unsigned char>(name[end]) & 0xC0U) == 0x80U)
        --end; // no character is cut in two
    name.resize(end);
    std::timespec now{};
    ::clock_gettime(CLOCK_REALTIME, &now);
    name +=
        "." + std::to_string(::getpid()) + "-" + std::to_string(now.tv_nsec) + "-" + std::to_string(attempt);
    return (path.parent_path() / name).string();
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
    constexpr mode_t kAsTheUmaskSays = 0666;
    constexpr int kMostTries = 1000; // every one of them has another name
    for (int i = 0; file_ < 0 && i < kMostTries; ++i)
    {
        temporary_ = temporaryName(path_, i);
        file_ = ::open(temporary_.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, kAsTheUmaskSays);
        if (file_ < 0 && errno != EEXIST)
            break;
    }
    if (file_ < 0)
    {
        temporary_.clear(); // it is somebody else's
        fail("create");
    }
}

FileWriter::~FileWriter()
{
    if (file_ >= 0)
        ::close(file_);
    abandon();
}

void FileWriter::abandon()
{
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
    const bool inPlace = temporary_.empty();
    const bool flushed = inPlace || ::fsync(file_) == 0;
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
    const std::lock_guard lock(mutex_);
    for (const auto &file : files_)
        if (file->path().lexically_normal() == path.lexically_normal())
            throw FileError({path.string()}, "is to be written twice; every file needs a name of its own");
    return *files_.emplace_back(std::make_unique<FileWriter>(path));
}

void FileSet::commit()
{
    for (const auto &file : files_)
        file->finish();
    const std::lock_guard lock(mutex_);
    for (const auto &file : files_)
        file->commit();
}

void FileSet::abandon()
{
    mutex_.lock(); // never to be unlocked
    for (const auto &file : files_)
        file->abandon();
}

} // namespace mrpp

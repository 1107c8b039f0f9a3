#include "framework/outside/WorkingFolder.h"

#include "framework/support/Error.h"

#include <system_error>

namespace mrpp
{

namespace
{

using std::filesystem::path;

bool isCopied(const std::filesystem::directory_entry &entry)
{
    using enum std::filesystem::perms;
    std::error_code error;
    const auto status = entry.status(error);
    return !error && std::filesystem::is_regular_file(status) &&
           (status.permissions() & (owner_exec | group_exec | others_exec)) == none &&
           entry.file_size(error) <= kLargestCopy && !error;
}

[[noreturn]] void fail(const path &file, const std::error_code &error)
{
    throw FileError({file.string()}, "cannot be made in a run's working folder: " + error.message());
}

void copyOrLink(const path &from, const path &to)
{
    std::error_code error;
    if (std::filesystem::copy_file(from, to, error))
        return;
    if (error == std::errc::no_space_on_device || error.value() == EDQUOT ||
        error == std::errc::file_too_large)
        fail(to, error);
    std::filesystem::remove(to, error); // it may not be read, or is gone: a link shows the same
    std::filesystem::create_symlink(from, to, error);
}

} // namespace

void makeWorkingFolder(const path &folder, const path &source)
{
    std::error_code error;
    std::filesystem::create_directory(folder, error);
    if (error)
        fail(folder, error);
    for (std::filesystem::directory_iterator entry(source, error), end; !error && entry != end;
         entry.increment(error))
    {
        const path shown = folder / entry->path().filename();
        if (isCopied(*entry))
        {
            copyOrLink(entry->path(), shown);
            continue;
        }
        std::error_code linking;
        std::filesystem::create_symlink(entry->path(), shown, linking);
        if (linking)
            fail(shown, linking);
    }
}

} // namespace mrpp

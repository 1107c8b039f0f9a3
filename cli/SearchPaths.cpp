#include "cli/SearchPaths.h"

#include <cstdlib>
#include <filesystem>
#include <string>
#include <string_view>

namespace mrpp
{

namespace
{

/// An empty folder is the present one, as PATH has it.
std::string absoluteFolder(std::string_view folder)
{
    std::error_code error;
    const std::filesystem::path path = folder.empty() ? "." : folder;
    const std::filesystem::path absolute = std::filesystem::absolute(path, error).lexically_normal();
    return error || path.is_absolute() ? std::string(folder) : absolute.string();
}

} // namespace

void makeSearchPathsAbsolute()
{
    if (const char *temporary = std::getenv("TMPDIR"); temporary != nullptr && *temporary != '\0')
        ::setenv("TMPDIR", absoluteFolder(temporary).c_str(), 1);
    const char *variable = std::getenv("PATH");
    if (variable == nullptr)
        return;
    std::string all;
    std::string_view rest = variable;
    for (bool more = true; more;)
    {
        const std::size_t end = rest.find(':');
        more = end != std::string_view::npos;
        all += (all.empty() ? "" : ":") + absoluteFolder(rest.substr(0, end));
        rest.remove_prefix(more ? end + 1 : rest.size());
    }
    ::setenv("PATH", all.c_str(), 1);
}

} // namespace mrpp

#pragma once
/// \file
/// A folder of one's own that disappears with the object.

#include "framework/support/Error.h"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <string>

namespace mrpp
{

class TemporaryFolder
{
public:
    /// Throws FileError where none can be made.
    TemporaryFolder()
    {
        std::error_code error;
        std::filesystem::path parent = std::filesystem::temp_directory_path(error);
        if (error)
            parent = "/tmp";
        std::string name = (parent / "mrppsim-XXXXXX").string();
        if (::mkdtemp(name.data()) == nullptr)
            throw FileError({name}, std::string("cannot make a temporary folder: ") + std::strerror(errno));
        path_ = name;
    }
    ~TemporaryFolder()
    {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    TemporaryFolder(const TemporaryFolder &) = delete;
    TemporaryFolder &operator=(const TemporaryFolder &) = delete;

    [[nodiscard]] const std::filesystem::path &path() const { return path_; }

private:
    std::filesystem::path path_;
};

} // namespace mrpp

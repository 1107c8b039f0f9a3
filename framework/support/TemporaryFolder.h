#pragma once
/// \file
/// A new empty folder in the system's place for such, which is gone with the object.

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
    /// Throws FileError.
    TemporaryFolder()
    {
        std::string name = (std::filesystem::temp_directory_path() / "mrppsim.XXXXXX").string();
        if (::mkdtemp(name.data()) == nullptr)
            throw FileError({name}, std::string("no temporary folder can be made: ") + std::strerror(errno));
        path_ = name;
    }
    ~TemporaryFolder()
    {
        std::error_code error;
        std::filesystem::remove_all(path_, error);
    }
    TemporaryFolder(const TemporaryFolder &) = delete;
    TemporaryFolder &operator=(const TemporaryFolder &) = delete;

    [[nodiscard]] const std::filesystem::path &path() const { return path_; }

private:
    std::filesystem::path path_;
};

} // namespace mrpp

#pragma once
/// \file
/// Files read whole and written atomically: to a temporary name beside the target, flushed to the disk, then
/// renamed, so that a reader or a crash never meets half a file.

#include <filesystem>
#include <string>
#include <string_view>

namespace mrpp
{

/// The file's bytes. Throws FileError where it cannot be read or is a folder.
[[nodiscard]] std::string readFile(const std::filesystem::path &path);

/// Replaces the file as a whole or not at all; makes its folder where that is missing. Throws FileError.
void writeFile(const std::filesystem::path &path, std::string_view contents);

} // namespace mrpp

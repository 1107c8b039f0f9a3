#pragma once
/// \file
/// The folder in which an outside program runs: of one run alone, so that what runs at the same time writes
/// beside it, not over it.

#include <filesystem>

namespace mrpp
{

/// Files that are larger than this, in bytes, are linked and not copied.
inline constexpr std::uintmax_t kLargestCopy = std::uintmax_t{1} << 16;

/// Makes the folder and shows in it, under the same names, everything that stands in `source` itself: files
/// as copies, so that they may be written over; programs (executable files), larger files and folders as
/// links. Costs some 20 µs a file. Throws FileError where there is no room for it.
void makeWorkingFolder(const std::filesystem::path &folder, const std::filesystem::path &source);

} // namespace mrpp

#pragma once
/// \file
/// A finished drawing in the three formats in which every figure and layout is kept.

#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace mrpp
{

/// File contents.
struct Picture
{
    std::string png;
    std::string pdf; ///< one page
    std::string svg;
};

/// Something cannot be drawn: a tool is missing or failed. Reports say so and go on without the picture.
class DrawingError : public std::runtime_error
{
public:
    using std::runtime_error::runtime_error;
};

/// Throws DrawingError unless each format begins as it has to.
void verify(const Picture &picture);

/// Writes NAME.png, NAME.pdf and NAME.svg and returns their paths. Throws FileError.
std::vector<std::filesystem::path> writePicture(const std::filesystem::path &folder, const std::string &name,
                                                const Picture &picture);

/// What writePicture() left under that name; nothing where a file is missing or damaged.
[[nodiscard]] std::optional<Picture> readPicture(const std::filesystem::path &folder,
                                                 const std::string &name);

/// Writes NOT_DRAWN.txt with one line a complaint, and returns its path; without complaints removes what an
/// earlier report left there and returns nothing. Throws FileError.
std::vector<std::filesystem::path> writeComplaints(const std::filesystem::path &folder,
                                                   const std::vector<std::string> &complaints);

} // namespace mrpp

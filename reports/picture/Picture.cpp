#include "reports/picture/Picture.h"

#include "framework/support/Error.h"
#include "framework/system/File.h"
#include "reports/picture/PdfFile.h"

namespace mrpp
{

void verify(const Picture &picture)
{
    if (!picture.png.starts_with("\x89PNG\r\n\x1a\n"))
        throw DrawingError("the drawing tool wrote no PNG");
    if (!picture.pdf.starts_with("%PDF-"))
        throw DrawingError("the drawing tool wrote no PDF");
    constexpr std::size_t kHead = 2000; // XML declaration, document type and comments come first
    if (picture.svg.substr(0, kHead).find("<svg") == std::string::npos)
        throw DrawingError("the drawing tool wrote no SVG");
}

std::vector<std::filesystem::path> writePicture(const std::filesystem::path &folder, const std::string &name,
                                                const Picture &picture)
{
    std::vector<std::filesystem::path> files;
    const auto write = [&](const char *extension, const std::string &contents)
    {
        files.push_back(folder / (name + extension));
        writeFile(files.back(), contents);
    };
    write(".png", picture.png);
    write(".pdf", picture.pdf);
    write(".svg", picture.svg);
    return files;
}

std::optional<Picture> readPicture(const std::filesystem::path &folder, const std::string &name)
{
    try
    {
        const auto read = [&](const char *extension) { return readFile(folder / (name + extension)); };
        Picture picture{read(".png"), read(".pdf"), read(".svg")};
        verify(picture);
        (void)pageSize(picture.pdf);
        return picture;
    }
    catch (const FileError &)
    {
        return std::nullopt;
    }
    catch (const DrawingError &)
    {
        return std::nullopt;
    }
}

std::vector<std::filesystem::path> writeComplaints(const std::filesystem::path &folder,
                                                   const std::vector<std::string> &complaints)
{
    const std::filesystem::path file = folder / "NOT_DRAWN.txt";
    if (complaints.empty())
    {
        std::error_code ignored;
        std::filesystem::remove(file, ignored);
        return {};
    }
    std::string text;
    for (const std::string &complaint : complaints)
        text += complaint + "\n";
    writeFile(file, text);
    return {file};
}

} // namespace mrpp

#include "reports/gnuplot/Gnuplot.h"

#include "framework/support/Error.h"
#include "framework/system/File.h"
#include "framework/system/TemporaryFolder.h"
#include "reports/gnuplot/FigureScript.h"
#include "reports/picture/PdfFile.h"
#include "reports/picture/Process.h"
#include "reports/picture/Text.h"

#include <algorithm>
#include <atomic>
#include <optional>
#include <thread>

namespace mrpp
{

Picture drawFigure(const Figure &figure)
{
    constexpr std::chrono::seconds kLimit{120};
    const TemporaryFolder folder;
    const std::string script = figure.name + ".gp";
    writeFile(folder.path() / script, gnuplotScript(figure));
    // -d: whatever the user's own start-up files say, the figure is the same.
    const ProcessResult result = runProcess({"gnuplot", "-d", script}, folder.path(), kLimit);
    if (!result.started)
        throw DrawingError("gnuplot cannot be started; install it (Debian: gnuplot-nox) to get this figure");
    if (result.timedOut)
        throw DrawingError("gnuplot did not end within two minutes");
    if (!result.succeeded())
        throw DrawingError("gnuplot failed: " + oneLine(result.output));
    try
    {
        const auto read = [&](const char *extension)
        { return readFile(folder.path() / (figure.name + extension)); };
        Picture picture{read(".png"), read(".pdf"), read(".svg")};
        verify(picture);
        picture.pdf = withoutTimes(picture.pdf);
        return picture;
    }
    catch (const FileError &error)
    {
        throw DrawingError("gnuplot wrote no picture: " + error.complaint());
    }
}

namespace
{

/// What the folder holds of this very figure; nothing where it is another one, or damaged.
std::optional<Picture> keptPicture(const Figure &figure, const std::filesystem::path &folder)
{
    try
    {
        if (readFile(folder / (figure.name + ".gp")) == gnuplotScript(figure))
            return readPicture(folder, figure.name);
    }
    catch (const FileError &)
    {
        // It has not been drawn yet.
    }
    return std::nullopt;
}

} // namespace

std::vector<DrawnFigure> drawFigures(const std::vector<Figure> &figures, const std::filesystem::path &folder)
{
    std::vector<DrawnFigure> drawn(figures.size());
    std::atomic<std::size_t> next = 0;
    const auto work = [&]
    {
        for (std::size_t i = next++; i < figures.size(); i = next++)
        {
            try
            {
                auto kept = keptPicture(figures[i], folder);
                drawn[i].isFresh = !kept;
                drawn[i].picture = kept ? std::move(*kept) : drawFigure(figures[i]);
            }
            catch (const std::exception &error)
            {
                drawn[i].missing = error.what();
            }
        }
    };
    constexpr std::size_t kMostWorkers = 4;
    const std::size_t workers = std::min(
        {kMostWorkers, figures.size(), std::size_t{std::max(1U, std::thread::hardware_concurrency())}});
    std::vector<std::jthread> threads;
    for (std::size_t i = 1; i < workers; ++i)
        threads.emplace_back(work);
    work();
    return drawn;
}

std::vector<std::filesystem::path> writeFigure(const Figure &figure, const DrawnFigure &drawn,
                                               const std::filesystem::path &folder)
{
    const std::filesystem::path script = folder / (figure.name + ".gp");
    const std::filesystem::path numbers = folder / (figure.name + ".csv");
    writeFile(numbers, figureCsv(figure));
    std::vector<std::filesystem::path> files = {script, numbers};
    if (drawn.missing.empty())
    {
        std::error_code error;
        if (drawn.isFresh)
            std::filesystem::remove(script, error); // until the pictures are whole
        for (const char *extension : {".png", ".pdf", ".svg"})
            files.push_back(folder / (figure.name + extension));
        if (drawn.isFresh)
            writePicture(folder, figure.name, drawn.picture);
        else
            return files;
    }
    writeFile(script, gnuplotScript(figure));
    return files;
}

} // namespace mrpp

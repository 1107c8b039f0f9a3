#include "reports/drawing/Gnuplot.h"

#include "framework/support/Error.h"
#include "framework/support/File.h"
#include "reports/drawing/FigureScript.h"
#include "reports/drawing/PdfFile.h"
#include "reports/drawing/Process.h"
#include "reports/drawing/TemporaryFolder.h"
#include "reports/drawing/Text.h"

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

} // namespace mrpp

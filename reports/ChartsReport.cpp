#include "reports/ChartsReport.h"

#include "framework/support/File.h"
#include "reports/drawing/CampaignFigures.h"
#include "reports/drawing/FigureScript.h"
#include "reports/drawing/Gnuplot.h"

namespace mrpp
{

std::vector<std::filesystem::path> ChartsReport::write(const ResultTable &results, const Provenance &,
                                                       const std::filesystem::path &folder) const
{
    const std::filesystem::path figures = folder / "figures";
    auto [drawn, complaints] = campaignFigures(results);
    std::vector<std::filesystem::path> files;
    const auto add = [&files](const std::vector<std::filesystem::path> &more)
    { files.insert(files.end(), more.begin(), more.end()); };
    for (const Figure &figure : drawn)
    {
        add({figures / (figure.name + ".gp"), figures / (figure.name + ".csv")});
        writeFile(figures / (figure.name + ".gp"), gnuplotScript(figure));
        writeFile(figures / (figure.name + ".csv"), figureCsv(figure));
        try
        {
            add(writePicture(figures, figure.name, drawFigure(figure)));
        }
        catch (const DrawingError &error)
        {
            complaints.push_back(figure.name + ": " + error.what());
        }
    }
    add(writeComplaints(figures, complaints));
    return files;
}

} // namespace mrpp

#include "reports/ChartsReport.h"

#include "reports/figures/CampaignFigures.h"
#include "reports/gnuplot/Gnuplot.h"

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
    const std::vector<DrawnFigure> pictures = drawFigures(drawn, figures);
    for (std::size_t i = 0; i < drawn.size(); ++i)
    {
        add(writeFigure(drawn[i], pictures[i], figures));
        if (!pictures[i].missing.empty())
            complaints.push_back(drawn[i].name + ": " + pictures[i].missing);
    }
    add(writeComplaints(figures, complaints));
    return files;
}

} // namespace mrpp

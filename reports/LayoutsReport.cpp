#include "reports/LayoutsReport.h"

#include "reports/layouts/CampaignLayouts.h"

namespace mrpp
{

std::vector<std::filesystem::path> LayoutsReport::write(const ResultTable &results, const Provenance &,
                                                        const std::filesystem::path &folder) const
{
    const std::filesystem::path layouts = folder / "layouts";
    std::vector<std::string> complaints;
    std::vector<std::filesystem::path> files;
    const auto add = [&files](const std::vector<std::filesystem::path> &more)
    { files.insert(files.end(), more.begin(), more.end()); };
    for (const LayoutPlan &plan : plannedLayouts(results))
        for (const Layout &layout : drawLayouts(results, plan, layouts))
            if (layout.missing.empty())
                add(writeLayout(layout, layouts));
            else
                complaints.push_back(layout.name + ": " + layout.missing);
    add(writeComplaints(layouts, complaints));
    return files;
}

} // namespace mrpp

#include "OneAtATime.h"
#include "Star.h"

#include "framework/Plugin.h"
#include "framework/system/File.h"

#include <set>

namespace
{

/// Gives back what it got.
class Nothing final : public mrpp::Optimizer
{
public:
    [[nodiscard]] mrpp::Solution improve(const mrpp::Instance &, mrpp::Solution solution,
                                         const mrpp::TerminationCondition &) const override
    {
        return solution;
    }
};

/// How many robots move at all.
std::optional<double> movingRobots(const mrpp::Instance &, const mrpp::Solution &solution)
{
    std::set<mrpp::Robot> moving;
    solution.forEachAction(
        [&moving](auto action)
        {
            for (const mrpp::Move &move : action)
                moving.insert(move.robot);
        });
    return static_cast<double>(moving.size());
}

/// One line: how many runs are solved.
class Headline final : public mrpp::Report
{
public:
    [[nodiscard]] std::vector<std::filesystem::path> write(const mrpp::ResultTable &results,
                                                           const mrpp::Provenance &,
                                                           const std::filesystem::path &folder) const override
    {
        std::size_t solved = 0;
        for (const mrpp::RunRecord &record : results.records())
            solved += record.solved() ? 1 : 0;
        mrpp::writeFile(folder / "headline.txt", std::to_string(solved) + " runs are solved\n");
        return {folder / "headline.txt"};
    }
};

} // namespace

MRPP_PLUGIN(catalog)
{
    catalog.planners.add<OneAtATime>("one_at_a_time", "shortest paths around everybody else");
    catalog.problems.add<Star>("star", "arms around one vertex, from whose ends robots change places");
    catalog.optimizers.add<Nothing>("nothing", "gives back what it got");
    catalog.reports.add<Headline>("headline", "headline.txt: how many runs are solved");
    catalog.metrics.push_back({.name = "moving_robots",
                               .title = "Moving robots",
                               .unit = "robots",
                               .description = "how many robots move at all",
                               .measure = movingRobots});
}

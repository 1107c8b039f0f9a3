// A plugin with one planner and one metric; see CMakeLists.txt for its variants.

#include "framework/Plugin.h"

#include "framework/campaign/RunRecord.h"

#ifndef NO_PLUGIN

namespace
{

/// Solves what is solved already.
class Stander final : public mrpp::Planner
{
public:
    Stander() : Planner({.citation = "a test", .completeFor = "robots at their goals"}) {}

    mrpp::PlannerStatus solve(const mrpp::TerminationCondition &) override
    {
        return instance().starts == instance().goals
                   ? mrpp::PlannerStatus::solved
                   : because(mrpp::PlannerStatus::gave_up, "somebody has to move");
    }
};

std::optional<double> halfLength(const mrpp::Instance &, const mrpp::Solution &solution)
{
    return static_cast<double>(solution.pathLength()) / 2;
}

} // namespace

MRPP_PLUGIN(catalog)
{
#ifdef TAKEN_NAME
    catalog.planners.add<Stander>("push_and_swap", "not the real one");
#else
    catalog.planners.add<Stander>("stander", "solves what is solved already");
    catalog.metrics.push_back({.name = "half_length", .title = "Half the length", .measure = halfLength});
#endif
}

#endif

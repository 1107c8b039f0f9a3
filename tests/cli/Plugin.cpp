// A plugin with one planner and one metric; see CMakeLists.txt for its variants.

#include "framework/Plugin.h"

#include "framework/run/RunRecord.h"

#include <cstdlib>
#include <stdexcept>
#include <string>
#include <unistd.h>

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

/// Fails in the way that the variable says.
[[maybe_unused]] std::optional<double> faulty(const mrpp::Instance &, const mrpp::Solution &)
{
    const char *way = std::getenv("MRPP_FAULT");
    if (way != nullptr && std::string(way) == "abort")
        std::abort();
    if (way != nullptr && std::string(way) == "hang")
        for (;;)
            ::pause();
    throw std::runtime_error("no such turn");
}

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
#ifdef FAULTY_METRICS
    catalog.metrics.push_back({.name = "turns", .title = "Turns", .measure = faulty});
#endif
#endif
}

#endif

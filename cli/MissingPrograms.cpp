#include "cli/MissingPrograms.h"
#include "framework/support/ReadableText.h"

#include <iostream>

namespace mrpp
{

void noteMissingPrograms(const BenchmarkPlan &plan)
{
    for (const Configured &planner : plan.planners)
        try
        {
            if (planner.command)
                checkExecutable(*planner.command);
        }
        catch (const PlanError &error)
        {
            std::cerr << "note: " << oneLine(error.what()) << '\n';
        }
}

} // namespace mrpp

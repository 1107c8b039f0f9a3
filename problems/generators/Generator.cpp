#include "problems/generators/Generator.h"

#include "framework/support/Error.h"

namespace mrpp
{

void Generator::configure(const Config &settings, const ProblemContext &context)
{
    Problem::configure(settings, context);
    try
    {
        checkParameters();
    }
    catch (const PlanError &)
    {
        throw;
    }
    catch (const InputError &error)
    {
        throw PlanError(settings.where(), error.complaint());
    }
}

void Generator::check() const
{
    if (robots() && robots()->by != RobotCount::By::occupancy)
        static_cast<void>(robotCount(*makeGraph(0)));
}

void Generator::requireSize(double size)
{
    if (size > static_cast<double>(kMaximalSize))
        throw InputError("a graph of " + formatNumber(size) + " vertices or edges; at most " +
                         std::to_string(kMaximalSize) + " can be made");
}

} // namespace mrpp

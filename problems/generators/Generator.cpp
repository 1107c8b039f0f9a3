#include "problems/generators/Generator.h"

#include "framework/Catalog.h"
#include "framework/support/Error.h"

namespace mrpp
{

void Generator::configure(const Config &settings, const ProblemContext &context)
{
    if (const std::string what = missing(); !what.empty())
        throw PlanError(settings.where(), what);
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

std::unique_ptr<Generator> makeGenerator(const Catalog &catalog, std::string_view family)
{
    const auto *entry = catalog.problems.find(family);
    auto problem = entry == nullptr ? nullptr : entry->make();
    auto *generator = dynamic_cast<Generator *>(problem.get());
    if (generator == nullptr)
        return nullptr;
    static_cast<void>(problem.release());
    return std::unique_ptr<Generator>(generator);
}

std::vector<std::string> generatorNames(const Catalog &catalog)
{
    std::vector<std::string> names;
    for (const auto &entry : catalog.problems.entries())
        if (const auto generator = makeGenerator(catalog, entry.name);
            generator && generator->missing().empty())
            names.push_back(entry.name);
    return names;
}

} // namespace mrpp

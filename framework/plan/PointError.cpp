#include "framework/plan/PointError.h"

#include "framework/Problem.h"

#include <filesystem>

namespace mrpp
{

namespace
{

std::string problemOf(const BenchmarkPlan &plan, std::size_t point)
{
    return "problem '" + plan.points[point].name + "'";
}

/// Where a file that is not there was looked for.
std::string searched(const InputError &error, const BenchmarkPlan &plan)
{
    std::error_code ignored;
    if (error.where().file.empty() || std::filesystem::exists(error.where().file, ignored))
        return "";
    std::string folders;
    for (const std::filesystem::path &folder : plan.mapFolders)
        folders += (folders.empty() ? "" : ", ") + folder.string();
    return "; a relative file is looked for in the plan's folder, then in those of 'maps:' in the plan and "
           "of "
           "--maps (" +
           (folders.empty() ? "there are none" : folders) + ")";
}

/// An error in a line of a file stays where it is.
SourceLocation placeOf(const InputError &error)
{
    return error.where().line > 0 ? error.where() : SourceLocation();
}

std::string messageOf(const InputError &error, const BenchmarkPlan &plan, std::size_t point)
{
    if (error.where().line > 0)
        return error.complaint();
    return problemOf(plan, point) + ": " + error.what() + searched(error, plan);
}

std::string settingOf(const InputError &error, const Problem &problem)
{
    for (const ParameterSet::Parameter &parameter : problem.parameters().all())
        if (!error.where().file.empty() && parameter.value() == error.where().file)
            return parameter.name;
    if (!error.where().file.empty() || !problem.robots())
        return "";
    for (const char *key : {"robots", "free", "occupancy"})
        if (RobotCount::key(key) == problem.robots()->by)
            return key;
    return "";
}

} // namespace

PointError::PointError(const InputError &error, const BenchmarkPlan &plan, std::size_t point)
    : InputError(placeOf(error), messageOf(error, plan, point)), point_(point),
      problem_(problemOf(plan, point)), setting_(settingOf(error, *plan.points[point].problem))
{}

} // namespace mrpp

#include "framework/store/WhyRun.h"

#include "framework/plan/RunKey.h"

namespace mrpp
{

namespace
{

/// All that a run depends on but its repetition, as the store would write it down now.
KeyParts partsNow(const BenchmarkPlan &plan, const RunSpec &spec, const PointIdentity &point,
                  const FileHashes &files)
{
    KeyParts parts = experimentParts(plan, spec.point, point.inputs.value_or(""));
    const KeyParts planner = plannerParts(plan.planners[spec.planner], files);
    parts.insert(parts.end(), planner.begin(), planner.end());
    return keyParts(toText(parts));
}

std::string begunBefore(std::int64_t times)
{
    return times == 1 ? "begun once before, never finished"
                      : "begun " + std::to_string(times) + " times before, never finished";
}

} // namespace

std::vector<MissingRun> missingRuns(const BenchmarkPlan &plan, const ResultStore *store)
{
    std::vector<MissingRun> missing;
    if (store == nullptr)
    {
        for (RunSpec &spec : expand(plan))
            missing.push_back({std::move(spec), "new: the folder holds no campaign yet"});
        return missing;
    }
    const auto points = identifyPoints(plan, MissingInput::refuse);
    const auto planners = identifyPlanners(plan, MissingInput::refuse);
    const auto finished = store->finishedRuns();
    const auto asked = store->askedBefore();
    const auto begun = store->unfinishedAttempts();
    for (RunSpec &spec : expand(plan))
    {
        if (finished.contains(spec.runKey))
            continue;
        std::string why;
        const auto before = asked.find(ResultStore::question(spec.caseId, plan.planners[spec.planner].name));
        if (before == asked.end())
            why = "new: no run of this planner on this case is in the folder";
        else if (before->second.empty())
            why = "changed: the run in the folder is of an older version of this program";
        else if (const auto change = differences(
                     before->second, partsNow(plan, spec, points[spec.point], *planners[spec.planner]));
                 !change.empty())
            why = "changed: " + change;
        else
            why = "new: the plan asks the same another time";
        if (const auto attempts = begun.find(spec.runKey); attempts != begun.end())
            why += "; " + begunBefore(attempts->second);
        missing.push_back({std::move(spec), std::move(why)});
    }
    return missing;
}

} // namespace mrpp

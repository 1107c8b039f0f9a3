#include "framework/run/RunIdentity.h"

namespace mrpp
{

void fillIdentity(RunRecord &record, const BenchmarkPlan &plan, const RunSpec &spec)
{
    const ProblemPoint &point = plan.points[spec.point];
    record.runKey = spec.runKey;
    record.planKey = spec.planKey;
    record.caseId = spec.caseId;
    record.model = point.model;
    record.problem = point.name;
    record.sweepVariable = point.sweepVariable;
    record.sweepValue = point.sweepValue;
    record.repetition = spec.repetition;
    record.graphSeed = spec.graphSeed;
    record.instanceSeed = spec.instanceSeed;
    record.plannerSeed = spec.plannerSeed;
    record.planner = plan.planners[spec.planner].name;
    record.motion = toString(plan.motion);
    record.rule = toString(plan.planners[spec.planner].motion);
}

} // namespace mrpp

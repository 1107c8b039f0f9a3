#include "framework/plan/Shards.h"

#include "framework/support/Random.h"

namespace mrpp
{

std::int64_t shardOf(const BenchmarkPlan &plan, const RunSpec &spec, std::int64_t shards)
{
    const ProblemPoint &point = plan.points[spec.point];
    const Seed hash = deriveSeed(spec.instanceSeed, "shard", point.model, point.settings);
    return static_cast<std::int64_t>(hash % static_cast<Seed>(shards)) + 1;
}

} // namespace mrpp

#pragma once
/// \file
/// Which part of a campaign a run belongs to, where it runs in parts.

#include "framework/plan/BenchmarkPlan.h"

#include <cstdint>

namespace mrpp
{

/// From 1 to `shards`. Shards hold whole cases, and a case stays in its shard when the plan around it
/// changes.
[[nodiscard]] std::int64_t shardOf(const BenchmarkPlan &plan, const RunSpec &spec, std::int64_t shards);

} // namespace mrpp

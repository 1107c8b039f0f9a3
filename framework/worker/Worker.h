#pragma once
/// \file
/// The inside of a worker process: carries out the runs that its campaign asks for, until the campaign goes
/// away. `mrppsim worker` calls this; so does any program of one's own whose planners should run in
/// processes of their own (Benchmark::Request::worker).

#include "framework/Catalog.h"
#include "framework/worker/WorkerMessages.h"

#include <functional>

namespace mrpp
{

/// Where a worker finds the socket to its campaign.
inline constexpr int kWorkerSocket = 3;

/// Serves runs over kWorkerSocket. The process ends with its campaign, even in the middle of a run, together
/// with everything that planners started. While a planner works, the process may grow by the plan's memory
/// limit and no more; what a planner leaves running is killed after its run.
/// \param readPlan reads the plan again
/// \return an exit code: 0 where the campaign was done, 2 where the plan or an instance could not be made
/// (the campaign was told why), 3 where there is no campaign
int serveRuns(const Catalog &catalog, const std::function<BenchmarkPlan(const PlanSource &)> &readPlan);

} // namespace mrpp

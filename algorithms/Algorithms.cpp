#include "algorithms/Algorithms.h"

#include "algorithms/PushAndSwap.h"
#include "algorithms/optimizers/RedundancyRemoval.h"

namespace mrpp
{

void registerAlgorithms(Catalog &catalog)
{
    catalog.planners.add<PushAndSwap>("push_and_swap",
                                      "push aside or swap at a junction, one robot after another");

    catalog.optimizers.add<RedundancyRemoval>(
        "redundancy_removal", "deletes a robot's walks that come back with nobody having been there");
}

} // namespace mrpp

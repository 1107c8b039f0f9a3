#include "algorithms/Algorithms.h"

#include "algorithms/Bibox.h"
#include "algorithms/BiboxTheta.h"
#include "algorithms/Mapp.h"
#include "algorithms/OneBlank.h"
#include "algorithms/PushAndRotate.h"
#include "algorithms/PushAndSpin.h"
#include "algorithms/PushAndSwap.h"
#include "algorithms/Tass.h"
#include "algorithms/optimizers/RedundancyRemoval.h"

namespace mrpp
{

void registerAlgorithms(Catalog &catalog)
{
    catalog.planners.add<Bibox>("bibox",
                                "fills handle after handle of a biconnected graph, then sorts a cycle");
    catalog.planners.add<PushAndRotate>(
        "push_and_rotate",
        "push, swap and rotate, one subgraph after another; complete with two free vertices");
    catalog.planners.add<PushAndSpin>(
        "push_and_spin", "push, and swap by turning cycles; complete with one free vertex and rotations");
    catalog.planners.add<BiboxTheta>("bibox_theta",
                                     "biconnected graphs with one free vertex: handles, then a theta graph");
    catalog.planners.add<OneBlank>("one_blank", "one free vertex: every block is a puzzle of its own");
    catalog.planners.add<PushAndSwap>("push_and_swap",
                                      "push aside or swap at a junction, one robot after another");
    catalog.planners.add<Mapp>("mapp",
                               "all at once along paths with ways around each vertex, in order of rank");
    catalog.planners.add<Tass>("tass", "trees: filled from the leaves inwards, swaps at junctions");

    catalog.optimizers.add<RedundancyRemoval>(
        "redundancy_removal", "deletes a robot's walks that come back with nobody having been there");
}

} // namespace mrpp

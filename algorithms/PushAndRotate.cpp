#include "algorithms/PushAndRotate.h"

#include "algorithms/pebble/PebbleOperations.h"

namespace mrpp
{

PushAndRotate::PushAndRotate()
    : TrailPlanner(
          {.citation = "B. de Wilde, A. W. ter Mors, C. Witteveen, Push and Rotate: a Complete Multi-agent "
                       "Pathfinding Algorithm, JAIR 51 (2014), pp. 443-492",
           .motion = MotionRule::pebble,
           .completeFor = "every instance with two free vertices or more in each component in which a robot "
                          "has to move",
           .version = 2, // 2: paths within their weights, landmarks of components
           .provesInfeasibility = true,
           .complete = true})
{}

std::optional<std::string> PushAndRotate::reasonToReject(const Instance &instance) const
{
    const Components components(*instance.graph);
    std::vector<std::size_t> robots(components.count(), 0);
    for (const Vertex start : instance.starts)
        ++robots[components.of(start)];
    for (Robot r = 0; r < instance.robotCount(); ++r)
    {
        const std::uint32_t component = components.of(instance.starts[r]);
        const std::size_t free = components.size(component) - robots[component];
        if (instance.starts[r] != instance.goals[r] && free < 2)
            return "robot " + std::to_string(r) + " has to move, but its component has " +
                   std::to_string(free) + " free " + (free == 1 ? "vertex" : "vertices") +
                   " and this planner needs two (one_blank needs one)";
    }
    return std::nullopt;
}

RestartingPlanner::Outcome PushAndRotate::start(const Run &run) const
{
    PebbleBoard board(instance());
    if (run.ptc())
        return {PlannerStatus::timeout, {}, {}};
    PebbleOperations operations(board, run.ptc);
    return runWith(board, operations, run);
}

} // namespace mrpp

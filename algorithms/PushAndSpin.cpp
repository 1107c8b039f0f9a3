#include "algorithms/PushAndSpin.h"

#include "algorithms/pebble/SpinOperations.h"

namespace mrpp
{

PushAndSpin::PushAndSpin()
    : TrailPlanner(
          {.citation = "E. T. S. Alotaibi, H. Al-Rawi, A Complete Multi-robot Path-planning Algorithm, "
                       "Autonomous Agents and Multi-Agent Systems 32 (2018), pp. 693-740",
           .motion = MotionRule::rotation,
           .completeFor = "with rotations: every instance with a free vertex in each component in which a "
                          "robot has to move, polygons aside",
           .version = 2, // 2: paths within their weights, landmarks of components
           .provesInfeasibility = true,
           .complete = true})
{}

std::optional<std::string> PushAndSpin::reasonToReject(const Instance &instance) const
{
    const Components components(*instance.graph);
    const auto shapes = componentShapes(*instance.graph, components);
    std::vector<std::size_t> robots(components.count(), 0);
    for (const Vertex start : instance.starts)
        ++robots[components.of(start)];
    for (Robot r = 0; r < instance.robotCount(); ++r)
    {
        // A full polygon can only be turned, which pushes do.
        const std::uint32_t component = components.of(instance.starts[r]);
        if (instance.starts[r] != instance.goals[r] && robots[component] == components.size(component) &&
            shapes[component] != ComponentShape::polygon)
            return "robot " + std::to_string(r) +
                   " has to move, but its component has no free vertex, and this planner needs one";
    }
    return std::nullopt;
}

RestartingPlanner::Outcome PushAndSpin::start(const Run &run) const
{
    PebbleBoard board(instance());
    if (run.ptc())
        return {PlannerStatus::timeout, {}, {}};
    SpinOperations operations(board, prepared().blocks, run.ptc);
    return runWith(board, operations, run);
}

} // namespace mrpp

#include "algorithms/pebble/BlankWalks.h"

#include <algorithm>

namespace mrpp
{

std::string describe(BlockObstacle what, const Blocks &blocks, std::uint32_t block)
{
    constexpr std::size_t kNamed = 8;
    const auto vertices = blocks.vertices(block);
    std::string names;
    for (std::size_t i = 0; i < std::min(kNamed, vertices.size()); ++i)
        names += (i == 0 ? "" : ", ") + std::to_string(vertices[i]);
    if (vertices.size() > kNamed)
        names += ", … (" + std::to_string(vertices.size()) + " vertices)";
    switch (what)
    {
    case BlockObstacle::cyclicOrder:
        return "the robots on the cycle of vertices " + names +
               " follow each other in another order than their goals, and on a cycle nobody can pass";
    case BlockObstacle::oddPermutation:
        return "the robots of the bipartite block of vertices " + names +
               " need an odd permutation, and one free vertex makes only even ones there";
    default:
        return "the robots of the block theta_0 of vertices " + names +
               " need one of the 600 permutations that one free vertex cannot make there";
    }
}

std::optional<Solution> movesOf(std::vector<Vertex> walk, std::vector<Robot> occupants,
                                const TerminationCondition &ptc)
{
    if (ptc())
        return std::nullopt;
    reduceWalk(walk);
    std::vector<Move> moves;
    for (std::size_t i = 1; i < walk.size(); ++i)
    {
        if (i % 65536 == 0 && ptc())
            return std::nullopt;
        const Robot robot = occupants[walk[i]];
        if (robot != kNoRobot)
            moves.push_back({robot, walk[i], walk[i - 1]});
        std::swap(occupants[walk[i]], occupants[walk[i - 1]]);
    }
    return Solution(std::move(moves));
}

std::vector<Robot> occupantsAtStart(const Instance &instance)
{
    std::vector<Robot> occupants(instance.graph->vertexCount(), kNoRobot);
    for (Robot r = 0; r < instance.robotCount(); ++r)
        occupants[instance.starts[r]] = r;
    return occupants;
}

} // namespace mrpp

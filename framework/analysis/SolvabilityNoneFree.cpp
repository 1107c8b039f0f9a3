/// \file
/// No free vertex, with rotations: every move turns a simple cycle, so nobody crosses a bridge, and the
/// robots of each 2-edge-connected component are permuted by the group that its simple cycles' turns
/// generate. Where the component is one cycle these are the turns. Otherwise the group is primitive (below);
/// a simple cycle that leaves out three vertices makes a primitive group hold all even permutations (Jones,
/// Primitive permutation groups containing a cycle, Bull. Aust. Math. Soc. 89, 2014). There is one from eight
/// vertices up but in one graph, whose group was computed, as were those of all smaller components
/// (tests/framework/SolvabilityTest.cpp). The turn of a cycle of even length is odd, so the group is that of
/// all permutations unless every cycle has odd length, which is where every block is an odd cycle.
///
/// Why primitive: suppose blocks of imprimitivity of s vertices, 1 < s < n. One that meets a simple cycle's
/// vertices and others is kept by its turn, so it holds the whole cycle. If some block held a whole cycle, an
/// ear that leaves the block would close with part of that cycle to a cycle that the block meets but does not
/// hold, though it has vertices outside of it. So the block of x lies within every cycle through x, with
/// equal distances along it. Hence no x is a cut vertex, and of a theta's end u only its other end can be in
/// u's block, opposite to it on all three cycles: all three paths are equally long. A vertex within one path
/// has its opposite vertices on both other paths, which is more than one block can have within every cycle.
///
/// Why one graph: where every simple cycle leaves out two vertices at most, no path of a theta has more than
/// two inner vertices; with eight vertices these are three paths of two, and any further edge would make a
/// shorter cycle. Two cycles that share a cut vertex leave out three once there are six vertices.

#include "framework/analysis/SolvabilityCase.h"

#include <algorithm>
#include <fmt/core.h>

namespace mrpp::detail
{

namespace
{

Objection crossesBridge(const SolvabilityCase &given, Robot robot)
{
    const std::vector<Vertex> path = treePath(given.blocks, given.places[robot], given.instance.goals[robot]);
    std::size_t i = 0;
    while (!given.blocks.isBridge(path[i], path[i + 1]))
        ++i;
    return fmt::format("robot {} cannot cross the bridge {}–{} to its goal {}: no vertex is free", robot,
                       path[i], path[i + 1], path.back());
}

/// \param members of one 2-edge-connected component
Objection objectToTurns(const SolvabilityCase &given, std::span<const Vertex> members)
{
    std::vector<std::uint32_t> cycles;
    for (const Vertex v : members)
        for (const std::uint32_t block : given.blocks.of(v))
            if (!given.blocks.isEdge(block))
                cycles.push_back(block);
    std::ranges::sort(cycles);
    cycles.erase(std::unique(cycles.begin(), cycles.end()), cycles.end());
    if (cycles.size() == 1 && given.blocks.isCycle(cycles[0]))
        return objectToTurning({given, aroundCycle(given.blocks.edges(cycles[0]), members.front())},
                               "on the cycle " + listed(members));
    const bool onlyOdd = std::ranges::all_of(
        cycles, [&](std::uint32_t block)
        { return given.blocks.isCycle(block) && given.blocks.vertices(block).size() % 2 != 0; });
    if (!onlyOdd || !isOdd({given, members}))
        return std::nullopt;
    return fmt::format("odd permutation on the cycles {}: all are of odd length, and no vertex is free",
                       listed(members));
}

} // namespace

Objection objectWithNoneFree(const SolvabilityCase &given, std::span<const Robot> robots,
                             std::span<const Vertex> vertices)
{
    const auto componentOf = [&](Vertex v) { return given.blocks.twoEdgeOf(v); };
    for (const Robot robot : robots)
        if (componentOf(given.places[robot]) != componentOf(given.instance.goals[robot]))
            return crossesBridge(given, robot);
    std::vector<Vertex> members(vertices.begin(), vertices.end());
    std::ranges::sort(members, [&](Vertex a, Vertex b)
                      { return std::pair(componentOf(a), a) < std::pair(componentOf(b), b); });
    for (auto first = members.begin(); first != members.end();)
    {
        const auto last = std::find_if(first, members.end(),
                                       [&](Vertex v) { return componentOf(v) != componentOf(*first); });
        const bool moved = std::any_of(first, last, [&](Vertex v) { return given.have[v] != given.want[v]; });
        if (moved)
            if (Objection objection = objectToTurns(given, {first, last}))
                return objection;
        first = last;
    }
    return std::nullopt;
}

} // namespace mrpp::detail

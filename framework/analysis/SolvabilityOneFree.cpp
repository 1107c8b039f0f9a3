/// \file
/// One free vertex, one robot at a time: with the free vertex at its goal b, robots are permuted within the
/// blocks, where a block's vertex towards b is its *entry*, the place through which the free vertex comes and
/// goes. The other vertices of a block are its own; every vertex but b is one block's own. Within a block
/// Wilson (1974) says which permutations there are: all, or all even ones where the block is bipartite; a
/// single edge none, a cycle its turns, and one graph of seven vertices, theta_0, only 120 of 720.

#include "framework/analysis/SolvabilityCase.h"

#include <algorithm>
#include <array>
#include <fmt/core.h>
#include <set>
#include <utility>

namespace mrpp::detail
{

namespace
{

/// Two vertices of degree three joined by three paths, over one, two and two vertices.
bool isThetaZero(const Blocks &blocks, std::uint32_t block)
{
    const auto vertices = blocks.vertices(block);
    const auto edges = blocks.edges(block);
    if (vertices.size() != 7 || edges.size() != 8)
        return false;
    std::array<std::size_t, 7> degree{};
    const auto index = [&](Vertex v)
    { return static_cast<std::size_t>(std::ranges::lower_bound(vertices, v) - vertices.begin()); };
    for (const auto &[a, b] : edges)
    {
        ++degree[index(a)];
        ++degree[index(b)];
    }
    // Biconnected with one edge more than vertices: two vertices joined by three paths.
    std::array<std::size_t, 7> meets{}; // how many vertices of degree three are next to a vertex
    for (const auto &[a, b] : edges)
    {
        meets[index(a)] += degree[index(b)] == 3 ? 1U : 0U;
        meets[index(b)] += degree[index(a)] == 3 ? 1U : 0U;
    }
    // One vertex lies next to both, and the two themselves do not meet: what is left are two paths of two.
    std::size_t ends = 0;
    std::size_t between = 0;
    std::size_t beside = 0;
    for (std::size_t i = 0; i < 7; ++i)
    {
        ends += degree[i] == 3 && meets[i] == 0 ? 1U : 0U;
        between += degree[i] == 2 && meets[i] == 2 ? 1U : 0U;
        beside += degree[i] == 2 && meets[i] == 1 ? 1U : 0U;
    }
    return ends == 2 && between == 1 && beside == 4;
}

/// Whether moving the free vertex about the block can lead from the one arrangement to the other; some
/// hundreds of arrangements. \param entry the free vertex
bool reachesInBlock(const SolvabilityCase &given, std::uint32_t block, Vertex entry)
{
    const auto vertices = given.blocks.vertices(block);
    const auto index = [&](Vertex v)
    { return static_cast<std::size_t>(std::ranges::lower_bound(vertices, v) - vertices.begin()); };
    using State = std::vector<Robot>; // by vertex of the block
    State start;
    State goal;
    for (const Vertex v : vertices)
    {
        start.push_back(v == entry ? kNoRobot : given.have[v]);
        goal.push_back(v == entry ? kNoRobot : given.want[v]);
    }
    std::set<State> seen = {start};
    std::vector<State> rim = {start};
    while (!rim.empty())
    {
        const State state = std::move(rim.back());
        rim.pop_back();
        if (state == goal)
            return true;
        for (const auto &[a, b] : given.blocks.edges(block))
        {
            State next = state;
            std::swap(next[index(a)], next[index(b)]);
            if ((state[index(a)] == kNoRobot || state[index(b)] == kNoRobot) && seen.insert(next).second)
                rim.push_back(std::move(next));
        }
    }
    return false;
}

class OneFree
{
public:
    /// \param freeGoal b
    OneFree(const SolvabilityCase &given, std::span<const Vertex> vertices, Vertex freeGoal)
        : given_(given), freeGoal_(freeGoal), offset_(given.blocks.position(vertices.front())),
          home_(vertices.size(), kNoBlock)
    {
        for (const Vertex v : vertices)
            if (given.blocks.parent(v) != kNoVertex)
                home(v) = given.blocks.ofEdge(v, given.blocks.parent(v));
        // Above b the way to b leads downwards.
        for (Vertex v = freeGoal; given.blocks.parent(v) != kNoVertex; v = given.blocks.parent(v))
            home(given.blocks.parent(v)) = given.blocks.ofEdge(v, given.blocks.parent(v));
        home(freeGoal) = kNoBlock;
    }

    Objection run(std::span<const Robot> robots)
    {
        for (const Robot robot : robots)
            if (home(given_.places[robot]) != home(given_.instance.goals[robot]))
                return crosses(robot);
        std::vector<std::uint32_t> blocks;
        for (const Robot robot : robots)
            if (given_.places[robot] != given_.instance.goals[robot])
                blocks.push_back(home(given_.places[robot]));
        std::ranges::sort(blocks);
        blocks.erase(std::unique(blocks.begin(), blocks.end()), blocks.end());
        for (const std::uint32_t block : blocks)
            if (Objection objection = objectTo(block))
                return objection;
        return std::nullopt;
    }

private:
    static constexpr auto kNoBlock = static_cast<std::uint32_t>(-1);

    /// The block whose own vertex v is.
    std::uint32_t &home(Vertex v) { return home_[given_.blocks.position(v) - offset_]; }

    [[nodiscard]] std::string onceFree() const
    {
        return fmt::format("once vertex {} is free as in the end", freeGoal_);
    }

    Objection crosses(Robot robot)
    {
        const Vertex place = given_.places[robot];
        const Vertex goal = given_.instance.goals[robot];
        const std::uint32_t block = home(place);
        const std::vector<Vertex> path = treePath(given_.blocks, place, goal);
        std::size_t i = 0; // the last vertex of the path in the robot's block
        while (i + 1 < path.size() && given_.blocks.ofEdge(path[i], path[i + 1]) == block)
            ++i;
        const std::string where =
            fmt::format("the block {} {}", listed(given_.blocks.vertices(block)), onceFree());
        if (path[i] == goal)
            return fmt::format(
                "robot {} cannot come to rest on the cut vertex {}, its goal: with one free vertex it "
                "stays on the other vertices of {}",
                robot, goal, where);
        return fmt::format(
            "robot {} would have to cross the cut vertex {} to reach its goal {}: with one free vertex "
            "it cannot leave {}",
            robot, path[i], goal, where);
    }

    Objection objectTo(std::uint32_t block)
    {
        const auto vertices = given_.blocks.vertices(block);
        const Vertex entry = *std::ranges::find_if(vertices, [&](Vertex v) { return home(v) != block; });
        if (given_.blocks.isCycle(block))
        {
            std::vector<Vertex> cycle = aroundCycle(given_.blocks.edges(block), entry);
            cycle.erase(cycle.begin());
            return objectToTurning({given_, cycle},
                                   fmt::format("on the cycle {} {}", listed(vertices), onceFree()));
        }
        if (isThetaZero(given_.blocks, block))
        {
            if (reachesInBlock(given_, block, entry))
                return std::nullopt;
            return fmt::format(
                "the permutation on the block {} {} is none of the 120 of 720 that one free vertex "
                "makes there: the block is theta_0",
                listed(vertices), onceFree());
        }
        if (!given_.blocks.isBipartite(block))
            return std::nullopt;
        std::vector<Vertex> own(vertices.begin(), vertices.end());
        std::erase(own, entry);
        if (!isOdd({given_, own}))
            return std::nullopt;
        return fmt::format(
            "odd permutation on the bipartite block {} {}: one free vertex makes only even ones",
            listed(vertices), onceFree());
    }

    const SolvabilityCase &given_;
    Vertex freeGoal_;
    std::size_t offset_;              ///< of the component in the preorder
    std::vector<std::uint32_t> home_; ///< by position in the component
};

} // namespace

Objection objectWithOneFree(const SolvabilityCase &given, std::span<const Robot> robots,
                            std::span<const Vertex> vertices)
{
    const auto freeGoal = std::ranges::find_if(vertices, [&](Vertex v) { return given.want[v] == kNoRobot; });
    return OneFree(given, vertices, *freeGoal).run(robots);
}

} // namespace mrpp::detail

/// \file
/// Two or more free vertices, or rotations and one or more: the robots of a subgraph are permuted at will,
/// and no robot changes its class. Where one would have to, this finds the corridor that is too long.

#include "framework/analysis/SolvabilityCase.h"

#include <algorithm>
#include <cassert>
#include <fmt/core.h>
#include <utility>

namespace mrpp::detail
{

namespace
{

/// A path over vertices of degree two from u to v, each a seed or a leaf.
struct Corridor
{
    Vertex u = kNoVertex;
    Vertex v = kNoVertex;
    std::uint32_t length = 0; ///< edges
};

/// Where two robots of different classes are neighbours, and one of its two sides: the vertices that `inside`
/// reaches without `without`.
struct Border
{
    Corridor corridor; ///< that keeps the two apart
    Vertex inside = kNoVertex;
    Vertex without = kNoVertex;
    bool isFarSide = true; ///< of the path; else it is the near one
    bool atJoin = false;   ///< `without` itself belongs to the side, too
};

class ClassObjection
{
public:
    ClassObjection(const SolvabilityCase &given, const Subgraphs &subgraphs,
                   std::span<const std::uint32_t> classes)
        : given_(given), subgraphs_(subgraphs), classes_(classes), free_(given.blocks, given.instance.goals)
    {}

    /// \param robot its place and its goal are of different classes
    [[nodiscard]] std::string explain(Robot robot, std::span<const Robot> robots)
    {
        const std::vector<Vertex> path =
            treePath(given_.blocks, given_.places[robot], given_.instance.goals[robot]);
        findNeighbours(path);
        const Border border = findBorder();
        const Corridor &corridor = border.corridor;
        const Robot other = robotThatComesBack(border, robots);
        const bool deadEnd = isLeaf(corridor.u) || isLeaf(corridor.v);
        return fmt::format(
            "robots {} and {} cannot pass each other in the {} {}–{}: it needs {} free vertices, there "
            "{} {}",
            std::min(robot, other), std::max(robot, other), deadEnd ? "dead end" : "corridor", corridor.u,
            corridor.v, need(corridor), m() == 1 ? "is" : "are", m());
    }

private:
    [[nodiscard]] std::uint32_t m() const { return free_.inComponent(near_); }
    [[nodiscard]] bool isLeaf(Vertex v) const { return given_.graph.degree(v) == 1; }

    /// Sets near_ and far_: the last robot of the first one's class on the path, and the next robot.
    void findNeighbours(std::span<const Vertex> path)
    {
        const std::uint32_t from = classes_[path.front()];
        near_ = far_ = kNoVertex;
        for (const Vertex v : path)
        {
            if (free_.isFree(v))
                continue;
            if (classes_[v] == from)
            {
                near_ = v;
                far_ = kNoVertex;
            }
            else if (far_ == kNoVertex)
            {
                far_ = v;
            }
        }
    }

    /// The corridor of an edge that is in no subgraph.
    [[nodiscard]] Corridor corridorOf(Vertex a, Vertex b) const
    {
        Corridor corridor{.u = a, .v = b, .length = 1};
        const auto extend = [&](Vertex &end, Vertex previous)
        {
            for (; given_.graph.degree(end) == 2; ++corridor.length)
            {
                const auto around = given_.graph.neighbors(end);
                previous = std::exchange(end, around[around[0] == previous ? 1 : 0]);
            }
        };
        extend(corridor.u, b);
        extend(corridor.v, a);
        if (isLeaf(corridor.u) || (!isLeaf(corridor.v) && corridor.v < corridor.u))
            std::swap(corridor.u, corridor.v);
        return corridor;
    }

    [[nodiscard]] Border findBorder() const
    {
        const std::vector<Vertex> path = treePath(given_.blocks, near_, far_);
        const auto across = [&](std::size_t i) // an edge of the path that is in no subgraph
        {
            return Border{corridorOf(path[i], path[i + 1]), path[i + 1], path[i]};
        };
        const auto subgraphAt = [&](std::size_t i) { return subgraphs_.of(path[i]); };
        if (isStuck(near_))
        {
            // In a corridor, or on a join whose free vertices the path leaves behind or goes to.
            if (subgraphAt(0) == kNoSubgraph)
                return across(0);
            const Vertex exterior = plankWithAllFree(near_);
            return path[1] == exterior ? across(0) : atJoin(near_, exterior, false);
        }
        const std::size_t last = path.size() - 1;
        if (isStuck(far_))
        {
            const bool fromItsSubgraph =
                subgraphAt(last) != kNoSubgraph &&
                (subgraphAt(last) == subgraphAt(last - 1) || subgraphAt(last) == classes_[near_]);
            return fromItsSubgraph ? atJoin(far_, plankWithAllFree(far_), true) : across(last - 1);
        }
        // Between two subgraphs: behind the near one.
        std::size_t i = last;
        while (i > 0 && subgraphAt(i) != classes_[near_])
            --i;
        return across(i);
    }

    /// A robot that no subgraph has a hold of, or not the one that it stands in.
    [[nodiscard]] bool isStuck(Vertex v) const
    {
        const bool belongs = classes_[v] < subgraphs_.count();
        return !belongs || (subgraphs_.of(v) != kNoSubgraph && subgraphs_.of(v) != classes_[v]);
    }

    [[nodiscard]] Border atJoin(Vertex join, Vertex exterior, bool isFarSide) const
    {
        return {corridorOf(join, exterior), exterior, join, isFarSide, true};
    }

    /// The first vertex of the plank of a stuck robot's join beyond which all free vertices are: its subgraph
    /// has none to move it.
    [[nodiscard]] Vertex plankWithAllFree(Vertex join) const
    {
        const auto planks = subgraphs_.planks(subgraphs_.of(join));
        const auto plank = std::ranges::find_if(
            planks, [&](const Plank &p)
            { return p.join == join && free_.beyond(join, p.exterior) == free_.inComponent(join); });
        assert(plank != planks.end());
        return plank->exterior;
    }

    /// How many free vertices let robots pass each other there however they stand.
    [[nodiscard]] std::uint32_t need(const Corridor &corridor) const
    {
        const auto extra = [&](Vertex v)
        {
            if (isLeaf(v))
                return 0U;
            return given_.rotations() && given_.blocks.inTwoEdgeComponent(v) ? 0U : 1U;
        };
        return corridor.length + extra(corridor.u) + extra(corridor.v);
    }

    /// By vertex.
    [[nodiscard]] std::vector<std::uint8_t> sideOf(const Border &border) const
    {
        std::vector<std::uint8_t> reached(given_.graph.vertexCount(), 0);
        std::vector<Vertex> stack = {border.inside};
        reached[border.inside] = 1;
        while (!stack.empty())
        {
            const Vertex v = stack.back();
            stack.pop_back();
            for (const Vertex w : given_.graph.neighbors(v))
            {
                if (w == border.without || reached[w] != 0)
                    continue;
                reached[w] = 1;
                stack.push_back(w);
            }
        }
        reached[border.without] = border.atJoin ? 1 : 0;
        return reached;
    }

    /// One that has to go from the far side to the near side. Somebody has to: as many robots stand there in
    /// the end.
    [[nodiscard]] Robot robotThatComesBack(const Border &border, std::span<const Robot> robots) const
    {
        const std::vector<std::uint8_t> side = sideOf(border);
        const auto isFar = [&](Vertex v) { return (side[v] != 0) == border.isFarSide; };
        const auto robot = std::ranges::find_if(
            robots, [&](Robot r) { return isFar(given_.places[r]) && !isFar(given_.instance.goals[r]); });
        assert(robot != robots.end());
        return *robot;
    }

    const SolvabilityCase &given_;
    const Subgraphs &subgraphs_;
    std::span<const std::uint32_t> classes_;
    FreeCounts free_;
    Vertex near_ = kNoVertex; ///< two vertices whose robots are neighbours of different classes
    Vertex far_ = kNoVertex;
};

} // namespace

Objection objectToClasses(const SolvabilityCase &given, const Subgraphs &subgraphs,
                          std::span<const std::uint32_t> classes, std::span<const Robot> robots)
{
    const auto stays = [&](Robot robot)
    { return classes[given.places[robot]] == classes[given.instance.goals[robot]]; };
    const auto robot = std::ranges::find_if_not(robots, stays);
    if (robot == robots.end())
        return std::nullopt;
    return ClassObjection(given, subgraphs, classes).explain(*robot, robots);
}

} // namespace mrpp::detail

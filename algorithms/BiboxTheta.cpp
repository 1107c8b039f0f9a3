#include "algorithms/BiboxTheta.h"

#include "algorithms/pebble/BlankWalks.h"
#include "algorithms/pebble/StampedSearch.h"
#include "framework/analysis/BreadthFirstSearch.h"

#include <algorithm>

namespace mrpp
{

namespace
{

/// Where each free vertex's content goes: to a vertex that is to be free in the end, near ones first.
void matchFree(const Graph &graph, std::span<const Robot> occupants, std::span<const char> isGoal,
               std::vector<Vertex> &targets, const TerminationCondition &ptc)
{
    std::vector<char> taken(graph.vertexCount(), 0);
    for (Vertex v = 0; v < graph.vertexCount(); ++v)
        if (occupants[v] == kNoRobot && isGoal[v] == 0)
        {
            targets[v] = v;
            taken[v] = 1;
        }
    StampedSearch search(graph.vertexCount());
    for (Vertex v = 0; v < graph.vertexCount() && !ptc(); ++v)
    {
        if (occupants[v] != kNoRobot || taken[v] != 0)
            continue;
        search.begin();
        search.visit(v, kNoVertex);
        Vertex u = search.next();
        for (; isGoal[u] != 0 || taken[u] != 0; u = search.next())
            for (const Vertex w : graph.neighbors(u))
                if (!search.visited(w))
                    search.visit(w, u);
        targets[v] = u;
        taken[u] = 1;
    }
}

/// With further free vertices on a bipartite graph, an odd permutation becomes an even one when the blank
/// changes roles with one that is an even number of steps away. Returns the blank's walk to there, whose last
/// step may be such a change.
std::vector<Vertex> changeRoles(const Graph &graph, std::span<const Robot> occupants, BlockPuzzle &puzzle)
{
    std::vector<Vertex> walk{puzzle.blank};
    BreadthFirstSearch search(graph);
    search.run(puzzle.blank);
    const auto order = search.order();
    const Vertex other =
        *std::find_if(order.begin() + 1, order.end(), [&](Vertex v) { return occupants[v] == kNoRobot; });
    if (search.distance(other) % 2 != 0)
    {
        const auto neighbors = graph.neighbors(puzzle.blank);
        walk.push_back(search.distance(other) > 1 ? search.path(other)[1]
                       : neighbors[0] == other    ? neighbors[1]
                                                  : neighbors[0]);
        std::swap(puzzle.targets[walk[0]], puzzle.targets[walk[1]]);
    }
    std::swap(puzzle.targets[walk.back()], puzzle.targets[other]);
    puzzle.blank = other;
    return walk;
}

} // namespace

BiboxTheta::BiboxTheta()
    : RestartingPlanner(
          {.citation = "P. Surynek, An Application of Pebble Motion on Graphs to Abstract Multi-robot Path "
                       "Planning, ICTAI 2009, pp. 151-158",
           .motion = MotionRule::pebble,
           .completeFor = "biconnected graphs that are no cycles, with one free vertex or more",
           .provesInfeasibility = true,
           .complete = true})
{
    declareParam("core_size", coreSize_, "0:9",
                 "cores of at most so many vertices are solved by search, shortest moves first");
}

std::optional<std::string> BiboxTheta::reasonToReject(const Instance &instance) const
{
    const Graph &graph = *instance.graph;
    if (graph.vertexCount() < 3)
        return "a biconnected graph has three vertices or more";
    const Blocks blocks(graph);
    for (Vertex v = 0; v < graph.vertexCount(); ++v)
        if (blocks.isCutVertex(v))
            return "the graph is not biconnected: taking vertex " + std::to_string(v) + " away parts it";
    if (blocks.count() != 1 || blocks.vertices(0).size() != graph.vertexCount())
        return "the graph is not connected";
    if (blocks.isCycle(0))
        return "the graph is a cycle, on which nobody can pass; one_blank or push_and_rotate takes it";
    if (instance.freeCount() == 0)
        return "no vertex is free";
    if (instance.freeCount() > 1 && isThetaZero(graph))
        return "theta_0 with more than one free vertex; bibox takes it";
    return std::nullopt;
}

void BiboxTheta::clear()
{
    RestartingPlanner::clear();
    block_.reset();
    blocks_.reset();
}

void BiboxTheta::setup()
{
    blocks_ = std::make_unique<const Blocks>(graph());
    block_ = std::make_unique<const PreparedBlock>(*blocks_, 0);
}

RestartingPlanner::Outcome BiboxTheta::attempt(std::uint64_t number, const TerminationCondition &ptc) const
{
    const auto stopped = [] { return Outcome{PlannerStatus::timeout, "", {}}; };
    if (instance().starts == instance().goals)
        return {PlannerStatus::solved, "", {}};
    if (ptc())
        return stopped();
    // Numbered by chance in all attempts but the first.
    std::optional<PreparedBlock> shuffled;
    if (number > 0 && graph().vertexCount() <= kMostShuffled)
        shuffled.emplace(*blocks_, 0, attemptSeed(number));
    const PreparedBlock &block = shuffled ? *shuffled : *block_;
    std::vector<Vertex> names(block.vertices.size());
    for (Vertex i = 0; i < names.size(); ++i)
        names[block.vertices[i]] = i;
    std::vector<Robot> occupants(names.size(), kNoRobot);
    std::vector<char> isGoal(names.size(), 0);
    BlockPuzzle puzzle{&block, std::vector<Vertex>(names.size()), 0};
    for (Robot r = 0; r < instance().robotCount(); ++r)
    {
        occupants[names[instance().starts[r]]] = r;
        isGoal[names[instance().goals[r]]] = 1;
        puzzle.targets[names[instance().starts[r]]] = names[instance().goals[r]];
    }
    matchFree(*block.graph, occupants, isGoal, puzzle.targets, ptc);
    if (ptc())
        return stopped();
    while (occupants[puzzle.blank] != kNoRobot)
        ++puzzle.blank;

    if (ptc())
        return stopped();
    std::vector<Vertex> walk;
    BlockObstacle what = obstacle(puzzle, ptc);
    if (ptc())
        return stopped();
    if (what != BlockObstacle::none && instance().freeCount() > 1)
    {
        walk = changeRoles(*block.graph, occupants, puzzle);
        if (ptc())
            return stopped();
        what = obstacle(puzzle, ptc);
        if (ptc())
            return stopped();
        assert(what == BlockObstacle::none);
    }
    if (what != BlockObstacle::none)
        return {PlannerStatus::infeasible, describe(what, *blocks_, 0), {}};
    if (ptc())
        return stopped();
    const auto rest = solveBlock(puzzle, static_cast<std::size_t>(coreSize_), ptc);
    if (!rest)
        return stopped();
    walk.insert(walk.end(), rest->begin(), rest->end());
    for (Vertex &v : walk)
        v = block.vertices[v];
    auto solution = movesOf(std::move(walk), occupantsAtStart(instance()), ptc);
    if (!solution)
        return stopped();
    return {PlannerStatus::solved, "", std::move(*solution)};
}

} // namespace mrpp

#include "algorithms/Bibox.h"

#include "algorithms/bibox/Carrier.h"
#include "algorithms/bibox/CycleSorter.h"
#include "algorithms/bibox/HandleFiller.h"
#include "framework/analysis/Blocks.h"

#include <algorithm>
#include <utility>

namespace mrpp
{

namespace
{

/// Moves robots (that is, goals) until `count` vertices of the first cycle are free, each time by a shortest
/// path from a free vertex elsewhere. False where the termination condition came first.
bool freeTheCycle(PebbleBoard &goals, const EarDecomposition &ears, std::size_t count,
                  const TerminationCondition &ptc)
{
    const Graph &graph = goals.graph();
    std::size_t free = 0;
    for (const Vertex v : ears.cycle())
        free += goals.isFree(v) ? 1 : 0;
    StampedSearch search(graph.vertexCount());
    for (; free < count; ++free)
    {
        if (ptc())
            return false;
        search.begin();
        for (const Vertex v : ears.cycle())
            if (!goals.isFree(v))
                search.visit(v, kNoVertex);
        Vertex hole = kNoVertex;
        while (hole == kNoVertex)
        {
            const Vertex u = search.next();
            if (goals.isFree(u) && ears.level(u) > 0)
                hole = u;
            for (const Vertex w : graph.neighbors(u))
                if (!search.visited(w))
                    search.visit(w, u);
        }
        for (Vertex behind = search.parent(hole); behind != kNoVertex; behind = search.parent(hole))
        {
            if (!goals.isFree(behind))
                goals.move(goals.occupant(behind), hole);
            hole = behind;
        }
    }
    return true;
}

/// \param random for other choices that are about as good; null: the best
RestartingPlanner::Outcome solveWith(const Instance &instance, const EarDecomposition &ears, Random *random,
                                     const TerminationCondition &ptc)
{
    PebbleBoard goals({instance.graph, instance.goals, {}});
    if (!freeTheCycle(goals, ears, std::min(instance.freeCount(), ears.cycle().size()), ptc))
        return {PlannerStatus::timeout, {}, {}};
    std::vector<Robot> goalRobots(instance.graph->vertexCount());
    for (Vertex v = 0; v < goalRobots.size(); ++v)
        goalRobots[v] = goals.occupant(v);

    PebbleBoard board(instance);
    OpenGraph open(*instance.graph, ears);
    Carrier carrier(board, open, ptc);
    HandleFiller filler(carrier, goalRobots, random);
    for (std::size_t i = ears.handleCount(); i-- > 0;)
        if (ptc() || !filler.fill(i))
            return {PlannerStatus::timeout, {}, {}};
    if (!CycleSorter(carrier, goalRobots).sort())
        return {PlannerStatus::timeout, {}, {}};
    const auto finish = goals.moves();
    for (std::size_t i = finish.size(); i-- > 0;)
        board.move(finish[i].robot, finish[i].from);
    return {PlannerStatus::solved, {}, board.takeSolution()};
}

} // namespace

Bibox::Bibox()
    : RestartingPlanner(
          {.citation = "P. Surynek, A Novel Approach to Path Planning for Multiple Robots in "
                       "Bi-connected Graphs, ICRA 2009, pp. 3613-3619",
           .motion = MotionRule::pebble,
           .completeFor = "biconnected graphs that are no cycle, with two or more free vertices",
           .provesInfeasibility = false,
           .complete = true})
{
    declareParam("handles", handles_, "shortest,depth_first",
                 "how the graph is taken apart: always the shortest handle, or as a depth-first search meets "
                 "them");
}

std::optional<std::string> Bibox::reasonToReject(const Instance &instance) const
{
    const Graph &graph = *instance.graph;
    if (graph.vertexCount() < 3)
        return "BIBOX needs a biconnected graph, and this one has " + std::to_string(graph.vertexCount()) +
               " vertices";
    const Blocks blocks(graph);
    for (Vertex v = 0; v < graph.vertexCount(); ++v)
    {
        if (blocks.root(v) != 0)
            return "the graph is not connected: no path leads from vertex 0 to vertex " + std::to_string(v);
        if (blocks.isCutVertex(v))
            return "the graph is not biconnected: vertex " + std::to_string(v) + " is a cut vertex";
    }
    if (blocks.isCycle(0))
        return "the graph is a cycle, on which no robot can pass another";
    if (instance.freeCount() < 2)
        return "BIBOX needs two free vertices, and there are " + std::to_string(instance.freeCount()) +
               "; with one, see bibox_theta";
    return std::nullopt;
}

void Bibox::clear()
{
    Planner::clear();
    ears_.reset();
}

void Bibox::setup()
{
    ears_ = std::make_unique<const EarDecomposition>(decompose(0));
}

/// Others grow from the short cycle or from one through any vertex, with ties broken by chance.
EarDecomposition Bibox::decompose(std::uint64_t number) const
{
    const auto growth =
        handles_ == "shortest" ? EarDecomposition::Growth::shortest : EarDecomposition::Growth::depthFirst;
    if (number == 0)
        return {graph(), shortCycle(graph()), growth};
    Random random(deriveSeed(attemptSeed(number), "handles"));
    std::vector<Vertex> cycle(ears_->cycle().begin(), ears_->cycle().end());
    if (random.below(2) == 0)
        cycle = shortestCycleThrough(graph(), static_cast<Vertex>(random.below(graph().vertexCount())));
    return {graph(), cycle, growth, random.bits()};
}

RestartingPlanner::Outcome Bibox::attempt(std::uint64_t number, const TerminationCondition &ptc) const
{
    if (instance().starts == instance().goals)
        return {PlannerStatus::solved, {}, {}};
    if (number == 0)
        return solveWith(instance(), *ears_, nullptr, ptc);
    // Decomposing a larger graph could take longer than planners may go on without looking at the clock.
    constexpr std::size_t kQuicklyDecomposed = 20'000; // vertices
    std::optional<EarDecomposition> others;
    if (graph().vertexCount() <= kQuicklyDecomposed)
        others.emplace(decompose(number));
    const EarDecomposition &ears = others ? *others : *ears_;
    Random random(deriveSeed(attemptSeed(number), "ends"));
    if (random.below(2) == 0)
        return solveWith(instance(), ears, &random, ptc);
    // The way back from the goals to the starts, backwards.
    Outcome back = solveWith({instance().graph, instance().goals, instance().starts}, ears, &random, ptc);
    std::vector<Move> moves = std::move(back.solution).releaseMoves();
    std::reverse(moves.begin(), moves.end());
    for (Move &move : moves)
        std::swap(move.from, move.to);
    return {back.status, {}, Solution(std::move(moves))};
}

} // namespace mrpp

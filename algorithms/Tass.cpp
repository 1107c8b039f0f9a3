#include "algorithms/Tass.h"

#include "algorithms/pebble/PebbleOperations.h"
#include "framework/analysis/Blocks.h"
#include "framework/analysis/BreadthFirstSearch.h"
#include "framework/analysis/Subgraphs.h"

#include <algorithm>
#include <queue>
#include <string>
#include <tuple>

namespace mrpp
{

namespace
{

/// The middle of a longest path. \pre the graph is a tree of one vertex or more
Vertex center(BreadthFirstSearch &search)
{
    search.run(0);
    search.run(search.order().back());
    const std::vector<Vertex> longest = search.path(search.order().back());
    return longest[longest.size() / 2];
}

/// The tree, hung up at its centre, and what is left of it.
class Rest
{
public:
    /// \param random breaks ties between leaves; null: the numbers of the vertices do
    Rest(const Instance &instance, Random *random)
        : graph_(*instance.graph), robots_(graph_.vertexCount(), kNoRobot), parents_(graph_.vertexCount()),
          depths_(graph_.vertexCount()), ties_(graph_.vertexCount()), degrees_(graph_.vertexCount()),
          gone_(graph_.vertexCount(), 0)
    {
        for (Robot r = 0; r < instance.robotCount(); ++r)
            robots_[instance.goals[r]] = r;
        BreadthFirstSearch search(graph_);
        search.run(center(search));
        for (const Vertex v : search.order())
        {
            depths_[v] = search.distance(v);
            ties_[v] = random == nullptr ? v : random->bits() >> 1;
            degrees_[v] = static_cast<std::uint32_t>(graph_.degree(v));
            parents_[v] = kNoVertex;
            for (const Vertex w : graph_.neighbors(v))
                if (search.distance(w) < depths_[v])
                    parents_[v] = w;
            if (degrees_[v] <= 1)
                offer(v);
        }
    }

    /// The leaf to be settled next: goals before others, deep ones first; kNoVertex when nothing is left.
    [[nodiscard]] Vertex nextLeaf() const { return leaves_.empty() ? kNoVertex : std::get<3>(leaves_.top()); }
    /// The robot whose goal a vertex is, or kNoRobot.
    [[nodiscard]] Robot robotFor(Vertex v) const { return robots_[v]; }
    [[nodiscard]] bool isGone(Vertex v) const { return gone_[v] != 0; }

    /// Takes the leaf nextLeaf() away.
    void removeLeaf()
    {
        const Vertex leaf = nextLeaf();
        leaves_.pop();
        gone_[leaf] = 1;
        for (const Vertex w : graph_.neighbors(leaf))
            if (!isGone(w) && --degrees_[w] == 1)
                offer(w);
    }

    /// The path between two vertices, both included. O(its length).
    void findPath(Vertex from, Vertex to, std::vector<Vertex> &path)
    {
        path.clear();
        tail_.clear();
        while (from != to)
        {
            Vertex &deeper = depths_[from] >= depths_[to] ? from : to;
            (&deeper == &from ? path : tail_).push_back(deeper);
            deeper = parents_[deeper];
        }
        path.push_back(from);
        path.insert(path.end(), tail_.rbegin(), tail_.rend());
    }

private:
    /// Is it a goal, how deep, tie-break, the vertex.
    using Leaf = std::tuple<bool, std::uint32_t, std::uint64_t, Vertex>;

    void offer(Vertex v) { leaves_.emplace(robots_[v] != kNoRobot, depths_[v], ties_[v], v); }

    const Graph &graph_;
    std::vector<Robot> robots_;          ///< whose goal a vertex is; size V, as all below
    std::vector<Vertex> parents_;        ///< towards the centre
    std::vector<std::uint32_t> depths_;  ///< edges to the centre
    std::vector<std::uint64_t> ties_;    ///< larger ones first
    std::vector<std::uint32_t> degrees_; ///< neighbours that are not gone
    std::vector<char> gone_;
    std::priority_queue<Leaf> leaves_;
    std::vector<Vertex> tail_;
};

class Attempt
{
public:
    Attempt(const Instance &instance, Random *random, const TerminationCondition &ptc)
        : instance_(instance), ptc_(ptc), board_(instance), operations_(board_, ptc), rest_(instance, random),
          search_(instance.graph->vertexCount())
    {
        operations_.setRandom(random);
    }

    RestartingPlanner::Outcome run()
    {
        const Blocks blocks(board_.graph());
        const Subgraphs subgraphs(board_.graph(), blocks, MotionRule::pebble, instance_.starts);
        const std::vector<std::uint32_t> assignment = subgraphs.assignment(instance_.starts);
        operations_.restrictSwaps(subgraphs, assignment);
        for (Vertex leaf = rest_.nextLeaf(); leaf != kNoVertex; leaf = rest_.nextLeaf())
        {
            if (ptc_())
                return {PlannerStatus::timeout, {}, {}};
            const Robot r = rest_.robotFor(leaf);
            if (r == kNoRobot)
                clearVertex(leaf, kNoVertex);
            else if (!travel(r, leaf))
                return ptc_() ? RestartingPlanner::Outcome{PlannerStatus::timeout, {}, {}}
                              : RestartingPlanner::Outcome{PlannerStatus::infeasible, reason_, {}};
            rest_.removeLeaf();
        }
        return {PlannerStatus::solved, {}, board_.takeSolution()};
    }

private:
    /// Brings r to its goal, a leaf of the rest, through the rest.
    bool travel(Robot r, Vertex goal)
    {
        rest_.findPath(board_.position(r), goal, path_);
        for (std::size_t i = 1; i < path_.size(); ++i)
        {
            const Vertex v = path_[i];
            if (clearVertex(v, board_.position(r)))
            {
                board_.move(r, v);
                continue;
            }
            const Robot s = board_.occupant(v);
            if (ptc_() || !operations_.swap(r, s))
            {
                reason_ = "robot " + std::to_string(r) + " on vertex " + std::to_string(path_[i - 1]) +
                          " has to pass robot " + std::to_string(s) + " on vertex " + std::to_string(v) +
                          " on the way to its goal " + std::to_string(goal) +
                          ", and there are too few free vertices for these two to exchange places";
                return false;
            }
        }
        return true;
    }

    /// *Push* within the rest: whoever stands on v, and those in the way, go one vertex each towards the
    /// nearest free vertex. False where there is none on this side of `closed`.
    bool clearVertex(Vertex v, Vertex closed)
    {
        search_.begin();
        search_.visit(v, kNoVertex);
        while (!search_.done())
        {
            const Vertex u = search_.next();
            if (!board_.isFree(u))
            {
                for (const Vertex w : board_.graph().neighbors(u))
                    if (w != closed && !rest_.isGone(w) && !search_.visited(w))
                        search_.visit(w, u);
                continue;
            }
            for (Vertex hole = u; hole != v;)
            {
                const Vertex behind = search_.parent(hole);
                board_.move(board_.occupant(behind), hole);
                hole = behind;
            }
            return true;
        }
        return false;
    }

    const Instance &instance_;
    const TerminationCondition &ptc_;
    PebbleBoard board_;
    PebbleOperations operations_;
    Rest rest_;
    StampedSearch search_;
    std::vector<Vertex> path_;
    std::string reason_;
};

} // namespace

Tass::Tass()
    : RestartingPlanner(
          {.citation =
               "M. M. Khorshid, R. C. Holte, N. R. Sturtevant, A Polynomial-Time Algorithm for Non-Optimal "
               "Multi-Agent Pathfinding, SoCS 2011",
           .motion = MotionRule::pebble,
           .completeFor = "trees with at least two free vertices",
           .provesInfeasibility = true,
           .complete = true})
{}

std::optional<std::string> Tass::reasonToReject(const Instance &instance) const
{
    const Graph &graph = *instance.graph;
    if (instance.freeCount() < 2)
        return "has fewer than two free vertices";
    // A breadth-first search reaches every vertex, and every edge but one a vertex leads to its parent.
    BreadthFirstSearch search(graph);
    search.run(0);
    if (search.order().size() < graph.vertexCount())
        return "is no tree: it is not connected";
    if (graph.edgeCount() == graph.vertexCount() - 1)
        return std::nullopt;
    for (const Vertex v : search.order())
    {
        std::size_t parents = 0;
        for (const Vertex w : graph.neighbors(v))
        {
            if (search.distance(w) > search.distance(v))
                continue;
            if (search.distance(w) == search.distance(v) || ++parents == 2)
                return "is no tree: the edge " + std::to_string(v) + "–" + std::to_string(w) +
                       " closes a cycle";
        }
    }
    return std::nullopt;
}

RestartingPlanner::Outcome Tass::attempt(std::uint64_t number, const TerminationCondition &ptc) const
{
    Random random(attemptSeed(number));
    return Attempt(instance(), number == 0 ? nullptr : &random, ptc).run();
}

} // namespace mrpp

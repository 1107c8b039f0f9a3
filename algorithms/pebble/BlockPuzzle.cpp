#include "algorithms/pebble/BlockPuzzle.h"

#include "algorithms/pebble/BlankOperations.h"
#include "algorithms/pebble/SmallPuzzle.h"
#include "algorithms/pebble/ThetaStage.h"
#include "framework/analysis/BreadthFirstSearch.h"
#include "framework/analysis/EarDecomposition.h"

#include <algorithm>
#include <numeric>

namespace mrpp
{

namespace
{

bool isCycle(const Graph &graph)
{
    return graph.edgeCount() == graph.vertexCount() && graph.vertexCount() >= 3;
}

std::vector<Vertex> allVertices(const Graph &graph)
{
    std::vector<Vertex> vertices(graph.vertexCount());
    std::iota(vertices.begin(), vertices.end(), 0);
    return vertices;
}

/// A cycle, from the blank on, and how many steps forward the blank has to make along it: fewer than
/// n (n − 1), which are as good as none. Nothing where the robots' cyclic order is not the wanted one.
struct CycleTurn
{
    std::vector<Vertex> cycle;
    std::optional<std::size_t> steps;
};

/// Every full turn of the blank, n steps, shifts the n − 1 robots by one place against it.
CycleTurn cycleTurn(const BlockPuzzle &puzzle)
{
    const Graph &graph = *puzzle.block->graph;
    const std::size_t n = graph.vertexCount();
    CycleTurn turn;
    if (n < 3)
        return turn;
    turn.cycle = {puzzle.blank, graph.neighbors(puzzle.blank)[0]};
    while (turn.cycle.size() < n)
    {
        const auto next = graph.neighbors(turn.cycle.back());
        turn.cycle.push_back(next[0] == turn.cycle[turn.cycle.size() - 2] ? next[1] : next[0]);
    }
    std::vector<std::size_t> place(n);
    for (std::size_t i = 0; i < n; ++i)
        place[turn.cycle[i]] = i;
    // How many robots are to stand between the blank's target and the target of the i-th.
    const std::size_t gap = place[puzzle.targets[puzzle.blank]];
    const auto rank = [&](std::size_t i) { return (place[puzzle.targets[turn.cycle[i]]] + n - gap - 1) % n; };
    for (std::size_t i = 1; i < n; ++i)
        if (rank(i) != (rank(1) + i - 1) % (n - 1))
            return turn;
    const std::size_t turns = (2 * (n - 1) - rank(1) - gap % (n - 1)) % (n - 1);
    turn.steps = gap + n * turns;
    return turn;
}

/// The shortest walk around a cycle.
std::optional<std::vector<Vertex>> solveCycle(const BlockPuzzle &puzzle, const TerminationCondition &ptc)
{
    const auto [cycle, steps] = cycleTurn(puzzle);
    assert(steps);
    const std::size_t n = cycle.size();
    const std::size_t back = n * (n - 1) - *steps;
    std::vector<Vertex> walk{puzzle.blank};
    for (std::size_t i = 1; i <= std::min(*steps, back); ++i)
    {
        if (i % n == 0 && ptc())
            return std::nullopt;
        walk.push_back(cycle[*steps <= back ? i % n : (n - i % n) % n]);
    }
    return walk;
}

/// A short cycle of odd length. \pre not bipartite
std::vector<Vertex> shortOddCycle(const Graph &graph)
{
    constexpr std::size_t kWork = 3'000'000; // vertices and edges looked at, once there is some cycle
    std::vector<Vertex> best;
    BreadthFirstSearch search(graph);
    std::size_t work = 0;
    for (Vertex source = 0; source < graph.vertexCount() && best.size() != 3; ++source)
    {
        work += graph.vertexCount() + graph.edgeCount();
        if (!best.empty() && work > kWork)
            break;
        search.run(source);
        for (const Vertex u : search.order())
        {
            if (!best.empty() && 2 * std::size_t{search.distance(u)} + 1 >= best.size())
                break;
            const auto neighbors = graph.neighbors(u);
            const auto level =
                std::find_if(neighbors.begin(), neighbors.end(),
                             [&](Vertex w) { return search.distance(w) == search.distance(u); });
            if (level == neighbors.end())
                continue;
            // The two paths from the source part somewhere; from there on they are a cycle.
            std::vector<Vertex> first = search.path(u);
            std::vector<Vertex> second = search.path(*level);
            std::size_t common = 0;
            while (common + 1 < first.size() && first[common + 1] == second[common + 1])
                ++common;
            best.assign(first.begin() + static_cast<std::ptrdiff_t>(common), first.end());
            best.insert(best.end(), second.rbegin(), second.rend() - static_cast<std::ptrdiff_t>(common) - 1);
            break;
        }
    }
    return best;
}

/// The cycle and a handle as a theta graph.
ThetaGraph theta(std::vector<Vertex> cycle, const Handle &handle)
{
    std::rotate(cycle.begin(), std::find(cycle.begin(), cycle.end(), handle.x), cycle.end());
    const auto y = std::find(cycle.begin(), cycle.end(), handle.y);
    ThetaGraph theta;
    theta.p = handle.x;
    theta.q = handle.y;
    theta.arms[0].assign(cycle.begin() + 1, y);
    theta.arms[1].assign(std::make_reverse_iterator(cycle.end()), std::make_reverse_iterator(y + 1));
    theta.arms[2] = handle.inner;
    return theta;
}

/// Where the cycle and the first handle are theta_0 and the second handle is long: another cycle of five
/// vertices and other handles, the first of which has three inner vertices or more.
void avoidThetaZero(std::vector<Vertex> &cycle, std::vector<Handle> &handles)
{
    ThetaGraph zero = theta(cycle, handles[0]);
    auto &arms = zero.arms;
    // The arm of one inner vertex comes first.
    for (std::size_t i : {1U, 2U})
        if (arms[i].size() == 1)
            arms[0].swap(arms[i]);
    Handle second = handles[1];
    const auto isOn = [](const std::vector<Vertex> &arm, Vertex v)
    { return std::find(arm.begin(), arm.end(), v) != arm.end(); };
    const auto isTouched = [&](const std::vector<Vertex> &arm)
    { return isOn(arm, second.x) || isOn(arm, second.y); };
    if (!isTouched(arms[1]))
        arms[1].swap(arms[2]);
    cycle.assign({zero.p});
    cycle.insert(cycle.end(), arms[0].begin(), arms[0].end());
    cycle.push_back(zero.q);
    cycle.insert(cycle.end(), arms[1].rbegin(), arms[1].rend());

    if (!isTouched(arms[2]))
    {
        handles[0] = second;
        handles[1] = {zero.p, arms[2], zero.q};
        return;
    }
    // The second handle goes from one long arm to the other: the one is cut where it comes in.
    if (isOn(arms[1], second.x))
        second = {second.y, {second.inner.rbegin(), second.inner.rend()}, second.x};
    const bool nearP = arms[2].front() == second.x;
    Handle rest{second.x, {nearP ? arms[2].back() : arms[2].front()}, nearP ? zero.q : zero.p};
    second.inner.insert(second.inner.begin(), second.x);
    second.x = nearP ? zero.p : zero.q;
    handles[0] = second;
    handles[1] = std::move(rest);
}

class BlockSolver
{
public:
    BlockSolver(const BlockPuzzle &puzzle, std::size_t largestSearch, const TerminationCondition &ptc)
        : graph_(*puzzle.block->graph), largestSearch_(largestSearch), ptc_(ptc), cycle_(puzzle.block->cycle),
          handles_(&puzzle.block->handles), board_(graph_, puzzle.targets, puzzle.blank),
          operations_(board_, ptc), search_(graph_)
    {}

    std::optional<std::vector<Vertex>> solve()
    {
        if (ptc_())
            return std::nullopt;
        search_.run(board_.blankTarget());
        if (ptc_())
            return std::nullopt;
        chooseCore();
        moveHome();
        if (ptc_())
            return std::nullopt;
        for (std::size_t i = handles_->size(); i-- > coreHandles_;)
        {
            if (!operations_.fill((*handles_)[i]))
                return std::nullopt;
            for (const Vertex v : (*handles_)[i].inner)
                operations_.lock(v);
        }
        if (!solveCore())
            return std::nullopt;
        for (std::size_t i = wayHome_.size() - 1; i-- > 0;)
            board_.step(wayHome_[i]);
        if (ptc_())
            return std::nullopt;
        std::vector<Vertex> walk = board_.takeWalk();
        reduceWalk(walk);
        return walk;
    }

private:
    void chooseCore()
    {
        if (graph_.vertexCount() <= largestSearch_ || isThetaZero(graph_))
        {
            core_ = allVertices(graph_);
            coreHandles_ = handles_->size();
            return;
        }
        takeCore();
        if (coreHandles_ != 1 || core_.size() != 7 || !isThetaZero(*coreGraph()))
            return;
        if (core_.size() + (*handles_)[1].inner.size() > kSmallPuzzle)
        {
            changedHandles_ = *handles_;
            handles_ = &changedHandles_;
            avoidThetaZero(cycle_, changedHandles_);
            takeCore();
        }
        else
        {
            const std::vector<Vertex> &inner = (*handles_)[coreHandles_++].inner;
            core_.insert(core_.end(), inner.begin(), inner.end());
        }
    }

    void takeCore()
    {
        core_ = cycle_;
        coreHandles_ = 0;
        for (const Handle &handle : *handles_)
        {
            if (coreHandles_ > 0 && core_.size() + handle.inner.size() > largestSearch_)
                break;
            core_.insert(core_.end(), handle.inner.begin(), handle.inner.end());
            ++coreHandles_;
        }
    }

    [[nodiscard]] std::shared_ptr<const Graph> coreGraph() const
    {
        std::vector<Graph::Edge> edges;
        for (Vertex i = 0; i < core_.size(); ++i)
            for (Vertex j = 0; j < i; ++j)
                if (graph_.hasEdge(core_[i], core_[j]))
                    edges.push_back({j, i});
        return Graph::fromEdges(core_.size(), edges);
    }

    [[nodiscard]] bool isTheta() const
    {
        return coreHandles_ == 1 && core_.size() > largestSearch_ && !isThetaZero(graph_);
    }

    /// The blank's target goes to the core, for the time being.
    void moveHome()
    {
        std::vector<Vertex> homes = core_;
        if (isTheta())
            homes = {(*handles_)[0].x, (*handles_)[0].y};
        const Vertex home = *std::min_element(homes.begin(), homes.end(),
                                              [this](Vertex v, Vertex w)
                                              { return search_.distance(v) < search_.distance(w); });
        wayHome_ = search_.path(home);
        board_.moveBlankTarget(wayHome_);
    }

    bool solveCore()
    {
        if (isTheta())
        {
            ThetaGraph graph = theta(cycle_, (*handles_)[0]);
            if (graph.p != board_.blankTarget())
            {
                std::swap(graph.p, graph.q);
                for (auto &arm : graph.arms)
                    std::reverse(arm.begin(), arm.end());
            }
            return solveTheta(board_, graph, ptc_);
        }
        const WalkSearch found = shortestWalk(board_, core_, ptc_);
        if (found.stopped)
            return false;
        assert(found.walk);
        for (const Vertex v : *found.walk)
            board_.step(v);
        return true;
    }

    const Graph &graph_;
    std::size_t largestSearch_;
    const TerminationCondition &ptc_;
    std::vector<Vertex> cycle_;
    const std::vector<Handle> *handles_; ///< the block's, or changedHandles_
    std::vector<Handle> changedHandles_;
    OneBlankBoard board_;
    BlankOperations operations_;
    BreadthFirstSearch search_; ///< from the blank's target
    std::vector<Vertex> core_;
    std::size_t coreHandles_ = 0; ///< so many handles belong to the core
    std::vector<Vertex> wayHome_; ///< from the blank's target to the core
};

} // namespace

PreparedBlock::PreparedBlock(const Blocks &blocks, std::uint32_t block, std::optional<Seed> shuffle)
    : vertices(blocks.vertices(block).begin(), blocks.vertices(block).end()),
      isBipartite(blocks.isBipartite(block))
{
    // Where each of the ascending vertices goes.
    const std::vector<Vertex> ascending = vertices;
    std::vector<Vertex> names(ascending.size());
    for (Vertex i = 0; i < names.size(); ++i)
        names[i] = i;
    if (shuffle)
        Random(*shuffle).shuffle(std::span(names));
    for (Vertex i = 0; i < names.size(); ++i)
        vertices[names[i]] = ascending[i];
    const auto nameOf = [&](Vertex v)
    { return names[std::lower_bound(ascending.begin(), ascending.end(), v) - ascending.begin()]; };
    std::vector<Graph::Edge> edges;
    edges.reserve(blocks.edges(block).size());
    for (const Blocks::Edge &edge : blocks.edges(block))
        edges.push_back({nameOf(edge.a), nameOf(edge.b)});
    graph = Graph::fromEdges(vertices.size(), edges);
    if (isBipartite)
    {
        BreadthFirstSearch search(*graph);
        search.run(0);
        for (Vertex v = 0; v < vertices.size(); ++v)
            sides.push_back(static_cast<char>(search.distance(v) % 2));
    }
    if (blocks.isEdge(block) || blocks.isCycle(block))
        return;
    const EarDecomposition ears(*graph, isBipartite ? shortCycle(*graph) : shortOddCycle(*graph));
    cycle.assign(ears.cycle().begin(), ears.cycle().end());
    for (std::size_t i = 0; i < ears.handleCount(); ++i)
    {
        const auto inner = ears.interior(i);
        handles.push_back({ears.handle(i).front(), {inner.begin(), inner.end()}, ears.handle(i).back()});
    }
}

bool isThetaZero(const Graph &graph)
{
    if (graph.vertexCount() != 7 || graph.edgeCount() != 8)
        return false;
    std::vector<Vertex> junctions;
    for (Vertex v = 0; v < 7; ++v)
        if (graph.degree(v) == 3)
            junctions.push_back(v);
    if (junctions.size() != 2 || graph.hasEdge(junctions[0], junctions[1]))
        return false;
    std::size_t common = 0;
    for (const Vertex v : graph.neighbors(junctions[0]))
        common += graph.hasEdge(v, junctions[1]) ? 1 : 0;
    return common == 1;
}

BlockObstacle obstacle(const BlockPuzzle &puzzle, const TerminationCondition &ptc)
{
    const Graph &graph = *puzzle.block->graph;
    if (graph.vertexCount() == 2)
        return BlockObstacle::none;
    if (isCycle(graph))
        return cycleTurn(puzzle).steps ? BlockObstacle::none : BlockObstacle::cyclicOrder;
    if (isThetaZero(graph))
    {
        const OneBlankBoard board(graph, puzzle.targets, puzzle.blank);
        const bool solvable = shortestWalk(board, allVertices(graph), {}).walk.has_value();
        return solvable ? BlockObstacle::none : BlockObstacle::thetaZero;
    }
    if (!puzzle.block->isBipartite)
        return BlockObstacle::none;
    const std::vector<char> &sides = puzzle.block->sides;
    const bool oddWay = sides[puzzle.blank] != sides[puzzle.targets[puzzle.blank]];
    return isOddPermutation(puzzle.targets, ptc) != oddWay ? BlockObstacle::oddPermutation
                                                           : BlockObstacle::none;
}

std::optional<std::vector<Vertex>> solveBlock(const BlockPuzzle &puzzle, std::size_t largestSearch,
                                              const TerminationCondition &ptc)
{
    bool isHome = true;
    for (Vertex v = 0; v < puzzle.targets.size(); ++v)
        isHome = isHome && puzzle.targets[v] == v;
    if (isHome)
        return std::vector<Vertex>{puzzle.blank};
    if (puzzle.block->graph->vertexCount() == 2)
        return std::vector<Vertex>{puzzle.blank, puzzle.targets[puzzle.blank]};
    if (isCycle(*puzzle.block->graph))
        return solveCycle(puzzle, ptc);
    return BlockSolver(puzzle, largestSearch, ptc).solve();
}

} // namespace mrpp

#include "algorithms/OneBlank.h"

#include "algorithms/pebble/BlankWalks.h"
#include "algorithms/pebble/StampedSearch.h"

#include <algorithm>
#include <utility>

namespace mrpp
{

namespace
{

constexpr std::uint32_t kNoBlock = static_cast<std::uint32_t>(-1);

/// The trees of blocks of all components in which somebody has to move, each rooted at the vertex that is to
/// be free in the end.
class BlockTrees
{
public:
    explicit BlockTrees(const Graph &graph, const Blocks &blocks)
        : blocks_(blocks), parent_(graph.vertexCount(), kNoBlock), exit_(blocks.count(), kNoVertex),
          entry_(blocks.count(), kNoVertex), onWay_(blocks.count(), 0)
    {}

    /// \param blank the vertex that is free at the start
    void add(Vertex blank, Vertex root)
    {
        std::vector<Vertex> queue{root};
        for (std::size_t head = 0; head < queue.size(); ++head)
            for (const std::uint32_t block : blocks_.of(queue[head]))
            {
                if (exit_[block] != kNoVertex)
                    continue;
                exit_[block] = entry_[block] = queue[head];
                order_.push_back(block);
                for (const Vertex v : blocks_.vertices(block))
                {
                    if (v == queue[head])
                        continue;
                    parent_[v] = block;
                    queue.push_back(v);
                }
            }
        for (Vertex v = blank; v != root; v = exit_[parent_[v]])
        {
            entry_[parent_[v]] = v;
            onWay_[parent_[v]] = 1;
        }
    }

    /// Roots before leaves.
    [[nodiscard]] std::span<const std::uint32_t> order() const { return order_; }
    /// The block towards the root; kNoBlock at the root.
    [[nodiscard]] std::uint32_t parent(Vertex v) const { return parent_[v]; }
    /// Where the blank comes into the block, and where it leaves it, which is its vertex nearest to the root.
    [[nodiscard]] Vertex entry(std::uint32_t block) const { return entry_[block]; }
    [[nodiscard]] Vertex exit(std::uint32_t block) const { return exit_[block]; }
    /// Whether the blank goes through it on its way from its start to the root.
    [[nodiscard]] bool isOnWay(std::uint32_t block) const { return onWay_[block] != 0; }

    /// The vertex of the block that lies on the way from there to v.
    [[nodiscard]] Vertex gate(std::uint32_t block, Vertex v) const
    {
        while (parent_[v] != kNoBlock && parent_[v] != block)
            v = exit_[parent_[v]];
        return parent_[v] == block ? v : exit_[block];
    }

private:
    const Blocks &blocks_;
    std::vector<std::uint32_t> parent_; ///< size = vertices
    std::vector<Vertex> exit_;          ///< size = blocks
    std::vector<Vertex> entry_;
    std::vector<char> onWay_;
    std::vector<std::uint32_t> order_;
};

/// Puts the walks of the blocks together.
class Tour
{
public:
    Tour(const Graph &graph, const Blocks &blocks, const BlockTrees &trees,
         std::vector<std::vector<Vertex>> walks)
        : graph_(graph), blocks_(blocks), trees_(trees), walks_(std::move(walks)),
          isNeeded_(blocks.count(), 0), hasWork_(graph.vertexCount(), 0), search_(graph.vertexCount())
    {
        for (std::size_t i = trees.order().size(); i-- > 0;)
        {
            const std::uint32_t block = trees.order()[i];
            if (isNeeded_[block] == 0 && walks_[block].empty())
                continue;
            isNeeded_[block] = 1;
            const Vertex exit = trees.exit(block);
            hasWork_[exit] |= trees.isOnWay(block) ? 0 : 1;
            if (trees.parent(exit) != kNoBlock)
                isNeeded_[trees.parent(exit)] = 1;
        }
    }

    /// Appends the walk of the blank from where it starts to the root. False where time is up.
    bool append(Vertex blank, Vertex root, const TerminationCondition &ptc)
    {
        tour_.push_back(blank); // from the last component's root, where nobody stands either
        for (Vertex v = blank; v != root; v = trees_.exit(trees_.parent(v)))
            if (!appendBlock(trees_.parent(v), ptc))
                return false;
        visit(root);
        return finish(ptc);
    }

    [[nodiscard]] std::vector<Vertex> take() { return std::move(tour_); }

private:
    struct Frame
    {
        std::uint32_t block;
        std::vector<Vertex> walk;
        std::size_t next;
    };

    bool appendBlock(std::uint32_t block, const TerminationCondition &ptc)
    {
        frames_.push_back({block, wholeWalk(block), 0});
        return finish(ptc);
    }

    bool finish(const TerminationCondition &ptc)
    {
        for (std::size_t count = 1; !frames_.empty(); ++count)
        {
            if (count % 1024 == 0 && ptc())
                return false;
            Frame &frame = frames_.back();
            if (frame.next == frame.walk.size())
            {
                frames_.pop_back();
                continue;
            }
            const Vertex v = frame.walk[frame.next++];
            if (tour_.back() != v)
                tour_.push_back(v);
            if (trees_.parent(v) == frame.block)
                visit(v);
        }
        return true;
    }

    /// The first time that the blank is on v: the blocks that hang there.
    void visit(Vertex v)
    {
        if (std::exchange(hasWork_[v], 0) == 0)
            return;
        for (const std::uint32_t block : blocks_.of(v))
            if (isNeeded_[block] != 0 && trees_.exit(block) == v && !trees_.isOnWay(block))
                frames_.push_back({block, wholeWalk(block), 0});
    }

    /// The walk of a block with detours to those vertices that it leaves out and where something hangs.
    [[nodiscard]] std::vector<Vertex> wholeWalk(std::uint32_t block)
    {
        std::vector<Vertex> walk = std::move(walks_[block]);
        if (walk.empty())
            walk.push_back(trees_.entry(block));
        search_.begin();
        for (const Vertex v : walk)
            if (!search_.visited(v))
                search_.visit(v, kNoVertex);
        std::size_t missing = 0;
        for (const Vertex v : blocks_.vertices(block))
            missing += isMissing(v, block) ? 1 : 0;
        if (missing == 0)
            return walk;

        // Shortest paths from the walk to the vertices that are missing, as trees with roots on the walk.
        std::vector<std::pair<Vertex, Vertex>> branches;
        std::vector<Vertex> found;
        while (missing > 0)
        {
            const Vertex u = search_.next();
            for (const Vertex w : graph_.neighbors(u))
            {
                if (search_.visited(w) || blocks_.ofEdge(u, w) != block)
                    continue;
                if (isMissing(w, block))
                {
                    found.push_back(w);
                    --missing;
                }
                search_.visit(w, u);
            }
        }
        for (Vertex v : found)
            for (; search_.parent(v) != kNoVertex; v = search_.parent(v))
                branches.emplace_back(search_.parent(v), v);
        std::sort(branches.begin(), branches.end());
        branches.erase(std::unique(branches.begin(), branches.end()), branches.end());
        return withDetours(walk, branches);
    }

    [[nodiscard]] bool isMissing(Vertex v, std::uint32_t block) const
    {
        return hasWork_[v] != 0 && trees_.parent(v) == block && !search_.visited(v);
    }

    /// \param branches (parent, child) in ascending order
    [[nodiscard]] static std::vector<Vertex> withDetours(std::span<const Vertex> walk,
                                                         std::span<const std::pair<Vertex, Vertex>> branches)
    {
        std::vector<Vertex> whole;
        std::vector<char> used(branches.size(), 0);
        std::vector<Vertex> way; // from the walk into the tree
        for (const Vertex onWalk : walk)
        {
            way.assign({onWalk});
            whole.push_back(onWalk);
            while (!way.empty())
            {
                auto branch =
                    std::lower_bound(branches.begin(), branches.end(), std::pair(way.back(), Vertex{0}));
                while (branch != branches.end() && branch->first == way.back() &&
                       used[static_cast<std::size_t>(branch - branches.begin())] != 0)
                    ++branch;
                if (branch != branches.end() && branch->first == way.back())
                {
                    used[static_cast<std::size_t>(branch - branches.begin())] = 1;
                    way.push_back(branch->second);
                    whole.push_back(way.back());
                    continue;
                }
                way.pop_back();
                if (!way.empty())
                    whole.push_back(way.back());
            }
        }
        return whole;
    }

    const Graph &graph_;
    const Blocks &blocks_;
    const BlockTrees &trees_;
    std::vector<std::vector<Vertex>> walks_; ///< by block; empty where nothing has to be done
    std::vector<char> isNeeded_;             ///< by block: it or what hangs on it has work
    std::vector<char> hasWork_;              ///< by vertex: something hangs there that has work
    StampedSearch search_;
    std::vector<Frame> frames_;
    std::vector<Vertex> tour_;
};

/// One component's free vertices.
struct Room
{
    Vertex blank = kNoVertex; ///< the last free vertex at the start
    Vertex root = kNoVertex;  ///< the last vertex that is free in the end
    std::size_t free = 0;
    Robot mover = kNoRobot; ///< the first robot that has to move
};

std::vector<Room> rooms(const Instance &instance, const Components &components)
{
    std::vector<Room> list(components.count());
    std::vector<char> isStart(instance.graph->vertexCount(), 0);
    std::vector<char> isGoal(instance.graph->vertexCount(), 0);
    for (Robot r = 0; r < instance.robotCount(); ++r)
    {
        isStart[instance.starts[r]] = 1;
        isGoal[instance.goals[r]] = 1;
        Room &room = list[components.of(instance.starts[r])];
        if (room.mover == kNoRobot && instance.starts[r] != instance.goals[r])
            room.mover = r;
    }
    for (Vertex v = 0; v < instance.graph->vertexCount(); ++v)
    {
        Room &room = list[components.of(v)];
        if (isGoal[v] == 0)
            room.root = v;
        if (isStart[v] != 0)
            continue;
        room.blank = v;
        ++room.free;
    }
    return list;
}

std::string robotAt(const Instance &instance, Robot r)
{
    return "robot " + std::to_string(r) + " on vertex " + std::to_string(instance.starts[r]);
}

/// A block where something has to be done.
struct Task
{
    std::uint32_t block;
    std::unique_ptr<const PreparedBlock> own; ///< where the block is not prepared, or anew for this attempt
    BlockPuzzle puzzle;
};

/// Blocks of fewer vertices are prepared when they are needed.
constexpr std::size_t kFewVertices = 1000;

} // namespace

OneBlank::OneBlank()
    : RestartingPlanner({.citation =
                             "R. M. Wilson, Graph Puzzles, Homotopy, and the Alternating Group, JCT B "
                             "16 (1974) 86-96; block by block",
                         .motion = MotionRule::pebble,
                         .completeFor = "every graph with one free vertex in each component where somebody "
                                        "has to move",
                         .provesInfeasibility = true,
                         .complete = true})
{
    declareParam("core_size", coreSize_, "0:9",
                 "what is left of a block is solved by search, shortest moves first, when it has at most so "
                 "many vertices");
}

std::optional<std::string> OneBlank::reasonToReject(const Instance &instance) const
{
    const Components components(*instance.graph);
    for (const Room &room : rooms(instance, components))
        if (room.mover != kNoRobot && room.free > 1)
            return std::to_string(room.free) + " vertices are free where " + robotAt(instance, room.mover) +
                   " has to move; push_and_rotate takes two or more";
    return std::nullopt;
}

void OneBlank::clear()
{
    RestartingPlanner::clear();
    prepared_.clear();
    blocks_.reset();
    components_.reset();
}

void OneBlank::setup()
{
    blocks_ = std::make_unique<const Blocks>(graph());
    components_ = std::make_unique<const Components>(graph());
    for (std::uint32_t block = 0; block < blocks_->count(); ++block)
        if (blocks_->vertices(block).size() >= kFewVertices)
            prepared_.emplace(block, PreparedBlock(*blocks_, block));
}

RestartingPlanner::Outcome OneBlank::attempt(std::uint64_t number, const TerminationCondition &ptc) const
{
    const auto stopped = [] { return Outcome{PlannerStatus::timeout, "", {}}; };
    const Instance &question = instance();
    for (Robot r = 0; r < question.robotCount(); ++r)
        if (components_->of(question.starts[r]) != components_->of(question.goals[r]))
            return {PlannerStatus::infeasible,
                    "no path leads " + robotAt(question, r) + " to its goal " +
                        std::to_string(question.goals[r]),
                    {}};
    BlockTrees trees(graph(), *blocks_);
    const std::vector<Room> list = rooms(question, *components_);
    for (const Room &room : list)
    {
        if (room.mover == kNoRobot)
            continue;
        if (room.free == 0)
            return {PlannerStatus::infeasible,
                    robotAt(question, room.mover) + " has to move, and no vertex of its component is free",
                    {}};
        trees.add(room.blank, room.root);
    }

    // What each block needs; then, if all of it is possible, how.
    const std::vector<Robot> occupants = occupantsAtStart(question);
    std::vector<Task> tasks;
    std::vector<Vertex> names(graph().vertexCount());
    for (const std::uint32_t block : trees.order())
    {
        if (ptc())
            return stopped();
        bool needsNothing = !trees.isOnWay(block);
        for (const Vertex v : blocks_->vertices(block))
        {
            if (v == trees.entry(block))
                continue;
            const Robot r = occupants[v];
            const Vertex goal = question.goals[r];
            needsNothing = needsNothing && goal == v;
            if (trees.parent(goal) != block)
                return {PlannerStatus::infeasible,
                        robotAt(question, r) + " would have to pass the cut vertex " +
                            std::to_string(trees.gate(block, goal)) + " to its goal " + std::to_string(goal) +
                            ", which nobody can with one free vertex",
                        {}};
        }
        if (needsNothing)
            continue;
        if (ptc())
            return stopped();
        std::unique_ptr<const PreparedBlock> own;
        const std::size_t size = blocks_->vertices(block).size();
        if (number > 0 && size <= kMostShuffled)
            own = std::make_unique<const PreparedBlock>(*blocks_, block,
                                                        deriveSeed(attemptSeed(number), block));
        else if (size < kFewVertices)
            own = std::make_unique<const PreparedBlock>(*blocks_, block);
        const PreparedBlock &local = own ? *own : prepared_.at(block);
        for (Vertex i = 0; i < local.vertices.size(); ++i)
            names[local.vertices[i]] = i;
        BlockPuzzle puzzle{&local, {}, names[trees.entry(block)]};
        for (const Vertex v : local.vertices)
            puzzle.targets.push_back(
                names[v == trees.entry(block) ? trees.exit(block) : question.goals[occupants[v]]]);
        if (ptc())
            return stopped();
        const BlockObstacle what = obstacle(puzzle, ptc);
        if (ptc())
            return stopped();
        if (what != BlockObstacle::none)
            return {PlannerStatus::infeasible, describe(what, *blocks_, block), {}};
        tasks.push_back({block, std::move(own), std::move(puzzle)});
    }

    std::vector<std::vector<Vertex>> walks(blocks_->count());
    for (const Task &task : tasks)
    {
        auto walk = solveBlock(task.puzzle, static_cast<std::size_t>(coreSize_), ptc);
        if (!walk)
            return stopped();
        for (Vertex &v : *walk)
            v = task.puzzle.block->vertices[v];
        walks[task.block] = std::move(*walk);
    }
    if (ptc())
        return stopped();
    Tour tour(graph(), *blocks_, trees, std::move(walks));
    for (const Room &room : list)
        if (room.mover != kNoRobot && !tour.append(room.blank, room.root, ptc))
            return stopped();
    if (ptc())
        return stopped();
    auto solution = movesOf(tour.take(), occupants, ptc);
    if (!solution)
        return stopped();
    return {PlannerStatus::solved, "", std::move(*solution)};
}

} // namespace mrpp

#include "framework/analysis/Solvability.h"

#include "framework/analysis/Components.h"
#include "framework/analysis/Normalization.h"
#include "framework/analysis/SolvabilityCase.h"

#include <algorithm>
#include <array>
#include <fmt/core.h>
#include <iterator>
#include <numeric>
#include <unordered_map>
#include <utility>

namespace mrpp
{

namespace detail
{

std::vector<Vertex> treePath(const Blocks &blocks, Vertex from, Vertex to)
{
    std::vector<Vertex> path;
    std::vector<Vertex> back;
    while (from != to)
    {
        const bool fromIsDeeper = blocks.position(from) > blocks.position(to);
        Vertex &deeper = fromIsDeeper ? from : to;
        (fromIsDeeper ? path : back).push_back(deeper);
        deeper = blocks.parent(deeper);
    }
    path.push_back(from);
    path.insert(path.end(), back.rbegin(), back.rend());
    return path;
}

std::string listed(std::span<const Vertex> vertices)
{
    constexpr std::size_t kShown = 12;
    std::string text = "{";
    for (std::size_t i = 0; i < std::min(vertices.size(), kShown); ++i)
        text += (i == 0 ? "" : ", ") + std::to_string(vertices[i]);
    return text + (vertices.size() > kShown ? fmt::format(", … ({} vertices)}}", vertices.size()) : "}");
}

std::vector<Vertex> aroundCycle(std::span<const Blocks::Edge> edges, Vertex first)
{
    std::unordered_map<Vertex, std::array<Vertex, 2>> around;
    for (const auto &[a, b] : edges)
    {
        for (const auto &[v, w] : {std::pair(a, b), std::pair(b, a)})
        {
            auto &[one, other] = around.try_emplace(v, std::array{kNoVertex, kNoVertex}).first->second;
            (one == kNoVertex ? one : other) = w;
        }
    }
    std::vector<Vertex> cycle;
    Vertex previous = kNoVertex;
    Vertex v = first;
    do
    {
        cycle.push_back(v);
        const auto &[one, other] = around.at(v);
        previous = std::exchange(v, one == previous ? other : one);
    } while (v != first);
    return cycle;
}

Objection objectToTurning(const Arrangement &arrangement, const std::string &where)
{
    const auto &[have, want] = arrangement;
    if (have.size() < 3)
        return std::nullopt;
    const auto shift = static_cast<std::size_t>(std::ranges::find(want, have.front()) - want.begin());
    for (std::size_t i = 1; i < have.size(); ++i)
    {
        const Robot wanted = want[(i + shift) % want.size()];
        if (wanted != have[i])
            return fmt::format(
                "the cyclic order {0}, {1}, {2} of robots {3} would have to become {0}, {2}, {1}", have[0],
                have[i], wanted, where);
    }
    return std::nullopt;
}

bool isOdd(const Arrangement &arrangement)
{
    const auto &[have, want] = arrangement;
    std::unordered_map<Robot, std::size_t> goal;
    for (std::size_t i = 0; i < want.size(); ++i)
        goal.emplace(want[i], i);
    std::vector<std::uint8_t> seen(have.size(), 0);
    std::size_t cycles = 0;
    for (std::size_t first = 0; first < have.size(); ++first)
    {
        cycles += seen[first] == 0 ? 1 : 0;
        for (std::size_t i = first; seen[i] == 0; i = goal.at(have[i]))
            seen[i] = 1;
    }
    return (have.size() - cycles) % 2 != 0;
}

} // namespace detail

namespace
{

using detail::Objection;
using detail::SolvabilityCase;

class Oracle
{
public:
    Oracle(const Instance &instance, MotionRule rule, const TerminationCondition &ptc)
        : ptc_(ptc), given_{instance, *instance.graph, rule, Blocks(*instance.graph), {}, {}, {}},
          components_(*instance.graph), shapes_(componentShapes(*instance.graph, components_))
    {}

    /// Meaningless where the termination condition has said stop.
    Objection run()
    {
        if (Objection objection = objectToComponents())
            return objection;
        groupRobots();
        for (std::uint32_t component = 0; component < components_.count() && !ptc_(); ++component)
            if (Objection objection = objectTo(component))
                return objection;
        return std::nullopt;
    }

private:
    [[nodiscard]] const Instance &instance() const { return given_.instance; }

    [[nodiscard]] Objection objectToComponents() const
    {
        for (Robot robot = 0; robot < instance().robotCount(); ++robot)
        {
            const Vertex start = instance().starts[robot];
            const Vertex goal = instance().goals[robot];
            if (components_.of(start) != components_.of(goal))
                return fmt::format("robot {}'s goal {} lies in another component than its start {}", robot,
                                   goal, start);
        }
        return std::nullopt;
    }

    void groupRobots()
    {
        offsets_.assign(components_.count() + 1, 0);
        for (const Vertex v : instance().starts)
            ++offsets_[components_.of(v) + 1];
        std::partial_sum(offsets_.begin(), offsets_.end(), offsets_.begin());
        robots_.resize(instance().robotCount());
        std::vector<std::uint32_t> end(offsets_.begin(), offsets_.end() - 1);
        for (Robot robot = 0; robot < robots_.size(); ++robot)
            robots_[end[components_.of(instance().starts[robot])]++] = robot;
    }

    Objection objectTo(std::uint32_t component)
    {
        const std::span<const Robot> robots(robots_.data() + offsets_[component],
                                            robots_.data() + offsets_[component + 1]);
        const auto moved = std::ranges::find_if(
            robots, [&](Robot robot) { return instance().starts[robot] != instance().goals[robot]; });
        if (moved == robots.end())
            return std::nullopt;
        const std::size_t free = components_.size(component) - robots.size();
        if (free == 0 && !given_.rotations())
            return fmt::format("robot {} cannot leave {} for its goal {}: no vertex is free", *moved,
                               instance().starts[*moved], instance().goals[*moved]);
        const std::span<const Vertex> vertices = verticesWith(*moved);
        if (shapes_[component] == ComponentShape::path)
            return objectToOrder(vertices);
        if (shapes_[component] == ComponentShape::polygon)
            return objectToCyclicOrder(vertices);
        if (free == 0)
        {
            normalizeOnce();
            return detail::objectWithNoneFree(given_, robots, vertices);
        }
        if (free == 1 && !given_.rotations())
        {
            normalizeOnce();
            return detail::objectWithOneFree(given_, robots, vertices);
        }
        return objectToClasses(robots);
    }

    /// The vertices of a robot's component.
    [[nodiscard]] std::span<const Vertex> verticesWith(Robot robot) const
    {
        const Vertex root = given_.blocks.root(instance().starts[robot]);
        return given_.blocks.preorder().subspan(given_.blocks.position(root),
                                                given_.blocks.subtreeSize(root));
    }

    Objection objectToClasses(std::span<const Robot> robots)
    {
        if (!subgraphs_)
        {
            subgraphs_.emplace(given_.graph, given_.blocks, given_.rule, instance().goals);
            const std::vector<std::uint32_t> assignment = subgraphs_->assignment(instance().goals);
            classes_.assign(given_.graph.vertexCount(), kNoSubgraph);
            for (Robot robot = 0; robot < assignment.size(); ++robot)
            {
                const Vertex goal = instance().goals[robot];
                // A robot without a subgraph is a class of its own.
                classes_[goal] = assignment[robot] != kNoSubgraph
                                     ? assignment[robot]
                                     : static_cast<std::uint32_t>(subgraphs_->count()) + goal;
            }
        }
        const auto classOf = [&](Robot robot) { return classes_[instance().goals[robot]]; };
        if (std::ranges::all_of(robots, [&](Robot robot) { return classOf(robot) == classOf(robots[0]); }))
            return std::nullopt;
        if (ptc_())
            return std::nullopt;
        normalizeOnce();
        return detail::objectToClasses(given_, *subgraphs_, classes_, robots);
    }

    void normalizeOnce()
    {
        if (!given_.places.empty())
            return;
        given_.places = normalize(given_.graph, given_.blocks, instance().starts, instance().goals);
        given_.have.assign(given_.graph.vertexCount(), kNoRobot);
        given_.want.assign(given_.graph.vertexCount(), kNoRobot);
        for (Robot robot = 0; robot < given_.places.size(); ++robot)
        {
            given_.have[given_.places[robot]] = robot;
            given_.want[instance().goals[robot]] = robot;
        }
    }

    [[nodiscard]] Objection objectToOrder(std::span<const Vertex> vertices)
    {
        normalizeOnce();
        // The search met the path's vertices from its root to one end, then from the root to the other.
        std::vector<Vertex> line(vertices.begin(), vertices.end());
        const auto end = std::ranges::find_if(line, [&](Vertex v) { return given_.graph.degree(v) <= 1; });
        std::reverse(line.begin(), std::next(end));
        const detail::Arrangement arrangement(given_, line);
        const auto [mine, theirs] = std::ranges::mismatch(arrangement.have, arrangement.want);
        if (mine == arrangement.have.end())
            return std::nullopt;
        return fmt::format("robots {} and {} cannot pass each other on the path {}–{}",
                           std::min(*mine, *theirs), std::max(*mine, *theirs), line.front(), line.back());
    }

    [[nodiscard]] Objection objectToCyclicOrder(std::span<const Vertex> vertices)
    {
        normalizeOnce();
        // The search went once around.
        return detail::objectToTurning({given_, vertices}, "on the polygon " + detail::listed(vertices));
    }

    const TerminationCondition &ptc_;
    SolvabilityCase given_;
    Components components_;
    std::vector<ComponentShape> shapes_;
    std::vector<std::uint32_t> offsets_;
    std::vector<Robot> robots_; ///< by component
    std::optional<Subgraphs> subgraphs_;
    std::vector<std::uint32_t> classes_; ///< by vertex
};

} // namespace

Solvability solvability(const Instance &instance, MotionRule rule)
{
    return *solvability(instance, rule, TerminationCondition::never());
}

std::optional<Solvability> solvability(const Instance &instance, MotionRule rule,
                                       const TerminationCondition &ptc)
{
    if (instance.starts == instance.goals)
        return Solvability{};
    if (ptc())
        return std::nullopt;
    Objection objection = Oracle(instance, rule, ptc).run();
    if (ptc())
        return std::nullopt;
    return objection ? Solvability{false, std::move(*objection)} : Solvability{};
}

} // namespace mrpp

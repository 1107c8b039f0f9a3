#include "algorithms/pebble/SmallPuzzle.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace mrpp
{

namespace
{

/// What stands on each vertex, by its local target, and where the blank is.
struct State
{
    std::array<std::uint8_t, kSmallPuzzle> targets{};
    std::uint8_t blank = 0;

    void step(std::uint8_t v)
    {
        std::swap(targets[blank], targets[v]);
        blank = v;
    }
};

/// Breadth-first search from one state; remembers how each state was reached.
class Side
{
public:
    Side(const State &root, std::size_t vertices, std::size_t states) : size_(vertices), came_(states, kNever)
    {
        came_[rank(root)] = kRoot;
        frontier_.push_back(root);
    }

    [[nodiscard]] bool exhausted() const { return frontier_.empty(); }
    [[nodiscard]] std::size_t frontierSize() const { return frontier_.size(); }
    [[nodiscard]] bool reached(const State &state) const { return came_[rank(state)] != kNever; }

    /// Goes one step farther; the first new state that the other side has reached too, if there is one.
    std::optional<State> advance(const std::vector<std::vector<std::uint8_t>> &neighbors, const Side &other)
    {
        next_.clear();
        for (const State &state : frontier_)
        {
            for (const std::uint8_t v : neighbors[state.blank])
            {
                State successor = state;
                successor.step(v);
                std::uint8_t &came = came_[rank(successor)];
                if (came != kNever)
                    continue;
                came = state.blank;
                if (other.reached(successor))
                    return successor;
                next_.push_back(successor);
            }
        }
        frontier_.swap(next_);
        return std::nullopt;
    }

    /// The blank's vertices from `state` back to the root, both included.
    [[nodiscard]] std::vector<std::uint8_t> wayBack(State state) const
    {
        std::vector<std::uint8_t> way{state.blank};
        for (std::uint8_t came = came_[rank(state)]; came != kRoot; came = came_[rank(state)])
        {
            state.step(came);
            way.push_back(came);
        }
        return way;
    }

private:
    static constexpr std::uint8_t kNever = 255;
    static constexpr std::uint8_t kRoot = 254;

    [[nodiscard]] std::size_t rank(const State &state) const
    {
        std::array<std::uint8_t, kSmallPuzzle> items = state.targets;
        std::array<std::uint8_t, kSmallPuzzle> places{};
        for (std::uint8_t i = 0; i < size_; ++i)
            places[items[i]] = i;
        std::size_t rank = 0;
        std::size_t weight = 1;
        for (std::size_t n = size_; n > 1; --n)
        {
            const std::uint8_t last = items[n - 1];
            const std::uint8_t place = places[n - 1];
            items[place] = last;
            places[last] = place;
            rank += weight * last;
            weight *= n;
        }
        return rank;
    }

    std::size_t size_;
    std::vector<std::uint8_t> came_; ///< by rank: the blank's vertex before, or kNever, kRoot
    std::vector<State> frontier_;
    std::vector<State> next_;
};

} // namespace

WalkSearch shortestWalk(const OneBlankBoard &board, std::span<const Vertex> vertices,
                        const TerminationCondition &ptc)
{
    const auto local = [&](Vertex v)
    {
        const auto found = std::find(vertices.begin(), vertices.end(), v);
        assert(found != vertices.end());
        return static_cast<std::uint8_t>(found - vertices.begin());
    };
    State start;
    State goal;
    std::vector<std::vector<std::uint8_t>> neighbors(vertices.size());
    std::size_t states = 1;
    for (std::size_t i = 0; i < vertices.size(); ++i)
    {
        start.targets[i] = local(board.target(vertices[i]));
        goal.targets[i] = static_cast<std::uint8_t>(i);
        for (const Vertex w : board.graph().neighbors(vertices[i]))
            if (std::find(vertices.begin(), vertices.end(), w) != vertices.end())
                neighbors[i].push_back(local(w));
        states *= i + 1;
    }
    start.blank = local(board.blank());
    goal.blank = local(board.blankTarget());

    WalkSearch result;
    Side forward(start, vertices.size(), states);
    Side backward(goal, vertices.size(), states);
    std::optional<State> meeting;
    if (backward.reached(start))
        meeting = start;
    while (!meeting && !forward.exhausted() && !backward.exhausted())
    {
        if (ptc())
        {
            result.stopped = true;
            return result;
        }
        meeting = forward.frontierSize() <= backward.frontierSize() ? forward.advance(neighbors, backward)
                                                                    : backward.advance(neighbors, forward);
    }
    if (!meeting)
        return result;
    std::vector<std::uint8_t> way = forward.wayBack(*meeting);
    std::reverse(way.begin(), way.end());
    const std::vector<std::uint8_t> rest = backward.wayBack(*meeting);
    way.insert(way.end(), rest.begin() + 1, rest.end());
    result.walk.emplace();
    for (std::size_t i = 1; i < way.size(); ++i)
        result.walk->push_back(vertices[way[i]]);
    return result;
}

} // namespace mrpp

#include "tests/support/BruteForce.h"

#include <algorithm>
#include <bit>
#include <stdexcept>
#include <unordered_set>
#include <utility>
#include <vector>

namespace mrpp::test
{

namespace
{

using Packed = std::uint64_t;

struct Mix
{
    std::size_t operator()(Packed x) const
    {
        x = (x ^ (x >> 31)) * 0x9e3779b97f4a7c15U;
        return x ^ (x >> 29);
    }
};

/// The configurations that one step leads to.
class Successors
{
public:
    Successors(const Graph &graph, std::size_t robots, MotionRule rule)
        : graph_(graph), rule_(rule),
          width_(static_cast<unsigned>(std::bit_width(std::max<std::size_t>(1, graph.vertexCount()) - 1))),
          now_(robots), next_(robots), before_(graph.vertexCount()), after_(graph.vertexCount())
    {
        if (width_ * robots > 64)
            throw std::length_error("configurations do not fit 64 bits");
    }

    [[nodiscard]] Packed pack(const std::vector<Vertex> &positions) const
    {
        Packed packed = 0;
        for (const Vertex v : positions)
            packed = (packed << width_) | v;
        return packed;
    }

    template <class Visitor>
    void visit(Packed packed, Visitor &&visit)
    {
        for (std::size_t robot = now_.size(); robot-- > 0; packed >>= width_)
            now_[robot] = static_cast<Vertex>(packed & ((Packed{1} << width_) - 1));
        before_.assign(before_.size(), kNoRobot);
        after_.assign(after_.size(), kNoRobot);
        for (Robot robot = 0; robot < now_.size(); ++robot)
            before_[now_[robot]] = robot;
        if (rule_ == MotionRule::pebble)
            moveOne(visit);
        else
            moveFrom(0, visit);
    }

private:
    template <class Visitor>
    void moveOne(Visitor &visit)
    {
        next_ = now_;
        for (std::size_t robot = 0; robot < now_.size(); ++robot)
        {
            for (const Vertex v : graph_.neighbors(now_[robot]))
            {
                if (before_[v] != kNoRobot)
                    continue;
                next_[robot] = v;
                visit(pack(next_));
            }
            next_[robot] = now_[robot];
        }
    }

    /// Tries every target of this robot and those behind it.
    template <class Visitor>
    void moveFrom(Robot robot, Visitor &visit)
    {
        if (robot == now_.size())
        {
            if (rule_ != MotionRule::following || !turnsCycle())
                visit(pack(next_));
            return;
        }
        enter(robot, now_[robot], visit);
        for (const Vertex v : graph_.neighbors(now_[robot]))
        {
            if (before_[v] == kNoRobot)
                enter(robot, v, visit);
            else if (rule_ != MotionRule::parallel &&
                     !(before_[v] < robot && next_[before_[v]] == now_[robot]))
                enter(robot, v, visit);
        }
    }

    template <class Visitor>
    void enter(Robot robot, Vertex v, Visitor &visit)
    {
        if (after_[v] != kNoRobot)
            return;
        after_[v] = robot;
        next_[robot] = v;
        moveFrom(robot + 1, visit);
        after_[v] = kNoRobot;
    }

    [[nodiscard]] bool turnsCycle() const
    {
        for (Robot first = 0; first < now_.size(); ++first)
        {
            Robot robot = first;
            for (std::size_t i = 0; i < now_.size() && robot != kNoRobot && next_[robot] != now_[robot]; ++i)
            {
                robot = before_[next_[robot]];
                if (robot == first)
                    return true;
            }
        }
        return false;
    }

    const Graph &graph_;
    MotionRule rule_;
    unsigned width_;
    std::vector<Vertex> now_;
    std::vector<Vertex> next_;
    std::vector<Robot> before_; ///< who stands on a vertex before the step
    std::vector<Robot> after_;  ///< and after it, as far as the robots have chosen
};

} // namespace

std::optional<std::uint32_t> leastMakespan(const Instance &instance, MotionRule rule, std::size_t limit)
{
    Successors successors(*instance.graph, instance.robotCount(), rule);
    const Packed goal = successors.pack(instance.goals);
    std::vector<Packed> rim = {successors.pack(instance.starts)};
    std::vector<Packed> next;
    std::unordered_set<Packed, Mix> seen(rim.begin(), rim.end());
    for (std::uint32_t steps = 0; !rim.empty(); ++steps)
    {
        if (seen.contains(goal))
            return steps;
        next.clear();
        for (const Packed configuration : rim)
        {
            successors.visit(configuration,
                             [&](Packed reached)
                             {
                                 if (seen.insert(reached).second)
                                     next.push_back(reached);
                             });
        }
        if (seen.size() > limit)
            throw std::length_error("too many configurations for brute force");
        std::swap(rim, next);
    }
    return std::nullopt;
}

} // namespace mrpp::test

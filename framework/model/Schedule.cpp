#include "framework/model/Schedule.h"

#include <cassert>

namespace mrpp
{

Schedule::Schedule(std::vector<Move> moves, std::vector<std::size_t> ends)
    : moves_(std::move(moves)), ends_(std::move(ends))
{
    assert(ends_.empty() ? moves_.empty() : ends_.back() == moves_.size());
}

void Schedule::appendStep(std::span<const Move> moves)
{
    moves_.insert(moves_.end(), moves.begin(), moves.end());
    ends_.push_back(moves_.size());
}

Solution Schedule::toSolution(std::size_t vertexCount) const
{
    constexpr std::uint32_t kNone = static_cast<std::uint32_t>(-1);
    Solution solution;
    solution.reserve(moves_.size());
    std::vector<std::uint32_t> leaving(vertexCount, kNone);  // the step's move out of a vertex
    std::vector<std::uint32_t> entering(vertexCount, kNone); // the step's move into a vertex
    std::vector<char> done;
    std::vector<Move> cycle;
    for (std::size_t s = 0; s < makespan(); ++s)
    {
        const std::span<const Move> now = step(s);
        for (std::uint32_t i = 0; i < now.size(); ++i)
        {
            leaving[now[i].from] = i;
            entering[now[i].to] = i;
        }
        done.assign(now.size(), 0);
        // A chain is led by a robot that enters a vertex nobody leaves; those behind it follow.
        for (std::uint32_t i = 0; i < now.size(); ++i)
        {
            if (leaving[now[i].to] != kNone)
                continue;
            for (std::uint32_t j = i; j != kNone && !done[j]; j = entering[now[j].from])
            {
                solution.append(now[j]);
                done[j] = 1;
            }
        }
        // What is left are closed cycles.
        for (std::uint32_t i = 0; i < now.size(); ++i)
        {
            if (done[i])
                continue;
            cycle.clear();
            for (std::uint32_t j = i; !done[j]; j = leaving[now[j].to])
            {
                cycle.push_back(now[j]);
                done[j] = 1;
            }
            solution.appendRotation(cycle);
        }
        for (const Move &move : now)
            leaving[move.from] = entering[move.to] = kNone;
    }
    return solution;
}

Schedule Schedule::fromActions(const Solution &solution)
{
    Schedule schedule;
    schedule.moves_.reserve(solution.pathLength());
    schedule.ends_.reserve(solution.actionCount());
    solution.forEachAction([&schedule](std::span<const Move> action) { schedule.appendStep(action); });
    return schedule;
}

} // namespace mrpp

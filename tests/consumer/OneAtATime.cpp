#include "OneAtATime.h"

#include <algorithm>
#include <vector>

using mrpp::PlannerStatus;
using mrpp::Robot;
using mrpp::Vertex;

OneAtATime::OneAtATime()
    : Planner({.citation = "an example",
               .motion = mrpp::MotionRule::pebble,
               .completeFor = "nothing in particular",
               .provesInfeasibility = false})
{
    declareParam("rounds", rounds_, "1:1000", "how often every robot may try");
}

PlannerStatus OneAtATime::solve(const mrpp::TerminationCondition &ptc)
{
    std::vector<Vertex> positions = instance().starts;
    std::vector<char> occupied(graph().vertexCount(), 0);
    for (const Vertex v : positions)
        occupied[v] = 1;

    mrpp::Solution solution;
    std::vector<Vertex> parents(graph().vertexCount());
    for (std::int64_t round = 0; round < rounds_ && positions != instance().goals; ++round)
    {
        for (Robot r = 0; r < positions.size(); ++r)
        {
            if (ptc())
                return PlannerStatus::timeout;
            // Backwards from the goal, so that the parents lead there.
            const Vertex goal = instance().goals[r];
            std::fill(parents.begin(), parents.end(), mrpp::kNoVertex);
            std::vector<Vertex> queue = {goal};
            parents[goal] = goal;
            for (std::size_t head = 0; head < queue.size() && parents[positions[r]] == mrpp::kNoVertex;
                 ++head)
            {
                if (occupied[queue[head]] != 0)
                    continue;
                for (const Vertex v : graph().neighbors(queue[head]))
                {
                    if (parents[v] == mrpp::kNoVertex)
                    {
                        parents[v] = queue[head];
                        queue.push_back(v);
                    }
                }
            }
            while (positions[r] != goal && parents[positions[r]] != mrpp::kNoVertex)
            {
                const Vertex to = parents[positions[r]];
                solution.append({r, positions[r], to});
                occupied[positions[r]] = 0;
                occupied[to] = 1;
                positions[r] = to;
            }
        }
    }
    if (positions != instance().goals)
        return because(PlannerStatus::gave_up, "some robot's way is blocked");
    setSolution(std::move(solution));
    return PlannerStatus::solved;
}

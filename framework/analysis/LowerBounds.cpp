#include "framework/analysis/LowerBounds.h"

#include "framework/analysis/BreadthFirstSearch.h"
#include "framework/analysis/Components.h"
#include "framework/analysis/DistanceSearch.h"

#include <algorithm>

namespace mrpp
{

namespace
{

/// Every robot needs what `atLeast(robot)` says.
template <class AtLeast>
LowerBounds together(const Instance &instance, BoundMeans means, const AtLeast &atLeast)
{
    LowerBounds bounds{.means = means};
    for (Robot r = 0; r < instance.robotCount(); ++r)
    {
        const std::uint64_t steps = atLeast(r);
        bounds.pathLength += steps;
        bounds.makespan = std::max(bounds.makespan, steps);
    }
    return bounds;
}

LowerBounds fromDisplaced(const Instance &instance)
{
    return together(instance, BoundMeans::displaced,
                    [&](Robot r) { return instance.starts[r] == instance.goals[r] ? 0U : 1U; });
}

LowerBounds fromLandmarks(const Instance &instance, const Landmarks &landmarks)
{
    const auto atLeast = [&](Robot r) -> std::uint64_t
    {
        const Vertex start = instance.starts[r];
        const Vertex goal = instance.goals[r];
        return start == goal ? 0 : std::max(1U, landmarks.lowerBound(start, goal));
    };
    return together(instance, BoundMeans::landmarks, atLeast);
}

/// What is asked, and how long the answer may take.
struct Question
{
    const Instance &instance;
    const Supervision &supervision;
    std::uint64_t mostVisits;
};

/// Adds the distances of the robots [first, end) to the bounds. False where it had to stop.
template <class Search>
bool addDistances(const Question &question, Search &search, Robot first, Robot end, LowerBounds &bounds)
{
    const Instance &instance = question.instance;
    for (Robot r = first; r < end; ++r)
    {
        if (question.supervision.mustStop("lower bounds", r, instance.robotCount()))
            return false;
        const std::uint32_t distance = search.distance(instance.starts[r], instance.goals[r]);
        if (search.visits() > question.mostVisits)
            return false;
        bounds.pathLength += distance;
        bounds.makespan = std::max<std::uint64_t>(bounds.makespan, distance);
    }
    return true;
}

/// So many robots tell which kind of search visits less, and how much it would visit for all.
constexpr Robot kSample = 16;

/// The sum of all distances, where that can be had.
std::optional<LowerBounds> fromDistances(const Question &question, const Landmarks &landmarks)
{
    const Graph &graph = *question.instance.graph;
    const auto robots = static_cast<Robot>(question.instance.robotCount());
    LowerBounds bounds;
    LandmarkSearch guided(graph, landmarks);
    if (!addDistances(question, guided, 0, kSample, bounds))
        return std::nullopt;
    BidirectionalSearch meeting(graph);
    LowerBounds same;
    const bool meetingIsBetter =
        addDistances({question.instance, question.supervision, guided.visits()}, meeting, 0, kSample, same);
    const std::uint64_t sampled = meetingIsBetter ? meeting.visits() : guided.visits();
    if (sampled > question.mostVisits / robots * kSample)
        return std::nullopt;
    const bool done = meetingIsBetter ? addDistances(question, meeting, kSample, robots, bounds)
                                      : addDistances(question, guided, kSample, robots, bounds);
    return done ? std::optional(bounds) : std::nullopt;
}

bool everyGoalIsReachable(const Instance &instance)
{
    const Components components(*instance.graph);
    for (Robot r = 0; r < instance.robotCount(); ++r)
        if (components.of(instance.starts[r]) != components.of(instance.goals[r]))
            return false;
    return true;
}

} // namespace

const char *toString(BoundMeans means)
{
    switch (means)
    {
    case BoundMeans::displaced:
        return "displaced";
    case BoundMeans::landmarks:
        return "landmarks";
    case BoundMeans::distances:
        return "distances";
    }
    return "";
}

std::optional<LowerBounds> lowerBounds(const Instance &instance, const Supervision &supervision,
                                       std::uint64_t mostVisits)
{
    if (supervision.stop())
        return fromDisplaced(instance);
    if (!everyGoalIsReachable(instance))
        return std::nullopt;
    const Question question{instance, supervision, mostVisits};
    if (instance.robotCount() <= kSample)
    {
        LowerBounds bounds;
        BidirectionalSearch search(*instance.graph);
        const auto robots = static_cast<Robot>(instance.robotCount());
        return addDistances(question, search, 0, robots, bounds) ? bounds : fromDisplaced(instance);
    }
    const Landmarks landmarks(*instance.graph, supervision.stop);
    const auto distances = fromDistances(question, landmarks);
    return distances ? *distances : fromLandmarks(instance, landmarks);
}

} // namespace mrpp

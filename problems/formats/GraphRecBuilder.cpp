#include "problems/formats/GraphRecBuilder.h"

#include "problems/formats/support/TextReader.h"

#include <algorithm>

namespace mrpp
{

std::optional<std::string> GraphRecBuilder::addVertex(std::int64_t id)
{
    if (!vertices_.emplace(id, static_cast<Vertex>(vertices_.size())).second)
        return "vertex " + std::to_string(id) + " is there already";
    return std::nullopt;
}

std::optional<std::string> GraphRecBuilder::setStart(std::int64_t vertex, std::int64_t robot)
{
    const auto place = this->vertex(vertex);
    if (!place)
        return missing(vertex);
    if (robot > 0 && !starts_.emplace(robot, *place).second)
        return "robot " + std::to_string(robot) + " stands on another vertex already";
    return std::nullopt;
}

std::optional<std::string> GraphRecBuilder::setGoal(std::int64_t vertex, std::int64_t robot)
{
    const auto place = this->vertex(vertex);
    if (!place)
        return missing(vertex);
    if (robot > 0 && !goals_.emplace(robot, *place).second)
        return "robot " + std::to_string(robot) + " has a goal on another vertex already";
    return std::nullopt;
}

std::optional<std::string> GraphRecBuilder::setPosition(std::int64_t vertex, double x, double y)
{
    const auto place = this->vertex(vertex);
    if (!place)
        return missing(vertex);
    points_.resize(vertices_.size());
    hasPoint_.resize(vertices_.size());
    if (hasPoint_[*place])
        return "vertex " + std::to_string(vertex) + " has a position already";
    hasPoint_[*place] = true;
    points_[*place] = {x, y, 0};
    ++pointCount_;
    return std::nullopt;
}

std::optional<std::string> GraphRecBuilder::addEdge(std::int64_t a, std::int64_t b)
{
    const auto first = vertex(a);
    const auto second = vertex(b);
    if (!first || !second)
        return missing(first ? b : a);
    edges_.push_back({*first, *second});
    return std::nullopt;
}

std::optional<std::string> GraphRecBuilder::addMove(std::int64_t step, std::int64_t from, std::int64_t to,
                                                    std::size_t line)
{
    const auto source = vertex(from);
    const auto target = vertex(to);
    if (!source || !target)
        return missing(source ? to : from);
    if (step < 0)
        return "step " + std::to_string(step) + " comes before the first, which is 0";
    result_.moves.push_back({step, *source, *target, static_cast<std::uint32_t>(line)});
    return std::nullopt;
}

GraphRecFile GraphRecBuilder::take()
{
    if (pointCount_ > 0 && pointCount_ < vertices_.size())
    {
        result_.warnings.push_back("only " + std::to_string(pointCount_) + " of " +
                                   std::to_string(vertices_.size()) +
                                   " vertices have positions; all are left out");
        points_.clear();
    }
    result_.graph = Graph::fromEdges(vertices_.size(), edges_, std::move(points_), YAxis::down);
    if (result_.graph->edgeCount() < edges_.size())
        result_.warnings.push_back(counted(edges_.size() - result_.graph->edgeCount(),
                                           "loop or repeated edge is", "loops or repeated edges are") +
                                   " left out");
    for (const auto &[robot, start] : starts_)
        result_.starts.push_back(start);
    const bool goalsFit = starts_.size() == goals_.size() &&
                          std::equal(starts_.begin(), starts_.end(), goals_.begin(),
                                     [](const auto &a, const auto &b) { return a.first == b.first; });
    if (goalsFit)
        for (const auto &[robot, goal] : goals_)
            result_.goals.push_back(goal);
    return std::move(result_);
}

std::optional<Vertex> GraphRecBuilder::vertex(std::int64_t id) const
{
    const auto found = vertices_.find(id);
    return found == vertices_.end() ? std::nullopt : std::optional(found->second);
}

std::string GraphRecBuilder::missing(std::int64_t id)
{
    return "there is no vertex " + std::to_string(id);
}

} // namespace mrpp

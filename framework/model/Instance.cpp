#include "framework/model/Instance.h"

#include "framework/support/Fingerprint.h"

namespace mrpp
{

double Instance::occupancy() const
{
    const std::size_t vertices = graph->vertexCount();
    return vertices == 0 ? 0 : static_cast<double>(robotCount()) / static_cast<double>(vertices);
}

std::optional<std::string> Instance::defect() const
{
    if (!graph)
        return "there is no graph";
    if (starts.size() != goals.size())
        return std::to_string(starts.size()) + " starts but " + std::to_string(goals.size()) + " goals";
    std::vector<Robot> owner;
    const auto check = [&](const std::vector<Vertex> &vertices,
                           const char *role) -> std::optional<std::string>
    {
        owner.assign(graph->vertexCount(), kNoRobot);
        for (Robot r = 0; r < vertices.size(); ++r)
        {
            const Vertex v = vertices[r];
            if (v >= graph->vertexCount())
                return "robot " + std::to_string(r) + "'s " + role + " is vertex " + std::to_string(v) +
                       (graph->vertexCount() == 0 ? ", but the graph has no vertices"
                                                  : ", but the graph's vertices are numbered from 0 to " +
                                                        std::to_string(graph->vertexCount() - 1));
            if (owner[v] != kNoRobot)
                return "robots " + std::to_string(owner[v]) + " and " + std::to_string(r) +
                       " have the same " + role + ", vertex " + std::to_string(v);
            owner[v] = r;
        }
        return std::nullopt;
    };
    if (auto complaint = check(starts, "start"))
        return complaint;
    return check(goals, "goal");
}

std::string Instance::fingerprint() const
{
    return Fingerprint().add(graph->fingerprint()).add(std::span(starts)).add(std::span(goals)).hex();
}

} // namespace mrpp

#include "tests/support/ConfigurationOrbits.h"

#include "tests/support/SmallGraphs.h"

#include <algorithm>
#include <utility>

namespace mrpp::test
{

ConfigurationOrbits::ConfigurationOrbits(const Graph &graph, std::size_t robots, MotionRule rule)
    : graph_(graph)
{
    if (rule == MotionRule::rotation)
        cycles_ = simpleCycles(graph);
    std::size_t codes = 1;
    for (std::size_t i = 0; i < robots; ++i)
        codes *= graph.vertexCount();
    orbits_.assign(codes, kUnseen);
    std::vector<Vertex> positions;
    enumerate(positions, robots);
    std::uint32_t orbit = 0;
    for (const auto &configuration : configurations_)
        if (of(configuration) == kUnseen)
            flood(configuration, orbit++);
}

std::size_t ConfigurationOrbits::code(std::span<const Vertex> positions) const
{
    std::size_t code = 0;
    for (const Vertex v : positions)
        code = code * graph_.vertexCount() + v;
    return code;
}

void ConfigurationOrbits::enumerate(std::vector<Vertex> &positions, std::size_t robots)
{
    if (positions.size() == robots)
    {
        configurations_.push_back(positions);
        return;
    }
    for (Vertex v = 0; v < graph_.vertexCount(); ++v)
    {
        if (std::ranges::find(positions, v) != positions.end())
            continue;
        positions.push_back(v);
        enumerate(positions, robots);
        positions.pop_back();
    }
}

void ConfigurationOrbits::reach(const std::vector<Vertex> &positions, std::uint32_t orbit)
{
    std::uint32_t &known = orbits_[code(positions)];
    if (known != kUnseen)
        return;
    known = orbit;
    open_.push_back(positions);
}

void ConfigurationOrbits::flood(const std::vector<Vertex> &first, std::uint32_t orbit)
{
    reach(first, orbit);
    std::vector<Robot> occupant(graph_.vertexCount());
    while (!open_.empty())
    {
        std::vector<Vertex> now = std::move(open_.back());
        open_.pop_back();
        std::ranges::fill(occupant, kNoRobot);
        for (Robot robot = 0; robot < now.size(); ++robot)
            occupant[now[robot]] = robot;
        for (Vertex &position : now)
        {
            const Vertex from = position;
            for (const Vertex v : graph_.neighbors(from))
            {
                if (occupant[v] != kNoRobot)
                    continue;
                position = v;
                reach(now, orbit);
            }
            position = from;
        }
        for (const auto &cycle : cycles_)
        {
            if (!std::ranges::all_of(cycle, [&](Vertex v) { return occupant[v] != kNoRobot; }))
                continue;
            std::vector<Vertex> turned = now; // one direction is enough: turns have finite order
            for (std::size_t i = 0; i < cycle.size(); ++i)
                turned[occupant[cycle[i]]] = cycle[(i + 1) % cycle.size()];
            reach(turned, orbit);
        }
    }
}

} // namespace mrpp::test

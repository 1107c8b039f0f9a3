#include "tests/problems/FormatCases.h"

namespace mrpp
{

std::shared_ptr<const Graph> randomCells()
{
    const auto width = *rc::gen::inRange<std::size_t>(1, 7);
    const auto height = *rc::gen::inRange<std::size_t>(1, 7);
    const auto walls = *rc::gen::container<std::vector<int>>(width * height, rc::gen::inRange(0, 4));
    std::vector<Vertex> vertexAt(width * height, kNoVertex);
    std::vector<Point> points;
    std::vector<Graph::Edge> edges;
    for (std::size_t cell = 0; cell < walls.size(); ++cell)
    {
        if (walls[cell] == 0 && cell != 0)
            continue;
        const auto v = static_cast<Vertex>(points.size());
        vertexAt[cell] = v;
        points.push_back({static_cast<double>(cell % width), static_cast<double>(cell / width), 0});
        if (cell % width > 0 && vertexAt[cell - 1] != kNoVertex)
            edges.push_back({vertexAt[cell - 1], v});
        if (cell >= width && vertexAt[cell - width] != kNoVertex)
            edges.push_back({vertexAt[cell - width], v});
    }
    const std::size_t count = points.size();
    return Graph::fromEdges(count, edges, std::move(points), YAxis::down);
}

std::shared_ptr<const Graph> randomGraph()
{
    const auto count = *rc::gen::inRange<Vertex>(1, 30);
    const auto ends = *rc::gen::container<std::vector<std::pair<Vertex, Vertex>>>(
        rc::gen::pair(rc::gen::inRange<Vertex>(0, count), rc::gen::inRange<Vertex>(0, count)));
    std::vector<Graph::Edge> edges;
    for (const auto &[a, b] : ends)
        edges.push_back({a, b});
    return Graph::fromEdges(count, edges);
}

Case randomCase(std::shared_ptr<const Graph> graph)
{
    const auto count = static_cast<Vertex>(graph->vertexCount());
    Case result;
    std::vector<Robot> occupant(count, kNoRobot);
    const auto robots = *rc::gen::inRange<Vertex>(0, count);
    for (Vertex tries = 0; tries < robots; ++tries)
    {
        const auto v = *rc::gen::inRange<Vertex>(0, count);
        if (occupant[v] != kNoRobot)
            continue;
        occupant[v] = static_cast<Robot>(result.instance.starts.size());
        result.instance.starts.push_back(v);
    }
    std::vector<Vertex> positions = result.instance.starts;
    const auto steps = *rc::gen::inRange(0, 8);
    for (int step = 0; step < steps && !positions.empty(); ++step)
    {
        std::vector<Move> moves;
        const auto wishes = *rc::gen::container<std::vector<std::size_t>>(
            positions.size(), rc::gen::inRange<std::size_t>(0, 1000));
        for (Robot robot = 0; robot < positions.size(); ++robot)
        {
            const auto neighbors = graph->neighbors(positions[robot]);
            if (neighbors.empty() || wishes[robot] % 3 == 0)
                continue;
            const Vertex to = neighbors[wishes[robot] % neighbors.size()];
            if (occupant[to] != kNoRobot)
                continue; // what was left earlier in this step may be entered: following
            moves.push_back({robot, positions[robot], to});
            occupant[positions[robot]] = kNoRobot;
            occupant[to] = robot;
            positions[robot] = to;
        }
        if (!moves.empty())
            result.schedule.appendStep(moves);
    }
    result.instance.goals = positions;
    result.instance.graph = std::move(graph);
    return result;
}

} // namespace mrpp

#include "reports/layouts/LayoutPicture.h"

#include "reports/layouts/GraphDrawing.h"
#include "reports/picture/Palette.h"

#include <algorithm>
#include <fmt/format.h>

namespace mrpp
{

namespace
{

constexpr std::size_t kColorsAnEdge = 4; // beyond that lines are too close to tell apart
constexpr const char *kCrowded = "#5a5a5a";

/// Who starts and who has to end at each vertex.
struct Roles
{
    std::vector<Robot> starting;
    std::vector<Robot> ending;

    explicit Roles(const Instance &instance)
        : starting(instance.graph->vertexCount(), kNoRobot), ending(starting)
    {
        for (Robot robot = 0; robot < instance.robotCount(); ++robot)
        {
            starting[instance.starts[robot]] = robot;
            ending[instance.goals[robot]] = robot;
        }
    }
};

void addRobots(GraphDrawing &drawing, const Instance &instance)
{
    const Roles roles(instance);
    const DrawingScale &scale = drawing.scale();
    for (Vertex v = 0; v < instance.graph->vertexCount(); ++v)
    {
        const auto set = [&](const char *name, const std::string &value)
        { drawing.setVertex(v, name, value); };
        const Robot starting = roles.starting[v];
        const Robot ending = roles.ending[v];
        std::string tooltip = fmt::format("vertex {}", v);
        std::string label;
        if (starting != kNoRobot)
        {
            tooltip += fmt::format(", start of robot {}", starting);
            label = std::to_string(starting);
            const std::string color = robotColor(starting);
            set("fillcolor", color);
            set("color", color);
            set("fontcolor", textColorOn(color));
        }
        if (ending != kNoRobot)
        {
            tooltip += fmt::format(", goal of robot {}", ending);
            label += fmt::format("{}⚑{}", label.empty() ? "" : "\\n", ending);
            set("color", robotColor(ending));
            set("penwidth", fmt::format("{}", scale.ring));
            if (starting == kNoRobot)
                set("fontcolor", "#202020");
        }
        set("tooltip", tooltip);
        if (!scale.numbers)
            continue;
        if (label.empty())
            label = std::to_string(v);
        else
            set("fontsize", starting != kNoRobot && ending != kNoRobot ? "8.5" : "11");
        set("label", label);
    }
}

void addRoutes(GraphDrawing &drawing, const Graph &graph, const Solution &solution)
{
    const auto users = edgeUsers(graph, solution, kColorsAnEdge + 1);
    for (std::size_t i = 0; i < users.size(); ++i)
    {
        if (users[i].empty())
            continue;
        std::string colors;
        std::string tooltip = users[i].size() == 1 ? "robot" : "robots";
        for (std::size_t k = 0; k < std::min(users[i].size(), kColorsAnEdge); ++k)
        {
            colors += (k == 0 ? "" : ":") + robotColor(users[i][k]);
            tooltip += fmt::format("{} {}", k == 0 ? "" : ",", users[i][k]);
        }
        if (users[i].size() > kColorsAnEdge)
        {
            colors = kCrowded;
            tooltip += " and others";
            drawing.setEdge(i, "penwidth", fmt::format("{}", 2 * drawing.scale().route));
        }
        drawing.setEdge(i, "color", colors);
        drawing.setEdge(i, "tooltip", tooltip);
    }
}

void addLegend(GraphDrawing &drawing, const Instance &instance, const Solution *solution)
{
    if (instance.robotCount() == 0)
        return;
    const bool numbers = drawing.scale().numbers;
    const std::string color = robotColor(0);
    drawing.explainVertex({{"fillcolor", color}, {"color", color}},
                          numbers ? "start, with the robot's number" : "start of a robot");
    drawing.explainVertex({{"color", color}, {"penwidth", fmt::format("{}", drawing.scale().ring)}},
                          numbers ? "goal, ⚑ with the robot's number" : "goal, a ring of the robot's colour");
    if (solution == nullptr || solution->empty())
        return;
    drawing.explainEdge({{"color", color}}, "route, in the robot's colour");
    if (instance.robotCount() > kColorsAnEdge)
        drawing.explainEdge({{"color", kCrowded}, {"penwidth", fmt::format("{}", 2 * drawing.scale().route)}},
                            fmt::format("routes of more than {} robots", kColorsAnEdge));
}

} // namespace

std::vector<std::vector<Robot>> edgeUsers(const Graph &graph, const Solution &solution, std::size_t limit)
{
    std::vector<std::size_t> edgeOfArc; // the position in Graph::edges() of each arc
    edgeOfArc.reserve(2 * graph.edgeCount());
    std::size_t edges = 0;
    for (Vertex v = 0; v < graph.vertexCount(); ++v)
        for (const Vertex w : graph.neighbors(v))
            edgeOfArc.push_back(v < w ? edges++ : 0);
    std::vector<std::vector<Robot>> users(edges);
    for (const Move &move : solution.moves())
    {
        const auto arc = graph.arc(std::min(move.from, move.to), std::max(move.from, move.to));
        if (!arc)
            continue;
        std::vector<Robot> &robots = users[edgeOfArc[*arc]];
        if (robots.size() < limit && std::find(robots.begin(), robots.end(), move.robot) == robots.end())
            robots.push_back(move.robot);
    }
    return users;
}

Picture drawInstance(const Instance &instance, const Solution *solution, const Placement &placement,
                     const std::string &title)
{
    if (instance.graph->vertexCount() > kLargestGraph)
        return drawMap(instance, solution, placement, title);
    GraphDrawing drawing(*instance.graph, placement);
    addRobots(drawing, instance);
    if (solution != nullptr)
        addRoutes(drawing, *instance.graph, *solution);
    addLegend(drawing, instance, solution);
    return drawing.render(title);
}

} // namespace mrpp

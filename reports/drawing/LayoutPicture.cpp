#include "reports/drawing/LayoutPicture.h"

#include "reports/drawing/GraphvizGraph.h"
#include "reports/drawing/Palette.h"
#include "reports/drawing/Text.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace mrpp
{

namespace
{

/// How large things are drawn: graphs of few vertices with numbers, large ones small and without.
struct Scale
{
    bool numbers = false;
    double spacing = 0;  ///< points between neighbours
    double diameter = 0; ///< points, of a vertex
    double ring = 0;     ///< points, width of a goal's ring
    double route = 0;    ///< points, width of a route
};

Scale scaleFor(std::size_t vertices)
{
    constexpr std::size_t kNumbered = 400;
    constexpr std::size_t kMedium = 1500;
    if (vertices <= kNumbered)
        return {true, 58, 31, 3, 2};
    if (vertices <= kMedium)
        return {false, 24, 13, 2.2, 1.4};
    return {false, 14, 8, 1.6, 1};
}

constexpr double kDiameters = 0.6; ///< of a vertex and the gap beside it, in spacings

std::string inches(double points)
{
    return fmt::format("{:.4f}", points / 72);
}

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

class InstanceDrawing
{
public:
    InstanceDrawing(const Instance &instance, const Solution *solution, const Placement &placement,
                    const Scale &scale)
        : instance_(instance), roles_(instance), placement_(placement), scale_(scale)
    {
        addDefaults();
        for (Vertex v = 0; v < instance.graph->vertexCount(); ++v)
            addVertex(v);
        addEdges(solution);
    }

    Picture render(const std::string &title)
    {
        drawing_.setDefault(GraphvizGraph::Kind::graph, "label", GraphvizGraph::escaped("\n" + title));
        return drawing_.renderPinned(resolution());
    }

private:
    const Instance &instance_;
    Roles roles_;
    const Placement &placement_;
    Scale scale_;
    GraphvizGraph drawing_;

    void addDefaults()
    {
        using Kind = GraphvizGraph::Kind;
        const auto set = [this](Kind kind, const char *name, const std::string &value)
        { drawing_.setDefault(kind, name, value); };
        set(Kind::graph, "splines", "line");
        set(Kind::graph, "outputorder", "edgesfirst");
        set(Kind::graph, "bgcolor", "#ffffff");
        set(Kind::graph, "pad", "0.15");
        set(Kind::graph, "labelloc", "b");
        set(Kind::graph, "fontname", "DejaVu Sans");
        set(Kind::graph, "fontsize", "12");
        set(Kind::graph, "fontcolor", "#202020");
        set(Kind::node, "shape", "circle");
        set(Kind::node, "fixedsize", "true");
        set(Kind::node, "style", "filled");
        set(Kind::node, "fontname", "DejaVu Sans");
        set(Kind::node, "label", "");
        set(Kind::node, "width", inches(scale_.diameter));
        set(Kind::node, "fillcolor", "#ffffff");
        set(Kind::node, "color", "#9a9a9a");
        set(Kind::node, "penwidth", "1");
        set(Kind::node, "fontsize", "8");
        set(Kind::node, "fontcolor", "#8a8a8a");
        set(Kind::node, "pos", "0,0");
        set(Kind::node, "id", "");
        set(Kind::node, "tooltip", "");
        set(Kind::edge, "color", "#c4c4c4");
        set(Kind::edge, "penwidth", fmt::format("{}", scale_.route));
        set(Kind::edge, "id", "");
        set(Kind::edge, "tooltip", "");
    }

    void addVertex(Vertex v)
    {
        const std::size_t node = drawing_.addNode();
        const auto set = [&](const char *name, const std::string &value)
        { drawing_.setNode(node, name, value); };
        const Point &position = placement_.positions[v];
        set("pos", fmt::format("{:.2f},{:.2f}", position.x, position.y));
        set("id", fmt::format("vertex{}", v));

        const Robot starting = roles_.starting[v];
        const Robot ending = roles_.ending[v];
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
            set("penwidth", fmt::format("{}", scale_.ring));
            if (starting == kNoRobot)
                set("fontcolor", "#202020");
        }
        set("tooltip", tooltip);
        if (!scale_.numbers)
            return;
        if (label.empty())
            label = std::to_string(v);
        else
            set("fontsize", starting != kNoRobot && ending != kNoRobot ? "8.5" : "11");
        set("label", label);
    }

    void addEdges(const Solution *solution)
    {
        constexpr std::size_t kColorsAnEdge = 4; // beyond that lines are too close to tell apart
        const std::vector<Graph::Edge> edges = instance_.graph->edges();
        const auto users =
            edgeUsers(*instance_.graph, solution != nullptr ? *solution : Solution(), kColorsAnEdge + 1);
        for (std::size_t i = 0; i < edges.size(); ++i)
        {
            const std::size_t edge = drawing_.addEdge(edges[i].a, edges[i].b);
            drawing_.setEdge(edge, "id", fmt::format("edge{}-{}", edges[i].a, edges[i].b));
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
                colors = "#5a5a5a";
                tooltip += " and others";
                drawing_.setEdge(edge, "penwidth", fmt::format("{}", 2 * scale_.route));
            }
            drawing_.setEdge(edge, "color", colors);
            drawing_.setEdge(edge, "tooltip", tooltip);
        }
    }

    /// Dots per inch of the PNG: as for print, but large drawings stay below about 2400 pixels.
    [[nodiscard]] int resolution() const
    {
        constexpr double kPixels = 2400;
        double extent = 1;
        for (const Point &position : placement_.positions)
            extent = std::max({extent, std::abs(position.x), std::abs(position.y)});
        return static_cast<int>(std::clamp(kPixels / (extent / 72), 72.0, 300.0));
    }
};

} // namespace

namespace
{

/// What a tenth of the places have their nearest one within. \param places sorted
double crampedDistance(const std::vector<std::pair<double, double>> &places)
{
    std::vector<double> nearest;
    for (std::size_t i = 0; i < places.size(); ++i)
    {
        double least = std::numeric_limits<double>::infinity();
        const auto isBeyond = [&](std::size_t j)
        {
            const double across = places[j].first - places[i].first;
            least = std::min(least, std::hypot(across, places[j].second - places[i].second));
            return std::abs(across) > least;
        };
        for (std::size_t j = i; j-- > 0 && !isBeyond(j);)
            ;
        for (std::size_t j = i + 1; j < places.size() && !isBeyond(j); ++j)
            ;
        nearest.push_back(least);
    }
    const auto tenth = nearest.begin() + static_cast<std::ptrdiff_t>(nearest.size() / 10);
    std::nth_element(nearest.begin(), tenth, nearest.end());
    return *tenth;
}

} // namespace

std::optional<Placement> placeByCoordinates(const Graph &graph, double spacing)
{
    if (!graph.hasCoordinates())
        return std::nullopt;
    std::vector<Point> positions(graph.coordinates().begin(), graph.coordinates().end());
    double least[2] = {positions.front().x, positions.front().y};
    double most[2] = {least[0], least[1]};
    const double up = graph.yAxis() == YAxis::down ? -1 : 1;
    for (Point &position : positions)
    {
        if (!std::isfinite(position.x) || !std::isfinite(position.y))
            return std::nullopt;
        position.y *= up;
        position.z = 0;
    }
    least[1] = most[1] = positions.front().y;
    for (const Point &position : positions)
    {
        least[0] = std::min(least[0], position.x);
        least[1] = std::min(least[1], position.y);
        most[0] = std::max(most[0], position.x);
        most[1] = std::max(most[1], position.y);
    }

    std::vector<std::pair<double, double>> places;
    places.reserve(positions.size());
    for (const Point &position : positions)
        places.emplace_back(position.x, position.y);
    std::sort(places.begin(), places.end());
    if (std::adjacent_find(places.begin(), places.end()) != places.end())
        return std::nullopt;

    std::vector<double> lengths;
    for (const Graph::Edge &edge : graph.edges())
        lengths.push_back(
            std::hypot(positions[edge.a].x - positions[edge.b].x, positions[edge.a].y - positions[edge.b].y));
    double unit = 1;
    if (!lengths.empty())
    {
        const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
        std::nth_element(lengths.begin(), middle, lengths.end());
        unit = *middle;
    }
    if (places.size() <= kLargestGraph)
        unit = std::min(unit, std::max(unit / 2, crampedDistance(places) / kDiameters));
    constexpr double kLargestPage = 14000; // points; PDF ends at 200 inches
    const double extent = std::max({most[0] - least[0], most[1] - least[1], unit});
    const double factor = std::min(spacing / unit, kLargestPage / extent);
    for (Point &position : positions)
    {
        position.x = (position.x - least[0]) * factor;
        position.y = (position.y - least[1]) * factor;
    }
    return Placement{std::move(positions), unit * factor};
}

Placement placeByEngine(const Graph &graph, double spacing, double diameter)
{
    if (graph.vertexCount() > kLargestForceLayout)
        throw DrawingError(fmt::format("{} vertices without coordinates are too many for Graphviz to arrange "
                                       "(at most {})",
                                       graph.vertexCount(), kLargestForceLayout));
    GraphvizGraph drawing;
    drawing.setDefault(GraphvizGraph::Kind::graph, "overlap", "prism");
    drawing.setDefault(GraphvizGraph::Kind::graph, "start", "1");
    drawing.setDefault(GraphvizGraph::Kind::graph, "K", inches(spacing));
    drawing.setDefault(GraphvizGraph::Kind::node, "shape", "circle");
    drawing.setDefault(GraphvizGraph::Kind::node, "fixedsize", "true");
    drawing.setDefault(GraphvizGraph::Kind::node, "label", "");
    drawing.setDefault(GraphvizGraph::Kind::node, "width", inches(diameter * 1.4));
    drawing.setDefault(GraphvizGraph::Kind::edge, "len", inches(spacing));
    for (Vertex v = 0; v < graph.vertexCount(); ++v)
        drawing.addNode();
    for (const Graph::Edge &edge : graph.edges())
        drawing.addEdge(edge.a, edge.b);
    return {drawing.arrange(graph.vertexCount() <= kLargestSpringLayout ? "neato" : "sfdp"), spacing};
}

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

Picture drawInstance(const Instance &instance, const Solution *solution, const std::string &title)
{
    const Graph &graph = *instance.graph;
    if (graph.vertexCount() == 0)
        throw DrawingError("the graph has no vertices");
    const Scale scale = scaleFor(graph.vertexCount());
    std::optional<Placement> placement = placeByCoordinates(graph, scale.spacing);
    if (graph.vertexCount() > kLargestGraph)
    {
        if (!placement)
            throw DrawingError(
                fmt::format("{} vertices are too many for Graphviz (at most {}), and there are "
                            "no coordinates to draw a map from",
                            graph.vertexCount(), kLargestGraph));
        return drawMap(instance, solution, *placement, title);
    }
    if (!placement)
        placement = placeByEngine(graph, scale.spacing, scale.diameter);
    return InstanceDrawing(instance, solution, *placement, scale).render(title);
}

} // namespace mrpp

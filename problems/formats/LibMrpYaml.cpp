/// The reader and writer of instances; schedules are in LibMrpSchedule.cpp.

#include "problems/formats/LibMrpYaml.h"

#include "problems/formats/FormatId.h"
#include "problems/formats/LibMrpVertices.h"
#include "problems/formats/support/Cells.h"
#include "problems/formats/support/TextReader.h"
#include "problems/formats/support/TextWriter.h"
#include "problems/formats/support/YamlTree.h"

#include <algorithm>
#include <unordered_map>
#include <unordered_set>

namespace mrpp
{

namespace
{

class InstanceReader
{
public:
    InstanceReader(std::string_view text, const std::string &file) : tree_(text, file) {}

    LibMrpInstance read()
    {
        const Config &root = tree_.root();
        if (const Config *environment = root.find("environment"))
            return readSipp(*environment);
        const Config *map = root.find("map");
        const Config *roadmap = root.find("roadmap");
        if (map == nullptr && roadmap == nullptr)
            tree_.fail(root, "this YAML holds neither a 'map' nor a 'roadmap'");
        if (map != nullptr && roadmap != nullptr)
            tree_.fail(*roadmap, "there is a 'map' already; expected one of the two");
        tree_.allowKeys(root, {"map", "roadmap", "agents", "dynamic_obstacles"});
        refuseUnlessEmpty(root, "dynamic_obstacles", "obstacles that move are not known here");
        auto graph = map != nullptr ? readMap(*map, "dimensions") : readRoadmap(*roadmap);
        InstanceBuilder builder(std::move(graph), tree_.file());
        std::vector<std::string> names;
        for (const Config &agent : tree_.items(tree_.get(root, "agents"), "agents"))
        {
            addRobot(builder, agent, goalOf(agent));
            if (const Config *name = agent.find("name"); name != nullptr && name->isScalar())
                names.push_back(name->text());
        }
        LibMrpInstance result{
            builder.take(), std::move(map_), std::move(vertexNames_), {}, std::move(warnings_)};
        if (areNames(names, result.instance.robotCount()))
            result.robotNames = std::move(names);
        return result;
    }

private:
    void refuseUnlessEmpty(const Config &map, const char *key, const char *why) const
    {
        if (const Config *value = map.find(key); value != nullptr && !YamlDocument::isEmpty(*value))
            tree_.fail(*value, why);
    }

    /// The one goal of a robot, be it the only one that it may choose from.
    const Config &goalOf(const Config &agent) const
    {
        const Config *choices = agent.isMap() ? agent.find("potentialGoals") : nullptr;
        if (choices == nullptr)
            return tree_.get(agent, "goal");
        const auto &goals = tree_.items(*choices, "goals");
        if (goals.empty())
            tree_.fail(*choices, "this robot has no goal; here every robot has one");
        if (goals.size() > 1 || agent.find("goal") != nullptr)
            tree_.fail(*choices, "this robot may choose its goal; here every robot has one 'goal'");
        return goals.front();
    }

    void addRobot(InstanceBuilder &builder, const Config &agent, const Config &goal) const
    {
        tree_.allowKeys(agent, {"name", "start", "goal", "potentialGoals"});
        const Config &start = tree_.get(agent, "start");
        builder.addStart(vertex(start, "start"), start.where().line, start.where().column);
        builder.addGoal(vertex(goal, "goal"), goal.where().line, goal.where().column);
    }

    /// Whether these names tell the robots apart, and are others than agent0, agent1, ….
    static bool areNames(const std::vector<std::string> &names, std::size_t robots)
    {
        bool usual = true;
        for (std::size_t robot = 0; robot < names.size(); ++robot)
            usual = usual && names[robot] == "agent" + std::to_string(robot);
        return names.size() == robots && !usual &&
               std::unordered_set<std::string>(names.begin(), names.end()).size() == names.size();
    }

    /// One robot among moving obstacles, none of which may be there.
    LibMrpInstance readSipp(const Config &environment)
    {
        tree_.allowKeys(tree_.root(), {"start", "goal", "environment"});
        tree_.allowKeys(environment, {"size", "obstacles", "collisionIntervals"});
        if (const Config *moving = environment.find("collisionIntervals"))
            for (const Config &interval : tree_.items(*moving, "places and times"))
                if (!YamlDocument::isEmpty(tree_.get(interval, "intervals")))
                    tree_.fail(interval,
                               "this is an input of the program sipp with obstacles that move, which "
                               "are not known here");
        InstanceBuilder builder(readMap(environment, "size"), tree_.file());
        const Config &start = tree_.get(tree_.root(), "start");
        const Config &goal = tree_.get(tree_.root(), "goal");
        builder.addStart(vertex(start, "start"), start.where().line, start.where().column);
        builder.addGoal(vertex(goal, "goal"), goal.where().line, goal.where().column);
        return {builder.take(), std::move(map_), {}, {"agent1"}, {}};
    }

    std::shared_ptr<const Graph> readMap(const Config &map, const char *sizeKey)
    {
        constexpr std::int64_t mostCells = 1 << 21;
        const Config &dimensions = tree_.get(map, sizeKey);
        const auto [width, height] = tree_.point(dimensions);
        if (width < 1 || height < 1 || width > mostCells || height > mostCells || width * height > mostCells)
            tree_.fail(dimensions,
                       "expected [columns, rows] of 1 to " + std::to_string(mostCells) + " cells altogether");
        tree_.allowKeys(map, {sizeKey, "obstacles", "collisionIntervals"});
        width_ = width;
        height_ = height;
        std::string cells(static_cast<std::size_t>(width * height), '.');
        if (const Config *obstacles = map.find("obstacles"))
            for (const Config &obstacle : tree_.items(*obstacles, "obstacles"))
            {
                const auto [x, y] = tree_.point(obstacle);
                if (x < 0 || y < 0 || x >= width || y >= height)
                    tree_.fail(obstacle, "the obstacle " + cellName(x, y) + " is outside the map");
                cells[static_cast<std::size_t>(y * width + x)] = '@';
            }
        map_ = makeGridMap(static_cast<std::size_t>(width), static_cast<std::size_t>(height),
                           std::move(cells), passability(), YAxis::up); // as their own plots are drawn
        return map_->graph;
    }

    std::shared_ptr<const Graph> readRoadmap(const Config &roadmap)
    {
        if (!roadmap.isMap())
            tree_.fail(roadmap, "expected a map with the keys 'vertices' and 'edges'");
        tree_.allowKeys(roadmap, {"undirected", "allow_wait_actions", "vertices", "edges", "conflicts"});
        std::vector<Point> points;
        const Config *vertices = roadmap.find("vertices");
        if (vertices != nullptr)
            points = readVertices(*vertices);
        std::vector<Graph::Edge> edges;
        const auto end = [&](const Config &name)
        {
            if (vertices == nullptr && name.isScalar())
                addName(name.text());
            return named(name);
        };
        for (const Config &edge : tree_.items(tree_.get(roadmap, "edges"), "edges"))
        {
            const auto &[a, b] = tree_.pair(edge, "[name, name]");
            const Vertex from = end(a);
            edges.push_back({from, end(b)});
        }
        if (const Config *conflicts = roadmap.find("conflicts"))
            for (const Config &others : tree_.items(*conflicts, "conflicts of edges"))
                if (!YamlDocument::isEmpty(others))
                    tree_.fail(others,
                               "this edge has conflicts with others, which are not known here: they would "
                               "change the problem");
        warnAboutRules(roadmap, edges);
        return Graph::fromEdges(vertexNames_.size(), edges, std::move(points));
    }

    /// Points, or nothing where no vertex has one.
    std::vector<Point> readVertices(const Config &vertices)
    {
        if (!vertices.isMap() && !YamlDocument::isEmpty(vertices))
            tree_.fail(vertices, "expected a map of names to points, 'A: [0, 0]'");
        std::vector<Point> points;
        for (const Config::Entry &entry : vertices.entries())
        {
            addName(entry.key);
            if (YamlDocument::isEmpty(entry.value) && points.empty())
                continue;
            const auto &[x, y] = tree_.pair(entry.value, "[x, y]");
            points.push_back({tree_.number(x, "x"), tree_.number(y, "y"), 0});
            if (points.size() != vertexNames_.size())
                tree_.fail(entry.value, "this vertex has a point, but those before have none");
        }
        return points;
    }

    void addName(const std::string &name)
    {
        if (names_.emplace(name, static_cast<Vertex>(vertexNames_.size())).second)
            vertexNames_.push_back(name);
    }

    /// A roadmap may be directed and forbid waiting; neither is known here.
    void warnAboutRules(const Config &roadmap, const std::vector<Graph::Edge> &edges)
    {
        std::vector<std::pair<Vertex, Vertex>> arcs;
        for (const Graph::Edge &edge : edges)
            arcs.emplace_back(edge.a, edge.b);
        std::sort(arcs.begin(), arcs.end());
        const auto has = [&arcs](Vertex a, Vertex b)
        { return std::binary_search(arcs.begin(), arcs.end(), std::pair(a, b)); };
        const Config *undirected = roadmap.find("undirected");
        const bool isDirected = undirected != nullptr && !tree_.flag(*undirected);
        if (isDirected && std::any_of(arcs.begin(), arcs.end(),
                                      [&](const auto &arc) { return !has(arc.second, arc.first); }))
            warnings_.push_back("the roadmap is directed; here robots may go both ways along every edge");
        const Config *waits = roadmap.find("allow_wait_actions");
        const bool mayWait = waits == nullptr || tree_.flag(*waits);
        bool mayStay = true; // by an edge to itself
        for (Vertex v = 0; v < vertexNames_.size() && mayStay; ++v)
            mayStay = has(v, v);
        if (!mayWait && !mayStay)
            warnings_.push_back("the roadmap forbids waiting; here robots may wait");
    }

    Vertex named(const Config &node) const
    {
        const auto found = node.isScalar() ? names_.find(node.text()) : names_.end();
        if (found == names_.end())
            tree_.fail(node, node.isScalar() ? "there is no vertex " + inQuotes(node.text())
                                             : "expected a vertex's name");
        return found->second;
    }

    Vertex vertex(const Config &node, const char *role) const
    {
        if (!map_)
            return named(node);
        const auto [x, y] = tree_.point(node);
        if (x < 0 || y < 0 || x >= width_ || y >= height_)
            tree_.fail(node, std::string("the ") + role + " " + cellName(x, y) + " is outside the map");
        const Vertex v = map_->vertexAt(static_cast<std::size_t>(x), static_cast<std::size_t>(y));
        if (v == kNoVertex)
            tree_.fail(node, std::string("the ") + role + " " + cellName(x, y) + " is an obstacle");
        return v;
    }

    YamlDocument tree_;
    std::optional<GridMap> map_;
    std::int64_t width_ = 0;
    std::int64_t height_ = 0;
    std::unordered_map<std::string, Vertex> names_;
    std::vector<std::string> vertexNames_;
    std::vector<std::string> warnings_;
};

void writeRoadmap(TextWriter &out, const Graph &graph, const LibMrpVertices &vertices)
{
    out.line("roadmap:");
    out.line("  undirected: true");
    out.line("  allow_wait_actions: true");
    out.line(graph.vertexCount() > 0 ? "  vertices:" : "  vertices: {}");
    for (Vertex v = 0; v < graph.vertexCount(); ++v)
    {
        out.add("    ", vertices.text(v), ':');
        if (graph.hasCoordinates())
        {
            out.add(" [");
            out.addShortest(graph.coordinate(v).x);
            out.add(", ");
            out.addShortest(graph.coordinate(v).y);
            out.add(']');
        }
        out.line();
    }
    out.line(graph.edgeCount() > 0 ? "  edges:" : "  edges: []");
    for (const Graph::Edge &edge : graph.edges())
        out.line("    - [", vertices.text(edge.a), ", ", vertices.text(edge.b), ']');
}

void writeMap(TextWriter &out, const GridMap &map)
{
    out.line("map:");
    out.line("  dimensions: [", std::uint64_t{map.width}, ", ", std::uint64_t{map.height}, ']');
    out.line(map.graph->vertexCount() < map.cells.size() ? "  obstacles:" : "  obstacles: []");
    for (std::size_t y = 0; y < map.height; ++y)
        for (std::size_t x = 0; x < map.width; ++x)
            if (!map.passable(x, y))
                out.line("    - [", std::uint64_t{x}, ", ", std::uint64_t{y}, ']');
}

/// The map to write; none for a roadmap.
std::optional<GridMap> mapFor(const Instance &instance, const LibMrpNames &names, LibMrpForm form)
{
    if (form == LibMrpForm::roadmap || (form == LibMrpForm::fitting && !names.vertices.empty()))
        return std::nullopt;
    if (names.map != nullptr)
        return *names.map;
    return form == LibMrpForm::map ? gridMapOf(*instance.graph) : gridMapIfOne(*instance.graph);
}

} // namespace

LibMrpInstance parseLibMrpInstance(std::string_view text, const std::string &file)
{
    return readAs(FormatId::libMrpInstance, text, file, [&] { return InstanceReader(text, file).read(); });
}

std::string formatLibMrpInstance(const Instance &instance, const LibMrpNames &names, LibMrpForm form)
{
    TextWriter out;
    const Graph &graph = *instance.graph;
    const auto map = mapFor(instance, names, form);
    const LibMrpVertices vertices(graph.vertexCount(), names.vertices);
    if (map)
        writeMap(out, *map);
    else
        writeRoadmap(out, graph, vertices);
    const auto writePlace = [&](const char *key, Vertex v)
    {
        if (!map)
        {
            out.line("    ", key, ": ", vertices.text(v));
            return;
        }
        const Point &cell = graph.coordinate(v);
        out.line("    ", key, ": [", static_cast<std::uint64_t>(cell.x), ", ",
                 static_cast<std::uint64_t>(cell.y), ']');
    };
    out.line(instance.robotCount() > 0 ? "agents:" : "agents: []");
    for (std::size_t robot = 0; robot < instance.robotCount(); ++robot)
    {
        out.line("  - name: ", libMrpRobot(robot, names.robots));
        writePlace("start", instance.starts[robot]);
        writePlace("goal", instance.goals[robot]);
    }
    return out.take();
}

} // namespace mrpp

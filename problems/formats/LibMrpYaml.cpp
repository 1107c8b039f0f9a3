#include "problems/formats/LibMrpYaml.h"

#include "problems/formats/Cells.h"
#include "problems/formats/MovingAiMap.h"
#include "problems/formats/TextReader.h"
#include "problems/formats/TextWriter.h"
#include "problems/formats/YamlTree.h"

#include <nlohmann/json.hpp>
#include <optional>
#include <unordered_map>

namespace mrpp
{

namespace
{

/// The tree of a file, and how to take it apart with complaints at the right places.
class Tree
{
public:
    Tree(std::string_view text, const std::string &file) : file_(file), root_(parseYamlTree(text, file))
    {
        if (!root_.isMap())
            throw ParseError({file_, 1, 1}, "expected YAML with a map of keys at the top");
    }

    [[nodiscard]] const Config &root() const { return root_; }
    [[nodiscard]] const std::string &file() const { return file_; }

    [[noreturn]] void fail(const Config &node, const std::string &what) const
    {
        throw ParseError({file_, node.where().line, node.where().column}, what);
    }

    [[nodiscard]] const Config &get(const Config &map, const char *key) const
    {
        if (!map.isMap())
            fail(map, std::string("expected a map with the key '") + key + "'");
        const Config *value = map.find(key);
        if (value == nullptr)
            fail(map, std::string("the key '") + key + "' is missing");
        return *value;
    }

    [[nodiscard]] std::int64_t integer(const Config &node, const char *what) const
    {
        const auto value = node.isScalar() ? parseInteger(node.text()) : std::nullopt;
        if (!value)
            fail(node, "expected a whole number, the " + std::string(what));
        return *value;
    }

    /// Two items.
    [[nodiscard]] std::pair<const Config &, const Config &> pair(const Config &node, const char *form) const
    {
        if (!node.isList() || node.items().size() != 2)
            fail(node, "expected a list of two, " + std::string(form));
        return {node.items()[0], node.items()[1]};
    }

    /// Column and row.
    [[nodiscard]] std::pair<std::int64_t, std::int64_t> point(const Config &node) const
    {
        const auto &[x, y] = pair(node, "[column, row]");
        return {integer(x, "column"), integer(y, "row")};
    }

    /// The items of a list; none of a key without a value.
    [[nodiscard]] const std::vector<Config> &items(const Config &node, const char *what) const
    {
        if (!node.isList() && node.kind() != Config::Kind::empty)
            fail(node, "expected a list of " + std::string(what));
        return node.items();
    }

private:
    std::string file_;
    Config root_;
};

class InstanceReader
{
public:
    InstanceReader(std::string_view text, const std::string &file) : tree_(text, file) {}

    LibMrpInstance read()
    {
        const Config *map = tree_.root().find("map");
        const Config *roadmap = tree_.root().find("roadmap");
        if (map == nullptr && roadmap == nullptr)
            tree_.fail(tree_.root(), "there is neither a 'map' nor a 'roadmap'");
        if (map != nullptr && roadmap != nullptr)
            tree_.fail(*roadmap, "there is a 'map' already; expected one of the two");
        auto graph = map != nullptr ? readMap(*map) : readRoadmap(*roadmap);
        InstanceBuilder builder(std::move(graph), tree_.file());
        for (const Config &agent : tree_.items(tree_.get(tree_.root(), "agents"), "agents"))
        {
            if (agent.isMap() && agent.find("potentialGoals") != nullptr)
                tree_.fail(agent, "this robot may choose its goal; here every robot has one 'goal'");
            const Config &start = tree_.get(agent, "start");
            builder.addStart(vertex(start, "start"), start.where().line, start.where().column);
            const Config &goal = tree_.get(agent, "goal");
            builder.addGoal(vertex(goal, "goal"), goal.where().line, goal.where().column);
        }
        return {builder.take(), std::move(vertexNames_), std::move(warnings_)};
    }

private:
    std::shared_ptr<const Graph> readMap(const Config &map)
    {
        constexpr std::int64_t mostCells = 1 << 21;
        const Config &dimensions = tree_.get(map, "dimensions");
        const auto [width, height] = tree_.point(dimensions);
        if (width < 1 || height < 1 || width > mostCells || height > mostCells || width * height > mostCells)
            tree_.fail(dimensions,
                       "expected [columns, rows] of 1 to " + std::to_string(mostCells) + " cells altogether");
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
        const Config &vertices = tree_.get(roadmap, "vertices");
        if (!vertices.isMap())
            tree_.fail(vertices, "expected a map of names to points, 'A: [0, 0]'");
        std::vector<Point> points;
        for (const Config::Entry &entry : vertices.entries())
        {
            const auto &[x, y] = tree_.pair(entry.value, "[x, y]");
            names_.emplace(entry.key, static_cast<Vertex>(points.size()));
            vertexNames_.push_back(entry.key);
            points.push_back({number(x), number(y), 0});
        }
        std::vector<Graph::Edge> edges;
        for (const Config &edge : tree_.items(tree_.get(roadmap, "edges"), "edges"))
        {
            const auto &[a, b] = tree_.pair(edge, "[name, name]");
            edges.push_back({named(a), named(b)});
        }
        if (const Config *undirected = roadmap.find("undirected");
            undirected != nullptr && undirected->text() == "false")
            warnings_.push_back("the roadmap is directed; here robots may go both ways along every edge");
        if (const Config *waits = roadmap.find("allow_wait_actions");
            waits != nullptr && waits->text() == "false")
            warnings_.push_back("the roadmap forbids waiting; here robots may wait");
        const std::size_t count = points.size();
        return Graph::fromEdges(count, edges, std::move(points));
    }

    double number(const Config &node) const
    {
        const auto value = node.isScalar() ? parseNumber(node.text()) : std::nullopt;
        if (!value)
            tree_.fail(node, "expected a number, a coordinate");
        return *value;
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

    Tree tree_;
    std::optional<GridMap> map_;
    std::int64_t width_ = 0;
    std::int64_t height_ = 0;
    std::unordered_map<std::string, Vertex> names_;
    std::vector<std::string> vertexNames_;
    std::vector<std::string> warnings_;
};

std::optional<GridMap> mapOf(const Graph &graph)
{
    try
    {
        return gridMapOf(graph);
    }
    catch (const InputError &)
    {
        return std::nullopt;
    }
}

std::optional<Cells> cellsOf(const Graph &graph)
{
    try
    {
        return Cells(graph);
    }
    catch (const InputError &)
    {
        return std::nullopt;
    }
}

/// How a roadmap's vertices are called.
class VertexNames
{
public:
    VertexNames(std::size_t count, std::span<const std::string> names) : count_(count), names_(names)
    {
        for (const std::string &name : names)
            vertices_.emplace(name, static_cast<Vertex>(vertices_.size()));
    }

    /// kNoVertex where none is called so.
    [[nodiscard]] Vertex vertex(const std::string &name) const
    {
        if (!names_.empty())
        {
            const auto found = vertices_.find(name);
            return found == vertices_.end() ? kNoVertex : found->second;
        }
        const auto number = parseInteger(name);
        const bool isVertex = number && *number >= 0 && static_cast<std::uint64_t>(*number) < count_;
        return isVertex ? static_cast<Vertex>(*number) : kNoVertex;
    }

    /// As YAML; a text of JSON is one of YAML.
    [[nodiscard]] std::string text(Vertex v) const
    {
        return names_.empty()
                   ? std::to_string(v)
                   : nlohmann::json(names_[v]).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
    }

private:
    std::size_t count_;
    std::span<const std::string> names_;
    std::unordered_map<std::string, Vertex> vertices_;
};

void writeRoadmap(TextWriter &out, const Graph &graph, const VertexNames &names)
{
    if (graph.vertexCount() > 0 && !graph.hasCoordinates())
        throw InputError("a roadmap needs coordinates, but this graph has none");
    out.line("roadmap:");
    out.line("  undirected: true");
    out.line("  allow_wait_actions: true");
    out.line(graph.vertexCount() > 0 ? "  vertices:" : "  vertices: {}");
    for (Vertex v = 0; v < graph.vertexCount(); ++v)
    {
        out.add("    ", names.text(v), ": [");
        out.addShortest(graph.coordinate(v).x);
        out.add(", ");
        out.addShortest(graph.coordinate(v).y);
        out.line(']');
    }
    out.line(graph.edgeCount() > 0 ? "  edges:" : "  edges: []");
    for (const Graph::Edge &edge : graph.edges())
        out.line("    - [", names.text(edge.a), ", ", names.text(edge.b), ']');
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

} // namespace

LibMrpInstance parseLibMrpInstance(std::string_view text, const std::string &file)
{
    return InstanceReader(text, file).read();
}

std::string formatLibMrpInstance(const Instance &instance, std::span<const std::string> vertexNames)
{
    TextWriter out;
    const Graph &graph = *instance.graph;
    const auto map = vertexNames.empty() ? mapOf(graph) : std::nullopt;
    const VertexNames names(graph.vertexCount(), vertexNames);
    if (map)
        writeMap(out, *map);
    else
        writeRoadmap(out, graph, names);
    const auto writePlace = [&](const char *key, Vertex v)
    {
        if (!map)
        {
            out.line("    ", key, ": ", names.text(v));
            return;
        }
        const Point &cell = graph.coordinate(v);
        out.line("    ", key, ": [", static_cast<std::uint64_t>(cell.x), ", ",
                 static_cast<std::uint64_t>(cell.y), ']');
    };
    out.line(instance.robotCount() > 0 ? "agents:" : "agents: []");
    for (std::size_t robot = 0; robot < instance.robotCount(); ++robot)
    {
        out.line("  - name: agent", std::uint64_t{robot});
        writePlace("start", instance.starts[robot]);
        writePlace("goal", instance.goals[robot]);
    }
    return out.take();
}

SolutionRows parseLibMrpSchedule(std::string_view text, const std::string &file, const Instance &instance,
                                 std::span<const std::string> vertexNames)
{
    const Tree tree(text, file);
    const VertexNames names(instance.graph->vertexCount(), vertexNames);
    const Config &schedule = tree.get(tree.root(), "schedule");
    const auto cells = cellsOf(*instance.graph);
    const auto vertexOf = [&](const Config &state)
    {
        if (const Config *name = state.find("v"))
        {
            const Vertex v = name->isScalar() ? names.vertex(name->text()) : kNoVertex;
            if (v == kNoVertex)
                tree.fail(*name, name->isScalar() ? "there is no vertex " + inQuotes(name->text())
                                                  : "expected a vertex's name");
            return v;
        }
        const std::int64_t x = tree.integer(tree.get(state, "x"), "column");
        const std::int64_t y = tree.integer(tree.get(state, "y"), "row");
        const Vertex v = cells ? cells->vertexAt(x, y) : kNoVertex;
        if (v == kNoVertex)
            tree.fail(state, "the graph has no vertex on the cell " + cellName(x, y));
        return v;
    };

    std::vector<std::vector<PathPoint>> paths(instance.robotCount());
    if (!schedule.isMap() && instance.robotCount() > 0)
        tree.fail(schedule, "expected a map of robots, 'agent0: …'");
    for (const Config::Entry &entry : schedule.entries())
    {
        const std::string prefix = "agent";
        const std::int64_t robot =
            entry.key.starts_with(prefix) ? parseInteger(entry.key.substr(prefix.size())).value_or(-1) : -1;
        const SourceLocation where{file, entry.where.line, entry.where.column};
        if (robot < 0 || static_cast<std::uint64_t>(robot) >= paths.size())
            throw ParseError(where, inQuotes(entry.key) + " is none of the instance's " +
                                        std::to_string(paths.size()) + " robots, agent0, agent1, …");
        std::vector<PathPoint> &path = paths[static_cast<std::size_t>(robot)];
        if (!path.empty())
            throw ParseError(where, "robot " + std::to_string(robot) + " has a path already");
        for (const Config &state : tree.items(entry.value, "states"))
        {
            const Config &time = tree.get(state, "t");
            if (tree.integer(time, "time") != static_cast<std::int64_t>(path.size()))
                tree.fail(time, "expected the time " + std::to_string(path.size()) +
                                    "; times are 0, 1, 2, … in their order");
            path.push_back({vertexOf(state), static_cast<std::uint32_t>(state.where().line)});
        }
    }
    return rowsOfPaths(file, instance, paths);
}

std::string formatLibMrpSchedule(const Instance &instance, const Schedule &schedule,
                                 std::span<const std::string> vertexNames)
{
    const auto map = vertexNames.empty() ? mapOf(*instance.graph) : std::nullopt;
    const VertexNames names(instance.graph->vertexCount(), vertexNames);
    std::vector<std::vector<std::pair<std::size_t, Vertex>>> moves(instance.robotCount()); // (time, vertex)
    std::uint64_t cost = 0;
    for (std::size_t step = 0; step < schedule.makespan(); ++step)
        for (const Move &move : schedule.step(step))
            moves[move.robot].emplace_back(step + 1, move.to);
    for (const auto &path : moves)
        cost += path.empty() ? 0 : path.back().first;

    TextWriter out;
    out.line("statistics:");
    out.line("  cost: ", cost);
    out.line("  makespan: ", std::uint64_t{schedule.makespan()});
    out.line(instance.robotCount() > 0 ? "schedule:" : "schedule: {}");
    const auto writeState = [&](std::size_t time, Vertex v)
    {
        if (map)
        {
            const Point &cell = instance.graph->coordinate(v);
            out.line("    - x: ", static_cast<std::uint64_t>(cell.x));
            out.line("      y: ", static_cast<std::uint64_t>(cell.y));
        }
        else
            out.line("    - v: ", names.text(v));
        out.line("      t: ", std::uint64_t{time});
    };
    for (std::size_t robot = 0; robot < instance.robotCount(); ++robot)
    {
        out.line("  agent", std::uint64_t{robot}, ':');
        Vertex at = instance.starts[robot];
        std::size_t time = 0;
        writeState(time, at);
        for (const auto &[arrival, vertex] : moves[robot])
        {
            while (++time < arrival)
                writeState(time, at);
            at = vertex;
            writeState(time, at);
        }
    }
    return out.take();
}

} // namespace mrpp

#include "problems/formats/VetandXml.h"

#include "framework/support/Config.h"
#include "framework/support/Suggestion.h"
#include "problems/formats/FormatId.h"
#include "problems/formats/support/Cells.h"
#include "problems/formats/support/TextReader.h"
#include "problems/formats/support/TextWriter.h"
#include "problems/formats/support/XmlDocument.h"

#include <algorithm>
#include <map>

namespace mrpp
{

namespace
{

/// Which diagonal neighbours are joined.
struct Diagonals
{
    bool allowed = false;
    bool pastOneObstacle = false;     ///< cutcorners
    bool betweenTwoObstacles = false; ///< allowsqueeze
};

/// The edges of a grid: those of the map, and diagonal ones as allowed.
std::vector<Graph::Edge> edgesOf(const GridMap &map, const Diagonals &rule)
{
    std::vector<Graph::Edge> edges = map.graph->edges();
    for (std::size_t y = 0; rule.allowed && y + 1 < map.height; ++y)
        for (std::size_t x = 0; x + 1 < map.width; ++x)
            for (const bool falls : {true, false})
            {
                const std::size_t left = falls ? y : y + 1;
                const std::size_t right = falls ? y + 1 : y;
                const int obstacles = (map.passable(x, right) ? 0 : 1) + (map.passable(x + 1, left) ? 0 : 1);
                if (map.passable(x, left) && map.passable(x + 1, right) &&
                    (obstacles == 0 || rule.pastOneObstacle) && (obstacles < 2 || rule.betweenTwoObstacles))
                    edges.push_back({map.vertexAt(x, left), map.vertexAt(x + 1, right)});
            }
    return edges;
}

std::shared_ptr<const Graph> graphOf(const GridMap &map, const Diagonals &rule)
{
    std::vector<Point> points(map.graph->coordinates().begin(), map.graph->coordinates().end());
    return Graph::fromEdges(map.graph->vertexCount(), edgesOf(map, rule), std::move(points), YAxis::down);
}

class Reader
{
public:
    Reader(std::string_view text, const std::string &file) : document_(text, file), file_(file)
    {
        if (localName(document_.root()) != "root")
            document_.fail(document_.root(), "the outermost element is <" +
                                                 std::string(document_.root().name()) + ">; expected <root>");
    }

    VetandInstance instance()
    {
        const pugi::xml_node map = child(document_.root(), "map");
        checkNames(map, {"width", "height", "cellsize", "agents", "agent", "grid", "allowdiagonal",
                         "cutcorners", "allowsqueeze", "startx", "starty", "finishx", "finishy"});
        VetandInstance result;
        result.map = readGrid(map);
        const Diagonals rule = {flag(map, "allowdiagonal"), flag(map, "cutcorners"),
                                flag(map, "allowsqueeze")};
        InstanceBuilder builder(rule.allowed ? graphOf(*result.map, rule) : result.map->graph, file_);
        const pugi::xml_node list = map.child("agents") ? map.child("agents") : map;
        if (list != map)
            checkNames(list, {"agent"});
        std::map<std::int64_t, pugi::xml_node> robots; // by their ids
        for (const pugi::xml_node agent : list.children("agent"))
            if (!robots.emplace(attribute(agent, "id"), agent).second)
                document_.fail(agent, "there is an agent of this id already");
        if (robots.empty() && map.child("startx")) // the one robot of other programs of this kind
            robots.emplace(1, map);
        for (const auto &[id, agent] : robots)
        {
            builder.addStart(cell(*result.map, agent, "startx", "starty"), lineOf(agent), 1);
            builder.addGoal(cell(*result.map, agent, "finishx", "finishy"), lineOf(agent), 1);
        }
        result.instance = builder.take();
        if (rule.allowed)
            result.map.reset();
        return result;
    }

    SolutionRows moves(const Instance &instance) const
    {
        const pugi::xml_node log = document_.root().child("log");
        const pugi::xml_node paths = log ? log.child("paths") : log;
        if (!paths)
            throw NoSolution({file_},
                             "the file says that there is no solution (it has no <log> with <paths>)");
        const Cells cells(*instance.graph);
        std::map<std::int64_t, pugi::xml_node> agents;
        for (const pugi::xml_node agent : paths.children("agent"))
            if (!agents.emplace(attribute(agent, "id"), agent).second)
                document_.fail(agent, "there is a path of this agent already");
        std::vector<std::vector<Stay>> stays;
        for (const auto &[id, agent] : agents)
        {
            if (stays.size() == instance.robotCount())
                document_.fail(agent, "there are more paths than the instance's " +
                                          counted(instance.robotCount(), "robot", "robots"));
            auto &path = stays.emplace_back();
            path.push_back({0, instance.starts[stays.size() - 1], lineOf(agent)});
            for (const pugi::xml_node movement : agent.children("movement"))
                path.push_back(stay(cells, movement, path.back().time));
        }
        return rowsOfStays(file_, instance, stays);
    }

private:
    Stay stay(const Cells &cells, pugi::xml_node movement, std::int64_t last) const
    {
        const std::int64_t x = attribute(movement, "x");
        const std::int64_t y = attribute(movement, "y");
        const std::int64_t step = attribute(movement, "step");
        if (step < last)
            document_.fail(movement, "step " + std::to_string(step) +
                                         " is not after the one before; they ascend "
                                         "from 0");
        const Vertex v = cells.vertexAt(x, y);
        if (v == kNoVertex)
            document_.fail(movement, "the graph has no vertex on the cell " + cellName(x, y));
        return {step + 1, v, lineOf(movement)};
    }

    GridMap readGrid(pugi::xml_node map) const
    {
        constexpr std::int64_t mostSide = 1 << 16;
        const std::int64_t width = number(map, "width");
        const std::int64_t height = number(map, "height");
        if (width < 1 || height < 1 || width > mostSide || height > mostSide)
            document_.fail(map, "a map has 1 to " + std::to_string(mostSide) + " columns and rows");
        const pugi::xml_node grid = child(map, "grid");
        checkNames(grid, {"row"});
        std::string cells;
        std::int64_t rows = 0;
        for (const pugi::xml_node row : grid.children("row"))
        {
            std::int64_t columns = 0;
            for (LineCursor cursor(trimmed(row.child_value())); !cursor.atEnd(); ++columns)
            {
                const std::string_view word = cursor.word();
                if (word != "0" && word != "1")
                    document_.fail(row, inQuotes(word) + " is no cell; expected 0 (free) or 1 (obstacle)");
                cells += word == "0" ? '.' : '@';
            }
            if (columns != width)
                document_.fail(row, "the row has " + std::to_string(columns) + " cells, but the width is " +
                                        std::to_string(width));
            ++rows;
        }
        if (rows != height)
            document_.fail(grid, "there are " + std::to_string(rows) + " rows, but the height is " +
                                     std::to_string(height));
        return makeGridMap(static_cast<std::size_t>(width), static_cast<std::size_t>(height),
                           std::move(cells));
    }

    Vertex cell(const GridMap &map, pugi::xml_node agent, const char *column, const char *row) const
    {
        const std::int64_t x = number(agent, column);
        const std::int64_t y = number(agent, row);
        if (!map.contains(x, y))
            document_.fail(agent, "the cell " + cellName(x, y) + " is outside the map");
        const Vertex v = map.vertexAt(static_cast<std::size_t>(x), static_cast<std::size_t>(y));
        if (v == kNoVertex)
            document_.fail(agent, "the cell " + cellName(x, y) + " is an obstacle");
        return v;
    }

    pugi::xml_node child(pugi::xml_node parent, const char *name) const
    {
        const pugi::xml_node found = parent.child(name);
        if (!found)
            document_.fail(parent, "there is no <" + std::string(name) + "> in it");
        if (const pugi::xml_node second = found.next_sibling(name))
            document_.fail(second, "this is a second <" + std::string(name) + ">");
        return found;
    }

    std::int64_t number(pugi::xml_node parent, const char *name) const
    {
        const pugi::xml_node element = child(parent, name);
        const std::string_view text = trimmed(element.child_value());
        const auto value = parseInteger(text);
        if (!value)
            document_.fail(element, inQuotes(text) + " is no whole number, but <" + name + "> must be one");
        return *value;
    }

    bool flag(pugi::xml_node map, const char *name) const
    {
        if (!map.child(name))
            return false;
        const pugi::xml_node element = child(map, name);
        const std::string_view text = trimmed(element.child_value());
        if (text != "true" && text != "false" && text != "1" && text != "0")
            document_.fail(element, inQuotes(text) + " is neither true nor false");
        return text == "true" || text == "1";
    }

    std::int64_t attribute(pugi::xml_node element, const char *name) const
    {
        const std::string_view text = document_.required(element, name);
        const auto value = parseInteger(text);
        if (!value)
            document_.fail(element, inQuotes(text) + " is no whole number, but '" + name + "' must be one");
        return *value;
    }

    void checkNames(pugi::xml_node parent, const std::vector<std::string> &known) const
    {
        for (const pugi::xml_node element : parent.children())
            if (element.type() == pugi::node_element &&
                std::find(known.begin(), known.end(), element.name()) == known.end())
                document_.fail(element, "<" + std::string(element.name()) + "> does not belong into a <" +
                                            parent.name() + ">" + suggestion(element.name(), known));
    }

    std::uint32_t lineOf(pugi::xml_node element) const
    {
        return static_cast<std::uint32_t>(document_.where(element).line);
    }

    XmlDocument document_;
    std::string file_;
};

/// The rule under which a graph is a grid; nothing where it is none.
std::optional<std::pair<GridMap, Diagonals>> gridOf(const Graph &graph, const GridMap *known)
{
    if (known != nullptr)
        return std::pair(*known, Diagonals());
    if (auto map = gridMapIfOne(graph))
        return std::pair(std::move(*map), Diagonals());
    const Cells cells(graph);
    std::string signs(std::size_t{cells.width()} * cells.height(), '@');
    for (Vertex v = 0; v < graph.vertexCount(); ++v)
        signs[std::size_t{cells.cellOf(v).second} * cells.width() + cells.cellOf(v).first] = '.';
    GridMap map = makeGridMap(cells.width(), cells.height(), std::move(signs));
    for (const Diagonals &rule :
         {Diagonals{true, false, false}, Diagonals{true, true, false}, Diagonals{true, true, true}})
    {
        const auto edges = edgesOf(map, rule);
        const auto isEdge = [&](const Graph::Edge &edge)
        {
            const auto vertexOf = [&](Vertex v)
            {
                const auto [x, y] = map.cellOf(v);
                return cells.vertexAt(static_cast<std::int64_t>(x), static_cast<std::int64_t>(y));
            };
            return graph.hasEdge(vertexOf(edge.a), vertexOf(edge.b));
        };
        if (edges.size() == graph.edgeCount() && std::all_of(edges.begin(), edges.end(), isEdge))
            return std::pair(std::move(map), rule);
    }
    return std::nullopt;
}

void writeMap(TextWriter &out, const Instance &instance, const GridMap *known)
{
    const Graph &graph = *instance.graph;
    const auto grid = gridOf(graph, known);
    if (!grid)
        throw InputError(
            "this graph is no grid map: its edges must join exactly the cells that share a side, or "
            "a corner, too");
    const auto &[map, rule] = *grid;
    out.line("  <map>");
    out.line("    <width>", std::uint64_t{map.width}, "</width>");
    out.line("    <height>", std::uint64_t{map.height}, "</height>");
    out.line("    <agents>");
    const auto writeNumber = [&out](const char *name, double value)
    { out.add('<', name, '>', static_cast<std::uint64_t>(value), "</", name, '>'); };
    for (std::size_t robot = 0; robot < instance.robotCount(); ++robot)
    {
        const Point &start = graph.coordinate(instance.starts[robot]);
        const Point &goal = graph.coordinate(instance.goals[robot]);
        out.add("      <agent id=\"", std::uint64_t{robot} + 1, "\">");
        writeNumber("startx", start.x);
        writeNumber("starty", start.y);
        writeNumber("finishx", goal.x);
        writeNumber("finishy", goal.y);
        out.line("</agent>");
    }
    out.line("    </agents>");
    out.line("    <grid>");
    for (std::size_t y = 0; y < map.height; ++y)
    {
        out.add("      <row>");
        for (std::size_t x = 0; x < map.width; ++x)
            out.add(x == 0 ? "" : " ", map.passable(x, y) ? '0' : '1');
        out.line("</row>");
    }
    out.line("    </grid>");
    const auto writeFlag = [&out](const char *name, bool value)
    { out.line("    <", name, '>', value ? "true" : "false", "</", name, '>'); };
    writeFlag("allowdiagonal", rule.allowed);
    writeFlag("cutcorners", rule.pastOneObstacle);
    writeFlag("allowsqueeze", rule.betweenTwoObstacles);
    out.line("  </map>");
}

} // namespace

VetandInstance parseVetandInstance(std::string_view text, const std::string &file)
{
    return readAs(FormatId::vetandInstance, text, file, [&] { return Reader(text, file).instance(); });
}

std::string formatVetandInstance(const Instance &instance, const GridMap *map)
{
    TextWriter out;
    out.line("<root>");
    writeMap(out, instance, map);
    out.line("</root>");
    return out.take();
}

SolutionRows parseVetandResult(std::string_view text, const std::string &file, const Instance &instance)
{
    return readAs(FormatId::vetandResult, text, file, [&] { return Reader(text, file).moves(instance); });
}

std::string formatVetandResult(const Instance &instance, const Schedule &schedule, const GridMap *map)
{
    std::vector<std::vector<std::pair<std::size_t, Vertex>>> moves(instance.robotCount()); // (step, vertex)
    std::size_t steps = 0; // they have no gaps
    std::uint64_t costs = 0;
    for (std::size_t step = 0; step < schedule.makespan(); ++step)
    {
        for (const Move &move : schedule.step(step))
            moves[move.robot].emplace_back(steps, move.to);
        steps += schedule.step(step).empty() ? 0 : 1;
    }
    for (const auto &path : moves)
        costs += path.empty() ? 0 : path.back().first + 1;
    TextWriter out;
    out.line("<root>");
    writeMap(out, instance, map);
    out.line("  <log>");
    out.line("    <general>");
    out.line("      <makespan>", std::uint64_t{steps}, "</makespan>");
    out.line("      <summ-of-costs>", costs, "</summ-of-costs>");
    out.line("    </general>");
    out.line("    <paths>");
    for (std::size_t robot = 0; robot < moves.size(); ++robot)
    {
        out.line("      <agent id=\"", std::uint64_t{robot} + 1, "\">");
        for (const auto &[step, v] : moves[robot])
        {
            const Point &cell = instance.graph->coordinate(v);
            out.line("        <movement x=\"", static_cast<std::uint64_t>(cell.x), "\" y=\"",
                     static_cast<std::uint64_t>(cell.y), "\" step=\"", std::uint64_t{step}, "\"/>");
        }
        out.line("      </agent>");
    }
    out.line("    </paths>");
    out.line("  </log>");
    out.line("</root>");
    return out.take();
}

} // namespace mrpp

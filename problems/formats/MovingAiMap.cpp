#include "problems/formats/MovingAiMap.h"

#include "framework/support/Config.h"
#include "framework/support/Suggestion.h"
#include "framework/system/File.h"
#include "problems/formats/FormatId.h"
#include "problems/formats/support/TextReader.h"

#include <algorithm>
#include <cmath>

namespace mrpp
{

namespace
{

constexpr Passability kPassabilities[] = {
    {"movingai", ".GS", "@OTW"},
    {"lorr", ".GSE", "@OTW"},
    {"strict_dot", ".", "GS@OTWE"},
    {"all_but_at_t", ".GSOWE", "@T"},
};

struct Header
{
    std::size_t height = 0;
    std::size_t width = 0;
};

/// Everything up to the line `map`: keywords in any order. Lines of unknown keywords are left to those who
/// know them, misspelt ones are refused.
Header readHeader(TextReader &reader)
{
    static const std::vector<std::string> kHeaderWords = {"type", "height", "width", "map"};
    Header header;
    while (const auto line = reader.next())
    {
        LineCursor cursor(*line);
        if (cursor.atEnd())
            continue;
        const std::size_t wordColumn = cursor.column();
        const std::string_view word = cursor.word();
        const std::size_t column = cursor.column();
        const std::string_view value = cursor.until("");
        if (word == "map" && value.empty())
        {
            const char *missing = header.height == 0  ? "height <rows>"
                                  : header.width == 0 ? "width <columns>"
                                                      : nullptr;
            if (missing != nullptr)
                reader.fail(wordColumn,
                            std::string("the header lacks a line '") + missing + "' before 'map'");
            return header;
        }
        if (value.empty())
            reader.fail(wordColumn, inQuotes(word) + " is no line of a map's header; expected 'type octile', "
                                                     "'height <rows>', 'width <columns>', then 'map'");
        if (word != "height" && word != "width")
        {
            const std::string meant = nearestWord(word, kHeaderWords);
            if (!meant.empty() && meant != word)
                reader.fail(wordColumn, inQuotes(word) + " is no line of a map's header; did you mean " +
                                            inQuotes(meant) + "?");
            continue;
        }
        std::size_t &slot = word == "height" ? header.height : header.width;
        const auto number = parseInteger(value);
        if (!number || *number < 1)
            reader.fail(column, inQuotes(value) + " is no " + std::string(word) +
                                    "; expected a whole number from 1 on");
        if (slot != 0)
            reader.fail(wordColumn, "the header gives the " + std::string(word) + " a second time");
        slot = static_cast<std::size_t>(*number);
    }
    reader.fail(
        reader.line() + 1, 1,
        "the file ends within the header; expected 'type octile', 'height <rows>', 'width <columns>', "
        "'map' and the rows");
}

/// "; passability lorr knows it".
std::string othersKnowing(char symbol)
{
    std::string names;
    for (const Passability &rule : passabilities())
        if (rule.passable.find(symbol) != std::string_view::npos ||
            rule.blocked.find(symbol) != std::string_view::npos)
            names += (names.empty() ? "" : ", ") + std::string(rule.name);
    return names.empty() ? names : "; known under the passability " + names;
}

void readRow(const TextReader &reader, std::string_view row, std::size_t width, const Passability &rule)
{
    for (std::size_t x = 0; x < std::min(row.size(), width); ++x)
        if (rule.passable.find(row[x]) == std::string_view::npos &&
            rule.blocked.find(row[x]) == std::string_view::npos)
            reader.fail(x + 1, "unknown symbol " + inQuotes(row.substr(x, 1)) +
                                   "; known: " + std::string(rule.passable) + " (passable) and " +
                                   std::string(rule.blocked) + " (obstacle)" + othersKnowing(row[x]));
    if (row.size() != width)
        reader.fail(std::min(row.size(), width) + 1, "the row has " + std::to_string(row.size()) +
                                                         " cells, but the header says width " +
                                                         std::to_string(width));
}

} // namespace

std::span<const Passability> passabilities()
{
    return kPassabilities;
}

std::string passabilityNames()
{
    std::string names;
    for (const Passability &rule : passabilities())
        names += (names.empty() ? "" : ",") + std::string(rule.name);
    return names;
}

const Passability &passability(std::string_view name)
{
    std::vector<std::string> names;
    for (const Passability &rule : passabilities())
    {
        if (rule.name == name)
            return rule;
        names.emplace_back(rule.name);
    }
    throw InputError("there is no passability '" + std::string(name) + "'" + suggestion(name, names));
}

GridMap readMovingAiMap(const std::filesystem::path &file, const Passability &rule)
{
    return parseMovingAiMap(readFile(file), file.string(), rule);
}

namespace
{

GridMap readMap(std::string_view text, const std::string &file, const Passability &rule)
{
    TextReader reader(text, file);
    const Header header = readHeader(reader);
    std::string cells;
    for (std::size_t y = 0; y < header.height; ++y)
    {
        const auto row = reader.next();
        if (!row)
            reader.fail(reader.line() + 1, 1,
                        "the file ends after " + std::to_string(y) + " rows, but the header says height " +
                            std::to_string(header.height));
        readRow(reader, *row, header.width, rule);
        cells += *row;
    }
    while (const auto line = reader.next())
        if (!trimmed(*line).empty())
            reader.fail(1, "there is something behind the last row; the header says height " +
                               std::to_string(header.height));
    return makeGridMap(header.width, header.height, std::move(cells), rule);
}

} // namespace

GridMap parseMovingAiMap(std::string_view text, const std::string &file, const Passability &rule)
{
    return readAs(FormatId::movingAiMap, text, file, [&] { return readMap(text, file, rule); });
}

GridMap makeGridMap(std::size_t width, std::size_t height, std::string cells, const Passability &rule,
                    YAxis yAxis)
{
    GridMap map{width, height, std::move(cells), nullptr, std::vector<Vertex>(width * height, kNoVertex)};
    const auto isFree = [&rule](char cell) { return rule.passable.find(cell) != std::string_view::npos; };
    const auto free = static_cast<std::size_t>(std::count_if(map.cells.begin(), map.cells.end(), isFree));
    std::vector<Point> coordinates;
    std::vector<Graph::Edge> edges;
    coordinates.reserve(free);
    edges.reserve(2 * free);
    for (std::size_t y = 0; y < height; ++y)
    {
        for (std::size_t x = 0; x < width; ++x)
        {
            const std::size_t cell = y * width + x;
            if (!isFree(map.cells[cell]))
                continue;
            const auto v = static_cast<Vertex>(coordinates.size());
            map.vertices[cell] = v;
            coordinates.push_back({static_cast<double>(x), static_cast<double>(y), 0});
            if (x > 0 && map.vertices[cell - 1] != kNoVertex)
                edges.push_back({map.vertices[cell - 1], v});
            if (y > 0 && map.vertices[cell - width] != kNoVertex)
                edges.push_back({map.vertices[cell - width], v});
        }
    }
    map.graph = Graph::fromEdges(free, edges, std::move(coordinates), yAxis);
    return map;
}

GridMap gridMapOf(const Graph &graph)
{
    const auto refuse = [](const std::string &why) { throw InputError("this graph is no grid map: " + why); };
    if (graph.vertexCount() == 0 || !graph.hasCoordinates())
        refuse("its vertices have no coordinates");
    GridMap map;
    constexpr double largest = 1 << 16;
    for (const Point &p : graph.coordinates())
    {
        if (p.x != std::floor(p.x) || p.y != std::floor(p.y) || p.x < 0 || p.y < 0 || p.x >= largest ||
            p.y >= largest)
            refuse("its coordinates must be columns and rows, whole numbers from 0 on");
        map.width = std::max(map.width, static_cast<std::size_t>(p.x) + 1);
        map.height = std::max(map.height, static_cast<std::size_t>(p.y) + 1);
    }
    constexpr std::size_t mostCells = std::size_t{1} << 28;
    if (map.width * map.height > mostCells)
        refuse("it would have " + std::to_string(map.width) + " x " + std::to_string(map.height) + " cells");
    std::string cells(map.width * map.height, '@');
    for (const Point &p : graph.coordinates())
    {
        char &cell = cells[static_cast<std::size_t>(p.y) * map.width + static_cast<std::size_t>(p.x)];
        if (cell == '.')
            refuse("two vertices share a cell");
        cell = '.';
    }
    map = makeGridMap(map.width, map.height, std::move(cells));
    if (map.graph->edgeCount() != graph.edgeCount())
        refuse("its edges must join exactly the cells that share a side");
    for (const Graph::Edge &edge : graph.edges())
    {
        const Point &a = graph.coordinate(edge.a);
        const Point &b = graph.coordinate(edge.b);
        if (std::abs(a.x - b.x) + std::abs(a.y - b.y) != 1)
            refuse("its edges must join exactly the cells that share a side");
    }
    return map;
}

std::optional<GridMap> gridMapIfOne(const Graph &graph)
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

std::string formatMovingAiMap(const GridMap &map)
{
    std::string text = "type octile\nheight " + std::to_string(map.height) + "\nwidth " +
                       std::to_string(map.width) + "\nmap\n";
    text.reserve(text.size() + (map.width + 1) * map.height);
    for (std::size_t y = 0; y < map.height; ++y)
        text.append(map.cells, y * map.width, map.width).push_back('\n');
    return text;
}

} // namespace mrpp

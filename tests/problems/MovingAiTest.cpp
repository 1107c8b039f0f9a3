#include "framework/analysis/Components.h"
#include "framework/support/Error.h"
#include "framework/support/Random.h"
#include "framework/system/File.h"
#include "problems/formats/MovingAiScenario.h"

#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <set>
#include <sstream>

namespace mrpp
{
namespace
{

using testing::HasSubstr;

const std::filesystem::path kMaps = std::filesystem::path(MRPP_SHARED_DATA) / "movingai";

GridMap parse(std::string_view text)
{
    return parseMovingAiMap(text, "test.map");
}

std::vector<std::pair<Vertex, Vertex>> edgesOf(const Graph &graph)
{
    std::vector<std::pair<Vertex, Vertex>> edges;
    for (const Graph::Edge &edge : graph.edges())
        edges.emplace_back(edge.a, edge.b);
    return edges;
}

constexpr const char *kSmall = "type octile\nheight 3\nwidth 4\nmap\n.G@S\nT.W.\n.O..\n";

TEST(MovingAiMap, NumbersPassableCellsRowByRow)
{
    const GridMap map = parse(kSmall);
    EXPECT_EQ(map.width, 4);
    EXPECT_EQ(map.height, 3);
    ASSERT_EQ(map.graph->vertexCount(), 8);
    EXPECT_EQ(map.vertexAt(0, 0), 0);
    EXPECT_EQ(map.vertexAt(1, 0), 1);
    EXPECT_FALSE(map.passable(2, 0));
    EXPECT_EQ(map.vertexAt(3, 0), 2);
    EXPECT_EQ(map.vertexAt(1, 1), 3);
    EXPECT_EQ(map.vertexAt(3, 1), 4);
    EXPECT_EQ(map.vertexAt(0, 2), 5);
    EXPECT_EQ(map.vertexAt(2, 2), 6);
    EXPECT_EQ(map.vertexAt(3, 2), 7);
    EXPECT_EQ(edgesOf(*map.graph),
              (std::vector<std::pair<Vertex, Vertex>>{{0, 1}, {1, 3}, {2, 4}, {4, 7}, {6, 7}}));
    EXPECT_EQ(map.graph->coordinate(6), (Point{2, 2, 0}));
    EXPECT_EQ(map.graph->yAxis(), YAxis::down);
    EXPECT_EQ(map.cellOf(4), (std::pair<std::size_t, std::size_t>{3, 1}));
}

TEST(MovingAiMap, TakesWhatOtherProgramsWrite)
{
    const std::string expected = parse(kSmall).graph->fingerprint();
    const std::vector<std::string> variants = {
        "type octile\nwidth 4\nheight 3\nmap\n.G@S\nT.W.\n.O..\n",                          // other order
        "type octile\r\nheight 3\r\nwidth 4\r\nmap\r\n.G@S\r\nT.W.\r\n.O..\r\n",            // CRLF
        "type octile\nheight 3\nwidth 4\nmap\n.G@S\nT.W.\n.O..",                            // no last end
        "type octile\nheight 3\nwidth 4\nmap\n.G@S\nT.W.\n.O..\n\n  \n",                    // blank lines
        "type tile\n height\t3 \nwidth   4\n\nmap \n.G@S\nT.W.\n.O..\n",                    // blanks
        "\xEF\xBB\xBFtype octile\nheight 3\nwidth 4\nname a room\nmap\n.G@S\nT.W.\n.O..\n", // mark, more
    };
    for (const std::string &text : variants)
        EXPECT_EQ(parse(text).graph->fingerprint(), expected) << text;
}

TEST(MovingAiMap, PassabilityIsAChoice)
{
    const std::string text = "type octile\nheight 1\nwidth 8\nmap\n.GS@OTWE\n";
    EXPECT_THROW((void)parse(text), ParseError); // E is not of this set
    EXPECT_EQ(parseMovingAiMap(text, "m", passability("lorr")).graph->vertexCount(), 4);
    EXPECT_EQ(parseMovingAiMap(text, "m", passability("strict_dot")).graph->vertexCount(), 1);
    EXPECT_EQ(parseMovingAiMap(text, "m", passability("all_but_at_t")).graph->vertexCount(), 6);
    EXPECT_EQ(passability().name, "movingai");
    EXPECT_THROW((void)passability("lor"), InputError);
}

/// A random map of up to 12 x 12 cells.
rc::Gen<std::string> anyMap()
{
    return rc::gen::map(
        rc::gen::tuple(rc::gen::inRange<std::size_t>(1, 13), rc::gen::inRange<std::size_t>(1, 13),
                       rc::gen::container<std::string>(144, rc::gen::elementOf(std::string(".@GT")))),
        [](const std::tuple<std::size_t, std::size_t, std::string> &parts)
        {
            const auto &[width, height, cells] = parts;
            std::string text = "type octile\nheight " + std::to_string(height) + "\nwidth " +
                               std::to_string(width) + "\nmap\n";
            for (std::size_t y = 0; y < height; ++y)
                text += cells.substr(y * width, width) + "\n";
            return text;
        });
}

RC_GTEST_PROP(MovingAiMap, WritesWhatItRead, ())
{
    const std::string text = *anyMap();
    RC_ASSERT(formatMovingAiMap(parse(text)) == text);
}

RC_GTEST_PROP(MovingAiMap, ComesBackFromItsGraph, ())
{
    const GridMap map = parse(*anyMap());
    RC_PRE(map.graph->vertexCount() > 0U);
    const GridMap again = gridMapOf(*map.graph);
    RC_ASSERT(again.graph->fingerprint() == map.graph->fingerprint());
    for (Vertex v = 0; v < map.graph->vertexCount(); ++v)
        RC_ASSERT(again.cellOf(v) == map.cellOf(v));
}

TEST(MovingAiMap, RefusesGraphsThatAreNoGrids)
{
    const auto refused = [](const std::vector<Graph::Edge> &edges, std::vector<Point> points)
    {
        const std::size_t count = points.size();
        EXPECT_THROW((void)gridMapOf(*Graph::fromEdges(count, edges, std::move(points))), InputError);
    };
    refused({}, {});
    refused({{0, 1}}, {{0, 0, 0}, {0.5, 0, 0}});
    refused({{0, 1}}, {{0, 0, 0}, {-1, 0, 0}});
    refused({}, {{0, 0, 0}, {1, 0, 0}});       // an edge is missing
    refused({{0, 1}}, {{0, 0, 0}, {2, 0, 0}}); // one is too long
    refused({{0, 1}, {1, 2}, {0, 2}}, {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}});
    refused({{0, 2}}, {{0, 0, 0}, {1, 0, 0}, {3, 0, 0}}); // as many as there should be, but another
    refused({}, {{0, 0, 0}, {0, 0, 0}});
    refused({}, {{0, 0, 0}, {60000, 60000, 0}});
    refused({}, {{0, 0, 0}, {1e300, 0, 0}});
}

// Scenarios

constexpr const char *kRoom = "type octile\nheight 3\nwidth 6\nmap\n......\n.@@.T.\n......\n";

TEST(MovingAiScenario, TheFirstRecordsAreTheRobots)
{
    const GridMap room = parse(kRoom);
    const Scenario scenario = parseMovingAiScenario("version 1\n"
                                                    "0\tmaps/room.map\t6\t3\t0\t0\t3\t1\t3.41421356\n"
                                                    "0\tmaps/room.map\t6\t3\t5\t2\t0\t0\t5.82842712\n"
                                                    "1\tmaps/room.map\t6\t3\t3\t1\t3\t1\t0\n",
                                                    "room.scen");
    EXPECT_EQ(scenario.mapName(), "room.map");
    ASSERT_EQ(scenario.records.size(), 3);
    const Instance two = scenarioInstance(scenario, room, 2);
    EXPECT_EQ(two.starts, (std::vector<Vertex>{0, 14}));
    EXPECT_EQ(two.goals, (std::vector<Vertex>{7, 0}));
    EXPECT_EQ(two.graph, room.graph);
    EXPECT_EQ(scenarioInstance(scenario, room, 0).robotCount(), 0);
    EXPECT_THROW((void)scenarioInstance(scenario, room, 3),
                 ParseError); // the third ends where the first does
    EXPECT_THROW((void)scenarioInstance(scenario, room, 4), InputError); // there are three
}

TEST(MovingAiScenario, TakesWhatOtherProgramsWrite)
{
    const GridMap room = parse(kRoom);
    const std::vector<std::string> variants = {
        "version 1\n0\tmy room.map\t6\t3\t0\t0\t3\t1\t3.4\n",
        "version 1.0\n0 my room.map 6 3 0 0 3 1 3.4\n",
        "0\tmy room.map\t6\t3\t0\t0\t3\t1\t3.4\n",
        "version 1\r\n0 my room.map 6 3 0 0 3 1 3.4 \r\n\r\n",
        "version 1\n0  a/b c/my room.map  6  3  0  0  3  1  3.4",
        "version 1\n0\tC:\\maps\\my room.map\t6\t3\t0\t0\t3\t1\t3.4",
    };
    for (const std::string &text : variants)
    {
        const Scenario scenario = parseMovingAiScenario(text, "s");
        EXPECT_EQ(scenario.mapName(), "my room.map") << text;
        const Instance instance = scenarioInstance(scenario, room, 1);
        EXPECT_EQ(instance.starts, std::vector<Vertex>{0}) << text;
        EXPECT_EQ(instance.goals, std::vector<Vertex>{7}) << text;
    }
    EXPECT_TRUE(parseMovingAiScenario("version 1\n", "s").records.empty());
}

TEST(MovingAiScenario, MoreRobotsThanRecordsIsAnError)
{
    const Scenario scenario =
        parseMovingAiScenario("version 1\n0\troom.map\t6\t3\t0\t0\t3\t1\t3\n", "s.scen");
    try
    {
        (void)scenarioInstance(scenario, parse(kRoom), 2);
        FAIL();
    }
    catch (const InputError &error)
    {
        EXPECT_STREQ(error.what(), "s.scen: there are 1 records, fewer than the 2 robots asked for");
    }
}

TEST(MovingAiScenario, WritesOctileLengthsAndBuckets)
{
    const GridMap room = parse(kRoom);
    const Instance instance{room.graph, {0, 14, 6}, {7, 0, 6}};
    const std::string text = formatMovingAiScenario(room, instance, "room.map");
    EXPECT_EQ(text, "version 1\n"
                    "1\troom.map\t6\t3\t0\t0\t3\t1\t4.00000000\n"
                    "1\troom.map\t6\t3\t5\t2\t0\t0\t7.00000000\n"
                    "0\troom.map\t6\t3\t0\t1\t0\t1\t0.00000000\n");
}

RC_GTEST_PROP(MovingAiScenario, ComesBackAsItWasWritten, (Seed seed))
{
    const GridMap map = parse(*anyMap());
    const std::size_t vertices = map.graph->vertexCount();
    RC_PRE(vertices > 0U);
    std::vector<Vertex> starts(vertices);
    for (Vertex v = 0; v < vertices; ++v)
        starts[v] = v;
    std::vector<Vertex> goals = starts;
    Random random(seed);
    random.shuffle(std::span(starts));
    random.shuffle(std::span(goals));
    const Instance instance{map.graph, starts, goals};
    const Scenario scenario = parseMovingAiScenario(formatMovingAiScenario(map, instance, "m.map"), "m.scen");
    const Instance again = scenarioInstance(scenario, map, vertices);
    RC_ASSERT(again.starts == starts);
    RC_ASSERT(again.goals == goals);
}

// The benchmark's own files, against the table that describes them

/// The rows of the tables in README.md whose first cell ends in `extension`, cells trimmed.
std::vector<std::vector<std::string>> tableRows(const std::string &extension)
{
    std::vector<std::vector<std::string>> rows;
    std::istringstream text(readFile(kMaps / "README.md"));
    for (std::string line; std::getline(text, line);)
    {
        std::vector<std::string> cells;
        std::istringstream stream(line);
        for (std::string cell; std::getline(stream, cell, '|');)
        {
            const std::size_t first = cell.find_first_not_of(' ');
            cells.push_back(
                first == std::string::npos ? "" : cell.substr(first, cell.find_last_not_of(' ') - first + 1));
        }
        if (cells.size() > 1 && cells[1].ends_with(extension))
            rows.push_back(cells);
    }
    return rows;
}

class MovingAiFiles : public testing::Test
{
protected:
    void SetUp() override
    {
        if (!std::filesystem::exists(kMaps / "README.md"))
            GTEST_SKIP() << "there are no maps in " << kMaps;
    }
};

TEST_F(MovingAiFiles, EveryMapHasTheCountsOfItsTable)
{
    const auto rows = tableRows(".map");
    EXPECT_EQ(rows.size(), 39);
    for (const auto &row : rows)
    {
        SCOPED_TRACE(row[1]);
        const GridMap map = readMovingAiMap(kMaps / row[1]);
        EXPECT_EQ(map.width, std::stoul(row[3]));
        EXPECT_EQ(map.height, std::stoul(row[4]));
        EXPECT_EQ(map.graph->vertexCount(), std::stoul(row[6]));
        EXPECT_EQ(map.graph->edgeCount(), std::stoul(row[7]));
        const Components components(*map.graph);
        EXPECT_EQ(components.count(), std::stoul(row[8]));
        const std::uint32_t largest = components.largest();
        EXPECT_EQ(components.size(largest), std::stoul(row[9]));
        std::size_t edges = 0;
        for (const Graph::Edge &edge : map.graph->edges())
            edges += components.of(edge.a) == largest ? 1 : 0;
        EXPECT_EQ(edges, std::stoul(row[9].substr(row[9].find('/') + 1)));
    }
}

TEST_F(MovingAiFiles, EveryScenarioReadsAndRepeatsWhereItsTableSays)
{
    const auto rows = tableRows(".scen");
    EXPECT_EQ(rows.size(), 52);
    for (const auto &row : rows)
    {
        SCOPED_TRACE(row[1]);
        const Scenario scenario = readMovingAiScenario(kMaps / row[1]);
        EXPECT_EQ(scenario.records.size(), std::stoul(row[5]));
        const std::string folder = row[1].substr(0, row[1].find("-scen"));
        const GridMap map = readMovingAiMap(kMaps / folder / scenario.mapName());
        std::size_t usable = scenario.records.size();
        if (row[7] != "none")
            usable = std::min<std::size_t>(std::stoul(row[7]), std::stoul(row[8])) - 1;
        const Instance instance = scenarioInstance(scenario, map, usable);
        EXPECT_EQ(instance.robotCount(), usable);
        EXPECT_EQ(instance.defect(), std::nullopt);
        if (usable < scenario.records.size())
        {
            EXPECT_THROW((void)scenarioInstance(scenario, map, usable + 1), ParseError);
        }
    }
}

TEST_F(MovingAiFiles, OctileLengthsAgreeWithThePublishedOnes)
{
    const GridMap map = readMovingAiMap(kMaps / "mapf/room-32-32-4.map");
    const std::string text = readFile(kMaps / "mapf-scen/room-32-32-4-random-1.scen");
    const Scenario scenario = parseMovingAiScenario(text, "s");
    const Instance instance = scenarioInstance(scenario, map, scenario.records.size());
    std::istringstream published(text);
    std::istringstream written(formatMovingAiScenario(map, instance, "room-32-32-4.map"));
    std::string theirs;
    std::string ours;
    while (std::getline(published, theirs) && std::getline(written, ours))
    {
        const std::size_t cut = theirs.find_last_of("\t ") + 1;
        EXPECT_EQ(ours.substr(0, cut), theirs.substr(0, cut));
        EXPECT_EQ(ours.size(), theirs.size());
        if (theirs.find('\t') != std::string::npos) // their diagonal is sqrt(2) in single precision
        {
            EXPECT_NEAR(std::stod(ours.substr(cut)), std::stod(theirs.substr(cut)), 1e-6);
        }
    }
}

} // namespace
} // namespace mrpp

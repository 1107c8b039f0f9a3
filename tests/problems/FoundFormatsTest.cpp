/// Files that tools in use write, with the values that are right; where the shared data is there.

#include "framework/evaluation/Validator.h"
#include "framework/support/Error.h"
#include "framework/system/File.h"
#include "problems/formats/Conversion.h"
#include "problems/formats/Exchange.h"
#include "problems/formats/Formats.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

namespace mrpp
{
namespace
{

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;

class FoundFormats : public testing::Test
{
protected:
    void SetUp() override
    {
        const auto found = std::filesystem::path(MRPP_SHARED_DATA) / "found";
        if (!std::filesystem::exists(found / "formats"))
            GTEST_SKIP() << "the files are not here: " << found;
        folder_ = std::filesystem::path(testing::TempDir()) / ("mrpp_found_" + std::to_string(::getpid()));
        std::filesystem::create_directories(folder_);
        for (const char *kind : {"formats", "outside"})
            for (const auto &entry : std::filesystem::directory_iterator(found / kind))
                writeFile(folder_ / entry.path().filename(), readFile(entry.path()));
    }
    void TearDown() override
    {
        if (!folder_.empty())
            std::filesystem::remove_all(folder_);
    }

    [[nodiscard]] LoadedGraph graph(const std::string &name) const { return loadGraph(folder_ / name); }
    [[nodiscard]] LoadedInstance instance(const std::string &name) const
    {
        return loadInstance({folder_ / name, std::nullopt, std::nullopt});
    }
    template <class Work>
    std::string refusal(Work &&work) const
    {
        try
        {
            (void)work();
        }
        catch (const InputError &error)
        {
            return error.what();
        }
        return "nothing was wrong";
    }

    std::filesystem::path folder_;
};

TEST_F(FoundFormats, AMatrixMarketFileIsTheGraphOfItsEntries)
{
    EXPECT_EQ(graph("matrix-market.mtx").graph->vertexCount(), 4U);
    EXPECT_EQ(instance("matrix-market.instance").instance.graph->edgeCount(), 3U);
}

TEST_F(FoundFormats, ALineOfCountsIsNoEdge)
{
    EXPECT_THAT(refusal([this] { return graph("count-line.edges"); }),
                HasSubstr("count-line.edges:1:1: this line looks like counts of vertices and edges"));
}

TEST_F(FoundFormats, NumbersWithGapsAreNames)
{
    EXPECT_EQ(graph("sparse-ids.edges").graph->vertexCount(), 4U);
    EXPECT_THAT(graph("sparse-ids.edges").vertexNames, ElementsAre("4", "17", "902", "30011"));
}

TEST_F(FoundFormats, TwoPrefixesOfOneNamespaceAreOneNamespace)
{
    const LoadedGraph read = graph("two-prefixes.graphml");
    EXPECT_EQ(read.graph->vertexCount(), 3U);
    EXPECT_TRUE(read.graph->hasEdge(0, 2));
}

TEST_F(FoundFormats, BoxesWithoutPlaceAreNoCoordinates)
{
    EXPECT_EQ(graph("geometry-without-xy.graphml").graph->edgeCount(), 1U);
    EXPECT_FALSE(graph("geometry-without-xy.graphml").graph->hasCoordinates());
}

TEST_F(FoundFormats, RoadmapsNeedNoVertices)
{
    EXPECT_EQ(instance("roadmap-no-vertices.yaml").instance.graph->vertexCount(), 6U);
}

TEST_F(FoundFormats, EverySpellingOfFalseWarns)
{
    EXPECT_THAT(instance("false-spellings.yaml").warnings,
                ElementsAre(HasSubstr("directed"), HasSubstr("forbids waiting")));
}

TEST_F(FoundFormats, AMisspeltKeyLosesNoObstacles)
{
    EXPECT_THAT(
        refusal([this] { return instance("unknown-key.yaml"); }),
        HasSubstr("unknown-key.yaml:3:3: the key 'obstacle' is not known here; did you mean 'obstacles'?"));
}

TEST_F(FoundFormats, GapsBetweenTimesAreWaits)
{
    writeFile(folder_ / "line.yaml",
              "map: {dimensions: [3, 1]}\nagents: [{name: a, start: [1, 0], goal: [2, 0]}]\n");
    const LoadedInstance line = instance("line.yaml");
    const SolutionRows rows = loadSolution(folder_ / "waits-as-gaps.yaml", line);
    EXPECT_TRUE(validate(line.instance, rows.moves, MotionRule::pebble).valid());

    // An answer of a published program: its robots stand where it says first.
    std::string agents;
    const std::string text = readFile(folder_ / "waits-as-gaps-10-robots.schedule.yaml");
    EXPECT_THAT(text, HasSubstr("agent9:"));
    for (std::size_t at = text.find("  agent"); at != std::string::npos; at = text.find("\n  agent", at + 1))
    {
        const auto number = [&](const char *key)
        { return std::to_string(std::stoi(text.substr(text.find(key, at) + 3))); };
        const std::string cell = "[" + number("x: ") + ", " + number("y: ") + "]";
        agents += "  - {start: " + cell + ", goal: " + cell + "}\n";
    }
    writeFile(folder_ / "open.yaml", "map: {dimensions: [32, 32]}\nagents:\n" + agents);
    const LoadedInstance open = instance("open.yaml");
    EXPECT_EQ(open.instance.robotCount(), 10U);
    const SolutionRows answer = loadSolution(folder_ / "waits-as-gaps-10-robots.schedule.yaml", open);
    EXPECT_TRUE(validate(open.instance, answer.moves, MotionRule::rotation).legal);
}

TEST_F(FoundFormats, MapsKeepTheirSizeWhereTheBorderIsBlocked)
{
    (void)convertFile({folder_ / "border-blocked.yaml", folder_ / "b.scen", {}, {}, {}});
    EXPECT_THAT(readFile(folder_ / "b.map"), HasSubstr("height 4\nwidth 5\n"));
    EXPECT_THAT(readFile(folder_ / "b.scen"), HasSubstr("b.map\t5\t4\t0\t0\t3\t2\t"));
    EXPECT_EQ(instance("b.scen").instance.robotCount(), 1U);
}

TEST_F(FoundFormats, MapsNeedNoType)
{
    EXPECT_EQ(graph("map-without-type.map").graph->vertexCount(), 6U);
    EXPECT_THAT(instance("map-without-type.txt").instance.goals, ElementsAre(5));
}

TEST_F(FoundFormats, PathsOfOtherSystemsDoNoHarm)
{
    EXPECT_EQ(instance("foreign-path-kei18.txt").instance.graph->vertexCount(), 6U);
    EXPECT_EQ(instance("foreign-path.instance").instance.graph->vertexCount(), 6U);
    EXPECT_EQ(graphFileOf(folder_ / "foreign-path-kei18.txt"), folder_ / "m.map");
    EXPECT_EQ(graphFileOf(folder_ / "foreign-path.instance"), folder_ / "m.map");
}

TEST_F(FoundFormats, TheTrackersColumnsAreObeyed)
{
    const LoadedInstance row = instance("row.scen");
    const SolutionRows rows = loadSolution(folder_ / "tracker-two-scenarios.csv", row);
    EXPECT_TRUE(validate(row.instance, rows.moves, MotionRule::pebble).valid());
    EXPECT_EQ(loadSolution(folder_ / "tracker-quoted-heading.csv", row).moves.size(), 1U);
    writeFile(folder_ / "row-random-1.scen", readFile(folder_ / "row.scen"));
    const LoadedInstance random = instance("row-random-1.scen");
    EXPECT_EQ(loadSolution(folder_ / "tracker-two-scenarios.csv", random).moves.front().to, 0);
    writeFile(folder_ / "other.csv", "map_name,agents,solution_plan\nden520d,1,r\n");
    EXPECT_THAT(refusal([&] { return loadSolution(folder_ / "other.csv", row); }),
                HasSubstr("the instance stands on the map 'row'"));
}

TEST_F(FoundFormats, CoordinatesOfAnySizeAreDrawnWithNumbers)
{
    for (const char *name : {"huge-coordinates", "tiny-coordinates"})
    {
        const Instance drawn = instance(std::string(name) + ".instance").instance;
        for (const char *extension : {".txt", ".xml"})
        {
            const auto file = folder_ / (std::string("moves") + extension);
            saveAnimation(file, drawn, Schedule({{0, 0, 1}, {0, 1, 2}}, {1, 2}));
            const auto graph = loadGraph(file).graph;
            const Graph &again = *graph;
            ASSERT_TRUE(again.hasCoordinates());
            EXPECT_GT(std::abs(again.coordinate(0).x - again.coordinate(1).x), 10) << name;
            EXPECT_LT(std::abs(again.coordinate(0).x), 1000) << name;
        }
    }
}

TEST_F(FoundFormats, ConvertBlamesTheInputWhereItIsUnknown)
{
    writeFile(folder_ / "x.txt", "hello\n");
    EXPECT_THAT(refusal(
                    [this] {
                        return convertFile({folder_ / "x.txt", folder_ / "y.graphml", {}, {}, {}});
                    }),
                HasSubstr("x.txt:1:1: this is plain text, which is not read"));
}

TEST_F(FoundFormats, InstancesForOutsideProgramsHoldNoLimitsAndTheMapsWholePath)
{
    const Instance given = instance("row.scen").instance;
    const Exchange exchange;
    exchange.writeInstance("kei18_instance", given, folder_ / "row.map", folder_ / "i.txt");
    EXPECT_EQ(readFile(folder_ / "i.txt"),
              "map_file=" + std::filesystem::absolute(folder_ / "row.map").string() +
                  "\nagents=1\nrandom_problem=0\n1,0,2,0\n");
    EXPECT_EQ(instance("i.txt").instance.fingerprint(), given.fingerprint());
}

TEST_F(FoundFormats, InstancesThatAFormatCannotHoldAreRefused)
{
    const Exchange exchange;
    const Instance tree{Graph::fromEdges(3, {{0, 1}, {1, 2}}), {0}, {2}};
    for (const char *format : {"libmrp_map", "kei18_instance", "movingai_scenario", "vetand_instance"})
        EXPECT_THROW(exchange.writeInstance(format, tree, folder_ / "t.map", folder_ / "t"), InputError)
            << format;
    exchange.writeInstance("libmrp_roadmap", tree, folder_ / "t.map", folder_ / "t");
    EXPECT_THAT(readFile(folder_ / "t"), HasSubstr("roadmap:"));
}

} // namespace
} // namespace mrpp

/// Files that are made to cost time or memory, and large ones that are not: each is read or refused within
/// seconds and a gigabyte, through the one door.

#include "problems/formats/Formats.h"

#include "framework/support/Error.h"
#include "framework/system/Memory.h"
#include "tests/support/CpuClock.h"
#include "tests/support/RandomCases.h"

#include <functional>
#include <gtest/gtest.h>
#include <unistd.h>

namespace mrpp
{
namespace
{

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr double kSlower = 10; // than without sanitizers
#else
constexpr double kSlower = 1;
#endif

std::string times(std::size_t count, const std::string &text)
{
    std::string result;
    for (std::size_t i = 0; i < count; ++i)
        result += text;
    return result;
}

std::string numbered(std::size_t count, const std::string &front, const std::string &behind)
{
    std::string result;
    for (std::size_t i = 0; i < count; ++i)
        result += front + std::to_string(i) + behind;
    return result;
}

struct Hostile
{
    const char *name;
    std::function<std::string()> text;
};

void PrintTo(const Hostile &hostile, std::ostream *out)
{
    *out << hostile.name;
}

constexpr std::size_t kMany = 1000000;
const std::string kGraph = "<graphml><graph edgedefault=\"undirected\">";
const std::string kGroup = "yfiles.foldertype=\"group\"><graph>";

std::string lol(const std::string &begin, const std::string &front, const std::string &use,
                const std::string &behind, const std::string &end)
{
    std::string text = begin;
    for (int level = 1; level < 12; ++level)
        text +=
            front + std::to_string(level) + behind + times(10, use + std::to_string(level - 1) + ";,") + end;
    return text;
}

const Hostile kHostile[] = {
    {"YamlDeepLists", [] { return "map: " + times(kMany, "["); }},
    {"YamlDeepMaps", [] { return "map: " + times(kMany, "{a: "); }},
    {"YamlDeepBlocks", [] { return "map:\n" + times(kMany, "- "); }},
    {"YamlDeepKeys", [] { return "map:\n  " + times(kMany, "? "); }},
    {"YamlAliases", [] { return lol("map: 1\na0: &a0 x\n", "a", "*a", ": [", "]\n"); }},
    {"YamlManyKeys", [] { return "map:\n" + numbered(100000, "k", ": 1\n"); }},
    {"YamlManyDocuments", [] { return "map: 1\n" + times(kMany, "---\n"); }},
    {"YamlHugeMap", [] { return std::string("map: {dimensions: [2097152, 1]}\nagents: []\n"); }},
    {"YamlHugeNumbers", [] { return "map: {dimensions: [" + times(kMany, "9") + ", 1]}\nagents: []\n"; }},
    {"XmlDeep", [] { return "<graphml>" + times(kMany, "<graph>"); }},
    {"XmlDeepGroups",
     []
     {
         return kGraph + numbered(100000, "<node id=\"", "\" " + kGroup) + times(100000, "</graph></node>") +
                "</graph></graphml>";
     }},
    {"XmlEntities",
     []
     {
         return lol("<!DOCTYPE graphml [<!ENTITY a0 \"x\">", "<!ENTITY a", "&a", " \"", "\">") + "]>" +
                kGraph + "<node id=\"&a11;\"/></graph></graphml>";
     }},
    {"XmlManyAttributes",
     [] { return kGraph + "<node id=\"a\" " + numbered(100000, "b", "=\"1\" ") + "/></graph></graphml>"; }},
    {"XmlManyKeys",
     []
     {
         return "<graphml>" + numbered(50000, "<key for=\"node\" attr.name=\"n\" id=\"k", "\"/>") +
                kGraph.substr(9) + "<node id=\"a\">" + numbered(50000, "<data key=\"k", "\">1</data>") +
                "</node></graph></graphml>";
     }},
    {"JsonDeepLists", [] { return "{\"solution_plan\":" + times(kMany, "["); }},
    {"JsonDeepMaps", [] { return "{\"solution_plan\":" + times(kMany, "{\"a\":"); }},
    {"JsonHugeNumber", [] { return "{\"solution_plan\":" + times(kMany, "9") + "}"; }},
    {"CsvManyCells", [] { return "solution_plan" + times(kMany, ",") + "\n"; }},
    {"CsvManyRows", [] { return "solution_plan\n" + times(kMany, "r\n"); }},
    {"TrackerLongWaits", [] { return std::string("solution_plan\n\"9999999w\n9999999w\"\n"); }},
    {"MapHugeSize",
     [] { return std::string("type octile\nheight 2000000000\nwidth 2000000000\nmap\n..\n"); }},
    {"DimacsHugeSize", [] { return std::string("p edge 2000000000 1\ne 1 2\n"); }},
    {"EdgesHugeSize", [] { return std::string("# Nodes: 4000000000 Edges: 1\n0 1\n"); }},
    {"EdgesHugeVertex", [] { return std::string("0 999999\n0 999999999\n"); }},
    {"EdgesOneLine", [] { return times(kMany, "0 "); }},
    {"EdgesDeepData", [] { return "0 1 {'a': " + times(kMany, "["); }},
    {"CpfHugeRobot", [] { return std::string("V =\n(0:-1)[2000000000:0:0]\nE =\n"); }},
    {"SurynekHugeStep",
     [] {
         return std::string(
             "Fine solution\nLength:9223372036854775807\n1 # 0 ---> 1 (9223372036854775807)\n");
     }},
    {"GraphRecHugeStep",
     []
     {
         return std::string("id:1\nV =\n(1:0)[1:0:0]\n(2:0)[0:1:1]\nE =\n{1,2} (0)\n"
                            "1 ---> 2 (9223372036854775807)\nLength:1\n");
     }},
    {"KeiHugeNumber", [] { return std::string("map_file=a.map\nagents=2000000000\n0,0,1,1\n"); }},
    {"PathsLong", [] { return "Agent 0: " + times(kMany, "(0,0)->"); }},
    {"Nothing", [] { return times(kMany, "a "); }},
};

class HostileFile : public testing::TestWithParam<Hostile>
{};

TEST_P(HostileFile, IsReadOrRefused)
{
    const auto file = std::filesystem::path(testing::TempDir()) /
                      ("mrpp_hostile_" + std::to_string(::getpid()) + "_" + GetParam().name);
    writeFile(file, GetParam().text());
    const Instance instance{test::gridGraph(4, 2), {0}, {1}};
    const std::function<void()> doors[] = {[&] { (void)loadGraph(file); },
                                           [&] {
                                               (void)loadInstance({file, std::nullopt, std::nullopt});
                                           },
                                           [&] { (void)loadSolution(file, instance); }};
    for (const auto &door : doors)
    {
        resetPeakMemory();
        const double begin = test::cpuSeconds();
        try
        {
            door();
        }
        catch (const InputError &)
        {}
        EXPECT_LT(test::cpuSeconds() - begin, 2 * kSlower);
        EXPECT_LT(peakMemory(), 1000 * (kSlower > 1 ? 2 : 1)); // MB, with all that came before
    }
    std::filesystem::remove(file);
}

INSTANTIATE_TEST_SUITE_P(All, HostileFile, testing::ValuesIn(kHostile),
                         [](const auto &row) { return std::string(row.param.name); });

/// Reads a file; gives its vertices, and expects it to cost no more than this.
std::size_t vertices(const std::filesystem::path &file, double seconds, double megabytes)
{
    resetPeakMemory();
    const double before = peakMemory();
    const double begin = test::cpuSeconds();
    const LoadedGraph read = loadGraph(file);
    EXPECT_LT(test::cpuSeconds() - begin, seconds * kSlower);
    EXPECT_LT(peakMemory() - before, megabytes * kSlower);
    return read.graph->vertexCount();
}

TEST(LargeFile, GraphMlOf13MegabytesIsReadInHalfASecond)
{
    const auto file =
        std::filesystem::path(testing::TempDir()) / ("mrpp_l_" + std::to_string(::getpid()) + ".xml");
    saveGraph(file, *makeGridMap(310, 187, std::string(57970, '.')).graph);
    EXPECT_GT(std::filesystem::file_size(file), 12500000U);
    EXPECT_EQ(vertices(file, .5, 200), 57970U);
    std::filesystem::remove(file);
}

TEST(LargeFile, TheLargestMapIsReadInAThirdOfASecond)
{
    const auto file =
        std::filesystem::path(testing::TempDir()) / ("mrpp_l_" + std::to_string(::getpid()) + ".map");
    std::string text = "type octile\nheight 656\nwidth 1491\nmap\n";
    for (std::size_t y = 0; y < 656; ++y)
        text += std::string(1490, y % 7 == 0 ? '@' : '.') + ".\n";
    writeFile(file, text);
    EXPECT_EQ(vertices(file, .3, 200), 94U + 562U * 1491U);
    std::filesystem::remove(file);
}

} // namespace
} // namespace mrpp

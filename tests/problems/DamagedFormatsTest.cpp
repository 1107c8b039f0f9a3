/// Whatever happens to a file of any format, it is read or refused, within bounded time and memory.
/// MRPP_DAMAGED_FILES is the number of cases a format (1500 where it is not set).

#include "framework/support/Config.h"
#include "framework/support/Memory.h"
#include "problems/formats/GraphMl.h"
#include "problems/formats/GraphRec.h"
#include "problems/formats/GraphText.h"
#include "problems/formats/InstanceText.h"
#include "problems/formats/Kei18.h"
#include "problems/formats/LibMrpYaml.h"
#include "problems/formats/MovingAiScenario.h"
#include "problems/formats/Paths.h"
#include "problems/formats/SolutionCsv.h"
#include "problems/formats/Surynek.h"
#include "problems/formats/Tracker.h"

#include "tests/problems/FormatCases.h"
#include "tests/support/CpuClock.h"
#include "tests/support/Damage.h"

#include <cstdlib>
#include <functional>

namespace mrpp
{
namespace
{

constexpr const char *kMap = "type octile\nheight 2\nwidth 4\nmap\n....\n.@..\n";

GridMap room()
{
    return parseMovingAiMap(kMap, "room.map");
}

Instance roomInstance()
{
    return {room().graph, {0, 6}, {2, 3}};
}

Schedule roomSchedule()
{
    return Schedule({{0, 0, 1}, {1, 6, 3}, {0, 1, 2}}, {2, 3});
}

std::vector<std::string> roadmapNames()
{
    return {"A", "B", "C", "D", "é", "F: [", ""};
}

struct Format
{
    const char *name;
    std::string good;
    std::function<void(const std::string &)> read;
};

void PrintTo(const Format &format, std::ostream *out)
{
    *out << format.name;
}

/// What a solution's reader gives is validated, too: any numbers must be safe.
void judge(const SolutionRows &rows)
{
    const Verdict verdict = validate(roomInstance(), rows.moves, MotionRule::rotation);
    if (!verdict.legal && verdict.badMove < rows.moves.size())
        (void)rows.lineOf(verdict.badMove);
}

std::vector<Format> formats()
{
    const Instance instance = roomInstance();
    const Schedule schedule = roomSchedule();
    const auto graph = instance.graph;
    return {
        {"GraphMl", formatGraphMl(*graph), [](const std::string &t) { (void)parseGraphMl(t, "f"); }},
        {"YEd",
         "<graphml xmlns:y=\"y\"><key for=\"node\" id=\"d\" yfiles.type=\"nodegraphics\"/><graph id=\"G\">"
         "<node id=\"n0\" yfiles.foldertype=\"group\"><graph edgedefault=\"directed\"><node id=\"n0::n0\">"
         "<data key=\"d\"><y:ShapeNode><y:Geometry height=\"3\" width=\"3\" x=\"1\" y=\"5\"/></y:ShapeNode>"
         "</data></node></graph></node><node id=\"n1\"/><edge source=\"n1\" "
         "target=\"n0::n0\"/></graph></graphml>",
         [](const std::string &t) { (void)parseGraphMl(t, "f"); }},
        {"Map", kMap, [](const std::string &t) { (void)parseMovingAiMap(t, "f"); }},
        {"Scenario", formatMovingAiScenario(room(), instance, "room.map"),
         [](const std::string &t)
         {
             const Scenario scenario = parseMovingAiScenario(t, "f");
             (void)scenarioInstance(scenario, room(), scenario.records.size());
         }},
        {"InstanceText", formatInstanceText(instance, "room.map"),
         [](const std::string &t) { (void)textInstance(parseInstanceText(t, "f"), room().graph); }},
        {"Dimacs", formatDimacs(*graph), [](const std::string &t) { (void)parseDimacs(t, "f"); }},
        {"DimacsArcs", "c arcs\np sp 3 4\na 1 2 2.5\na 2 1 2.5\na 2 3 1\na 3 2 1\n",
         [](const std::string &t) { (void)parseDimacs(t, "f"); }},
        {"NetworkXEdgeList", "# x\n0 1 {}\n1 2 {'weight': 2.5, 'a': 'b'}\n",
         [](const std::string &t) { (void)parseEdgeList(t, "f"); }},
        {"EdgeList", formatEdgeList(*graph), [](const std::string &t) { (void)parseEdgeList(t, "f"); }},
        {"Cpf", formatCpf(instance), [](const std::string &t) { (void)parseCpf(t, "f"); }},
        {"Mpf", "V =\n(0,1,0)\n(1,0,2)\n(2,2,0)\n(3,0,1)\nE =\n{0,1}\n{1,2}\n{1,3}\n",
         [](const std::string &t) { (void)parseCpf(t, "f"); }},
        {"Kei18Instance", formatKei18Instance(instance, "room.map"),
         [](const std::string &t) { (void)kei18Instance(parseKei18Instance(t, "f"), room()); }},
        {"LibMrpGrid", formatLibMrpInstance(instance),
         [](const std::string &t) { (void)parseLibMrpInstance(t, "f"); }},
        {"LibMrpRoadmap",
         "roadmap:\n  undirected: true\n  vertices: {A: [0, 0], B: [1, 2]}\n  edges: [[A, B]]\n"
         "agents: [{name: a, start: A, goal: B}]\n",
         [](const std::string &t) { (void)parseLibMrpInstance(t, "f"); }},
        {"SolutionCsv", formatSolutionCsv(schedule),
         [](const std::string &t) { judge(parseSolutionCsv(t, "f")); }},
        {"SurynekSolution", formatSurynekSolution(schedule),
         [](const std::string &t) { judge(parseSurynekSolution(t, "f")); }},
        {"Kei18Result", formatKei18Result(instance, schedule, "room.map"),
         [](const std::string &t) { judge(parseKei18Result(t, "f", roomInstance())); }},
        {"LibMrpSchedule", formatLibMrpSchedule(instance, schedule),
         [](const std::string &t) { judge(parseLibMrpSchedule(t, "f", roomInstance())); }},
        {"LibMrpRoadmapSchedule", formatLibMrpSchedule(instance, schedule, roadmapNames()),
         [](const std::string &t) { judge(parseLibMrpSchedule(t, "f", roomInstance(), roadmapNames())); }},
        {"Paths", formatPaths(instance, schedule),
         [](const std::string &t) { judge(parsePaths(t, "f", roomInstance())); }},
        {"TrackerCsv", formatTracker(instance, schedule, TrackerForm::csv, {"room", "even", 1}),
         [](const std::string &t) { judge(parseTracker(t, "f", TrackerForm::csv, roomInstance())); }},
        {"TrackerJson", formatTracker(instance, schedule, TrackerForm::json, {"room", "even", 1}),
         [](const std::string &t) { judge(parseTracker(t, "f", TrackerForm::json, roomInstance())); }},
        {"TrackerRows", "agents,path,flip_up_down\n1,rr,TRUE\n2,\"2r\nwu\",FALSE\n",
         [](const std::string &t) { judge(parseTracker(t, "f", TrackerForm::csv, roomInstance())); }},
        {"GraphRec", formatGraphRec(instance, schedule),
         [](const std::string &t) { judge(graphRecRows(parseGraphRec(t, "f"), roomInstance())); }},
        {"GraphRecXml", formatGraphRec(instance, schedule, MotionRule::rotation, GraphRecForm::xml),
         [](const std::string &t) { judge(graphRecRows(parseGraphRecXml(t, "f"), roomInstance())); }},
    };
}

class DamagedFormat : public testing::TestWithParam<Format>
{};

TEST_P(DamagedFormat, IsReadOrRefused)
{
    const Format &format = GetParam();
    ASSERT_NO_THROW(format.read(format.good));
    const char *setting = std::getenv("MRPP_DAMAGED_FILES");
    const std::int64_t cases = parseInteger(setting == nullptr ? "1500" : setting).value_or(1500);
    Random random(deriveSeed(20, format.name));
    std::size_t read = 0;
    std::size_t refused = 0;
    resetPeakMemory();
    for (std::int64_t i = 0; i < cases; ++i)
    {
        const std::string text = test::damaged(format.good, random);
        const double begin = test::cpuSeconds();
        try
        {
            format.read(text);
            ++read;
        }
        catch (const InputError &)
        {
            ++refused;
        }
        catch (const std::exception &error)
        {
            FAIL() << "case " << i << ": " << error.what() << "\n" << text;
        }
        ASSERT_LT(test::cpuSeconds() - begin, 2) << "case " << i << "\n" << text;
        ASSERT_LT(peakMemory(), 1000) << "case " << i << "\n" << text; // MB, with all that came before
    }
    EXPECT_GT(refused, read / 20);
}

INSTANTIATE_TEST_SUITE_P(All, DamagedFormat, testing::ValuesIn(formats()),
                         [](const auto &row) { return std::string(row.param.name); });

} // namespace
} // namespace mrpp

/// Whatever happens to a file of any format, it is read or refused, within bounded time and memory.
/// MRPP_DAMAGED_FILES is the number of cases a format (1500 where it is not set).

#include "framework/support/Config.h"
#include "framework/support/Random.h"
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

#include <chrono>
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
        {"Paths", formatPaths(instance, schedule),
         [](const std::string &t) { judge(parsePaths(t, "f", roomInstance())); }},
        {"TrackerCsv", formatTracker(instance, schedule, TrackerForm::csv, {"room", "even", 1}),
         [](const std::string &t) { judge(parseTracker(t, "f", TrackerForm::csv, roomInstance())); }},
        {"TrackerJson", formatTracker(instance, schedule, TrackerForm::json, {"room", "even", 1}),
         [](const std::string &t) { judge(parseTracker(t, "f", TrackerForm::json, roomInstance())); }},
        {"GraphRec", formatGraphRec(instance, schedule),
         [](const std::string &t) { judge(graphRecRows(parseGraphRec(t, "f"), roomInstance())); }},
        {"GraphRecXml", formatGraphRec(instance, schedule, MotionRule::rotation, GraphRecForm::xml),
         [](const std::string &t) { judge(graphRecRows(parseGraphRecXml(t, "f"), roomInstance())); }},
    };
}

std::string damaged(std::string text, Random &random)
{
    static const std::vector<std::string> oddities = {"99999999999999999999",
                                                      "4294967295",
                                                      "4294967296",
                                                      "-1",
                                                      "2147483648",
                                                      "1e308",
                                                      "nan",
                                                      "0x10",
                                                      std::string(1, '\0'),
                                                      "\xFF\xFE",
                                                      "\r",
                                                      "\n",
                                                      "\"",
                                                      "'",
                                                      "{",
                                                      "[",
                                                      std::string(600, '['),
                                                      std::string(600, '{'),
                                                      std::string(300, '<'),
                                                      "<a><b>",
                                                      ": ",
                                                      "- ",
                                                      "&a ",
                                                      "*a",
                                                      "--->",
                                                      ",,,,",
                                                      "1000000",
                                                      "999999999w",
                                                      "\t",
                                                      "  "};
    const std::uint64_t damages = 1 + random.below(3);
    for (std::uint64_t i = 0; i < damages && !text.empty(); ++i)
    {
        const auto at = static_cast<std::size_t>(random.below(text.size()));
        const auto length = static_cast<std::size_t>(1 + random.below(20));
        switch (random.below(7))
        {
        case 0:
            text.resize(at);
            break;
        case 1:
            text[at] = static_cast<char>(random.below(256));
            break;
        case 2:
            text.erase(at, length);
            break;
        case 3:
            text.insert(at, text.substr(static_cast<std::size_t>(random.below(text.size())), 4 * length));
            break;
        case 4:
            text.insert(at, oddities[static_cast<std::size_t>(random.below(oddities.size()))]);
            break;
        case 5: { // a number becomes another
            const std::size_t digit = text.find_first_of("0123456789", at);
            if (digit != std::string::npos)
                text.replace(digit, 1, oddities[static_cast<std::size_t>(random.below(5))]);
            break;
        }
        default: { // a piece many times
            const std::string piece = text.substr(at, length);
            for (int repetition = 0; repetition < 200; ++repetition)
                text.insert(at, piece);
        }
        }
    }
    return text;
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
    for (std::int64_t i = 0; i < cases; ++i)
    {
        const std::string text = damaged(format.good, random);
        const auto begin = std::chrono::steady_clock::now();
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
        const std::chrono::duration<double> time = std::chrono::steady_clock::now() - begin;
        ASSERT_LT(time.count(), 10) << "case " << i; // 0.1 s on a free machine without sanitizers
    }
    EXPECT_GT(refused, read / 20);
}

INSTANTIATE_TEST_SUITE_P(All, DamagedFormat, testing::ValuesIn(formats()),
                         [](const auto &row) { return std::string(row.param.name); });

} // namespace
} // namespace mrpp

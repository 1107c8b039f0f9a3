#include "tests/problems/FormatReaders.h"

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
#include "problems/formats/VetandXml.h"

#include <ostream>

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

/// What a solution's reader gives is validated, too: any numbers must be safe.
void judge(const SolutionRows &rows)
{
    const Verdict verdict = validate(roomInstance(), rows.moves, MotionRule::rotation);
    if (!verdict.legal && verdict.badMove < rows.moves.size())
        (void)rows.lineOf(verdict.badMove);
}

} // namespace

void PrintTo(const FormatReader &format, std::ostream *out)
{
    *out << format.name;
}

std::vector<FormatReader> formatReaders()
{
    const Instance instance = roomInstance();
    const Schedule schedule = roomSchedule();
    const auto graph = instance.graph;
    return {
        {"GraphMl", FormatId::graphMl, formatGraphMl(*graph),
         [](const std::string &t) { (void)parseGraphMl(t, "f"); }},
        {"YEd", FormatId::graphMl,
         "<graphml xmlns:y=\"y\"><key for=\"node\" id=\"d\" yfiles.type=\"nodegraphics\"/><graph id=\"G\">"
         "<node id=\"n0\" yfiles.foldertype=\"group\"><graph edgedefault=\"directed\"><node id=\"n0::n0\">"
         "<data key=\"d\"><y:ShapeNode><y:Geometry height=\"3\" width=\"3\" x=\"1\" y=\"5\"/></y:ShapeNode>"
         "</data></node></graph></node><node id=\"n1\"/><edge source=\"n1\" "
         "target=\"n0::n0\"/></graph></graphml>",
         [](const std::string &t) { (void)parseGraphMl(t, "f"); }},
        {"Map", FormatId::movingAiMap, kMap, [](const std::string &t) { (void)parseMovingAiMap(t, "f"); }},
        {"Scenario", FormatId::scenario, formatMovingAiScenario(room(), instance, "room.map"),
         [](const std::string &t)
         {
             const Scenario scenario = parseMovingAiScenario(t, "f");
             (void)scenarioInstance(scenario, room(), scenario.records.size());
         }},
        {"InstanceText", FormatId::instanceText, formatInstanceText(instance, "room.map"),
         [](const std::string &t) { (void)textInstance(parseInstanceText(t, "f"), room().graph); }},
        {"Dimacs", FormatId::dimacs, formatDimacs(*graph),
         [](const std::string &t) { (void)parseDimacs(t, "f"); }},
        {"DimacsArcs", FormatId::dimacs, "c arcs\np sp 3 4\na 1 2 2.5\na 2 1 2.5\na 2 3 1\na 3 2 1\n",
         [](const std::string &t) { (void)parseDimacs(t, "f"); }},
        {"NetworkXEdgeList", FormatId::edgeList, "# x\n0 1 {}\n1 2 {'weight': 2.5, 'a': 'b'}\n",
         [](const std::string &t) { (void)parseEdgeList(t, "f"); }},
        {"Konect", FormatId::edgeList, "% sym unweighted\n% 3 4 4\n1 2\n2 3\n3 4\n",
         [](const std::string &t) { (void)parseEdgeList(t, "f"); }},
        {"EdgeListWithGaps", FormatId::edgeList, "# Nodes: 4 Edges: 3\n17\t4\n17\t902\n902\t30011\n",
         [](const std::string &t) { (void)parseEdgeList(t, "f"); }},
        {"MatrixMarket", FormatId::matrixMarket,
         "%%MatrixMarket matrix coordinate real symmetric\n% a path\n4 4 3\n2 1 1\n3 2 0.5\n4 3 1\n",
         [](const std::string &t) { (void)parseMatrixMarket(t, "f"); }},
        {"EdgeList", FormatId::edgeList, formatEdgeList(*graph),
         [](const std::string &t) { (void)parseEdgeList(t, "f"); }},
        {"Cpf", FormatId::cpf, formatCpf(instance), [](const std::string &t) { (void)parseCpf(t, "f"); }},
        {"Mpf", FormatId::cpf, "V =\n(0,1,0)\n(1,0,2)\n(2,2,0)\n(3,0,1)\nE =\n{0,1}\n{1,2}\n{1,3}\n",
         [](const std::string &t) { (void)parseCpf(t, "f"); }},
        {"Kei18Instance", FormatId::kei18Instance, formatKei18Instance(instance, "room.map"),
         [](const std::string &t) { (void)kei18Instance(parseKei18Instance(t, "f"), room()); }},
        {"LibMrpGrid", FormatId::libMrpInstance, formatLibMrpInstance(instance),
         [](const std::string &t) { (void)parseLibMrpInstance(t, "f"); }},
        {"LibMrpRoadmap", FormatId::libMrpInstance,
         "roadmap:\n  undirected: true\n  vertices: {A: [0, 0], B: [1, 2]}\n  edges: [[A, B]]\n"
         "agents: [{name: a, start: A, goal: B}]\n",
         [](const std::string &t) { (void)parseLibMrpInstance(t, "f"); }},
        {"LibMrpRoadmapWithoutVertices", FormatId::libMrpInstance,
         "roadmap:\n  undirected: True\n  allow_wait_actions: no\n  edges:\n    - [A, B]\n    - [B, C]\n"
         "agents:\n  - name: x\n    start: A\n    goal: C\n",
         [](const std::string &t) { (void)parseLibMrpInstance(t, "f"); }},
        {"LibMrpSipp", FormatId::libMrpInstance,
         "start: [0, 1]\ngoal: [2, 3]\nenvironment:\n  size: [4, 4]\n  obstacles: []\n",
         [](const std::string &t) { (void)parseLibMrpInstance(t, "f"); }},
        {"LibMrpScheduleWithGaps", FormatId::libMrpSchedule,
         "schedule:\n  agent0:\n    - {x: 0, y: 0, t: 0}\n    - {x: 1, y: 0, t: 5}\n  agent1:\n"
         "    - {x: 3, y: 1, t: 0}\n    - {x: 3, y: 0, t: 90000000000}\n",
         [](const std::string &t) { judge(parseLibMrpSchedule(t, "f", roomInstance())); }},
        {"VetandInstance", FormatId::vetandInstance, formatVetandInstance(instance),
         [](const std::string &t) { (void)parseVetandInstance(t, "f"); }},
        {"VetandResult", FormatId::vetandResult, formatVetandResult(instance, schedule),
         [](const std::string &t) { judge(parseVetandResult(t, "f", roomInstance())); }},
        {"SolutionCsv", FormatId::solutionCsv, formatSolutionCsv(schedule),
         [](const std::string &t) { judge(parseSolutionCsv(t, "f")); }},
        {"SurynekSolution", FormatId::surynekSolution, formatSurynekSolution(schedule),
         [](const std::string &t) { judge(parseSurynekSolution(t, "f")); }},
        {"Kei18Result", FormatId::kei18Result, formatKei18Result(instance, schedule, "room.map"),
         [](const std::string &t) { judge(parseKei18Result(t, "f", roomInstance())); }},
        {"LibMrpSchedule", FormatId::libMrpSchedule, formatLibMrpSchedule(instance, schedule),
         [](const std::string &t) { judge(parseLibMrpSchedule(t, "f", roomInstance())); }},
        {"LibMrpRoadmapSchedule", FormatId::libMrpSchedule,
         formatLibMrpSchedule(instance, schedule, roadmapNames()),
         [](const std::string &t) { judge(parseLibMrpSchedule(t, "f", roomInstance(), roadmapNames())); }},
        {"Paths", FormatId::paths, formatPaths(instance, schedule),
         [](const std::string &t) { judge(parsePaths(t, "f", roomInstance())); }},
        {"TrackerCsv", FormatId::trackerCsv,
         formatTracker(instance, schedule, TrackerForm::csv, {"room", "even", 1}),
         [](const std::string &t) { judge(parseTracker(t, "f", TrackerForm::csv, roomInstance())); }},
        {"TrackerJson", FormatId::trackerJson,
         formatTracker(instance, schedule, TrackerForm::json, {"room", "even", 1}),
         [](const std::string &t) { judge(parseTracker(t, "f", TrackerForm::json, roomInstance())); }},
        {"TrackerRows", FormatId::trackerCsv, "agents,path,flip_up_down\n1,rr,TRUE\n2,\"2r\nwu\",FALSE\n",
         [](const std::string &t) { judge(parseTracker(t, "f", TrackerForm::csv, roomInstance())); }},
        {"GraphRec", FormatId::graphRec, formatGraphRec(instance, schedule),
         [](const std::string &t) { judge(graphRecRows(parseGraphRec(t, "f"), roomInstance())); }},
        {"GraphRecXml", FormatId::graphRecXml,
         formatGraphRec(instance, schedule, MotionRule::rotation, GraphRecForm::xml),
         [](const std::string &t) { judge(graphRecRows(parseGraphRecXml(t, "f"), roomInstance())); }},
    };
}

} // namespace mrpp

#include "problems/formats/FormatId.h"

#include "framework/support/Config.h"
#include "problems/formats/Formats.h"
#include "problems/formats/TextReader.h"

#include <algorithm>
#include <cctype>

namespace mrpp
{

namespace
{

bool isOneOf(std::string_view word, std::initializer_list<std::string_view> words)
{
    return std::find(words.begin(), words.end(), word) != words.end();
}

/// Whether some line begins with these characters.
bool hasLine(std::string_view text, std::string_view begin)
{
    for (std::size_t at = text.find(begin); at != std::string_view::npos; at = text.find(begin, at + 1))
        if (at == 0 || text[at - 1] == '\n')
            return true;
    return false;
}

/// A record of a scenario without its first line: text, and seven numbers at the end.
bool isScenarioRecord(std::string_view line)
{
    constexpr std::size_t longest = 1000;
    std::size_t words = 0;
    std::size_t numbers = 0; // since the last word that is none
    for (LineCursor cursor(trimmed(line.substr(0, longest))); !cursor.atEnd(); ++words)
        numbers = parseNumber(cursor.word()) ? numbers + 1 : 0;
    return words >= 9 && numbers >= 7 && numbers < words;
}

/// Two numbers in the first line that is no comment.
bool beginsWithAnEdge(std::string_view text)
{
    TextReader reader(text, "");
    while (const auto line = reader.next())
    {
        LineCursor cursor(*line);
        if (cursor.atEnd() || cursor.take("#") || cursor.take("%"))
            continue;
        const auto first = parseInteger(cursor.until(", \t"));
        (void)cursor.take(",");
        return first && parseInteger(cursor.until(", \t"));
    }
    return hasLine(text, "# Nodes:");
}

FormatId byFirstWord(std::string_view text)
{
    const std::size_t wordEnd = std::min(text.find_first_of(" \t\r\n:="), text.size());
    const std::string_view word = text.substr(0, wordEnd);
    const bool colon = text.substr(wordEnd, 1) == ":";
    const std::string_view line = text.substr(0, text.find('\n'));
    if (text.starts_with('<'))
        return text.substr(0, 2000).find("<graphrec") != std::string_view::npos ? FormatId::graphRecXml
                                                                                : FormatId::graphMl;
    if (!colon && isOneOf(word, {"type", "height", "width", "map"}))
        return FormatId::movingAiMap;
    if (!colon && word == "version")
        return FormatId::scenario;
    if (word == "agent" || (word == "graph" && line.find('=') != std::string_view::npos))
        return FormatId::instanceText;
    if (word == "Agent")
        return FormatId::paths;
    if (!colon && isOneOf(word, {"c", "p"}))
        return FormatId::dimacs;
    if ((word == "id" || word == "ID") && colon)
        return FormatId::graphRec;
    if (isScenarioRecord(line))
        return FormatId::scenario;
    if (trimmed(word.substr(0, word.find(','))) == "step")
        return FormatId::solutionCsv;
    const bool isOldTracker = line.starts_with("agents,") && trimmed(line).ends_with(",path");
    if (isOldTracker ||
        (line.find("solution_plan") != std::string_view::npos && !isOneOf(text.substr(0, 1), {"{", "["})))
        return FormatId::trackerCsv;
    return FormatId::unknown;
}

/// By lines that stand anywhere, in files whose beginning may be anything.
FormatId byAnyLine(std::string_view text)
{
    if (hasLine(text, "V =") || hasLine(text, "V=") || hasLine(text, "v ="))
        return hasLine(text, "Length:") || hasLine(text, "length:") ? FormatId::graphRec : FormatId::cpf;
    if (hasLine(text, "Fine solution"))
        return FormatId::surynekSolution;
    if (hasLine(text, "solution="))
        return FormatId::kei18Result;
    if (hasLine(text, "agents="))
        return FormatId::kei18Instance;
    if (isOneOf(text.substr(0, 1), {"{", "["}) && text.find("\"solution_plan\"") != std::string_view::npos)
        return FormatId::trackerJson;
    if (hasLine(text, "schedule:"))
        return FormatId::libMrpSchedule;
    if (hasLine(text, "map:") || hasLine(text, "roadmap:"))
        return FormatId::libMrpInstance;
    return beginsWithAnEdge(text) ? FormatId::edgeList : FormatId::unknown;
}

} // namespace

FormatId formatOf(const std::filesystem::path &file, std::string_view text)
{
    text = trimmed(withoutByteOrderMark(text));
    if (const FormatId format = byFirstWord(text); format != FormatId::unknown)
        return format;
    if (const FormatId format = byAnyLine(text); format != FormatId::unknown)
        return format;

    std::string extension = file.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    if (isOneOf(extension, {".graphml", ".xml", ".gml"}))
        return FormatId::graphMl;
    if (extension == ".map")
        return FormatId::movingAiMap;
    if (extension == ".scen")
        return FormatId::scenario;
    if (isOneOf(extension, {".cpf", ".ccpf", ".mpf", ".cmpf"}))
        return FormatId::cpf;
    if (extension == ".csv")
        return FormatId::solutionCsv;
    if (isOneOf(extension, {".yaml", ".yml"}))
        return text.find("schedule") != std::string_view::npos ? FormatId::libMrpSchedule
                                                               : FormatId::libMrpInstance;
    return extension == ".instance" ? FormatId::instanceText : FormatId::unknown;
}

std::string_view nameOf(FormatId format)
{
    switch (format)
    {
    case FormatId::graphMl:
        return "graphml";
    case FormatId::movingAiMap:
        return "movingai_map";
    case FormatId::dimacs:
        return "dimacs";
    case FormatId::edgeList:
        return "edge_list";
    case FormatId::instanceText:
        return "instance";
    case FormatId::scenario:
        return "movingai_scenario";
    case FormatId::cpf:
        return "cpf";
    case FormatId::kei18Instance:
        return "kei18_instance";
    case FormatId::libMrpInstance:
        return "libmrp_instance";
    case FormatId::solutionCsv:
        return "solution";
    case FormatId::surynekSolution:
        return "surynek_solution";
    case FormatId::kei18Result:
        return "kei18_result";
    case FormatId::libMrpSchedule:
        return "libmrp_schedule";
    case FormatId::paths:
        return "paths";
    case FormatId::trackerCsv:
        return "tracker_csv";
    case FormatId::trackerJson:
        return "tracker_json";
    case FormatId::graphRec:
        return "graphrec";
    case FormatId::graphRecXml:
        return "graphrec_xml";
    case FormatId::planViz:
        return "planviz";
    case FormatId::unknown:
        break;
    }
    return {};
}

bool holdsGraph(FormatId format)
{
    switch (format)
    {
    case FormatId::graphMl:
    case FormatId::movingAiMap:
    case FormatId::dimacs:
    case FormatId::edgeList:
    case FormatId::cpf:
    case FormatId::libMrpInstance:
    case FormatId::graphRec:
    case FormatId::graphRecXml:
        return true;
    default:
        return false;
    }
}

bool holdsInstance(FormatId format)
{
    switch (format)
    {
    case FormatId::instanceText:
    case FormatId::scenario:
    case FormatId::cpf:
    case FormatId::kei18Instance:
    case FormatId::libMrpInstance:
    case FormatId::graphRec:
        return true;
    default:
        return false;
    }
}

bool holdsSolution(FormatId format)
{
    switch (format)
    {
    case FormatId::solutionCsv:
    case FormatId::surynekSolution:
    case FormatId::kei18Result:
    case FormatId::libMrpSchedule:
    case FormatId::paths:
    case FormatId::trackerCsv:
    case FormatId::trackerJson:
    case FormatId::graphRec:
    case FormatId::graphRecXml:
        return true;
    default:
        return false;
    }
}

std::vector<FileFormat> fileFormats()
{
    return {
        {"graphml", ".graphml .xml .gml", "graph", true, true,
         "GraphML of this program and of others (NetworkX, yEd, igraph, Boost, roadmaps)"},
        {"movingai_map", ".map", "graph", true, true, "grid map of the Moving AI Lab's benchmarks"},
        {"dimacs", ".dimacs .col .gr", "graph", true, true, "DIMACS: 'p edge', 'p col' or 'p sp'"},
        {"edge_list", ".edges .edgelist", "graph", true, true, "two vertices a line, and perhaps a weight"},
        {"instance", ".instance", "instance", true, true,
         "text: 'graph = <file>', then 'agent: start = <vertex>, goal = <vertex>' for each robot"},
        {"movingai_scenario", ".scen", "instance", true, true,
         "starts and goals on a grid map, of the Moving AI Lab's benchmarks"},
        {"cpf", ".cpf .ccpf .mpf .cmpf", "graph and instance", true, true,
         "problem of Surynek's programs (BIBOX, reLOC, boOX)"},
        {"kei18_instance", ".txt", "instance", true, true,
         "starts and goals on a grid map, of Kei18's programs (mapf-IR, pibt2)"},
        {"libmrp_instance", ".yaml .yml", "graph and instance", true, true,
         "grid or roadmap with robots, of libMultiRobotPlanning"},
        {"solution", ".csv", "solution", true, true,
         "rows 'step,robot,from,to': a solution, or a schedule of moves at once"},
        {"surynek_solution", ".txt", "solution", true, true, "moves of Surynek's programs"},
        {"kei18_result", ".txt", "solution", true, true,
         "robots' cells at each time, of Kei18's programs (mapf-IR, pibt2, lacam)"},
        {"libmrp_schedule", ".yaml .yml", "solution", true, true, "schedule of libMultiRobotPlanning"},
        {"paths", ".txt", "solution", true, true, "robots' paths of EECBS and MAPF-LNS"},
        {"tracker_csv", ".csv", "solution", true, true, "plan of the MAPF tracker as CSV"},
        {"tracker_json", ".json", "solution", true, true, "plan of the MAPF tracker as JSON"},
        {"graphrec", ".txt", "animation", true, true,
         "animation for GraphRec, its text form 'Multirobot': graph, robots and moves"},
        {"graphrec_xml", ".xml", "animation", true, true,
         "animation for GraphRec, its XML: graph, robots and moves"},
        {"planviz", ".json", "animation", false, true,
         "animation for PlanViz, the viewer of the League of Robot Runners"},
    };
}

} // namespace mrpp

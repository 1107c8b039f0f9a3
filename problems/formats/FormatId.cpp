#include "problems/formats/FormatId.h"

#include "framework/support/Config.h"
#include "problems/formats/Formats.h"
#include "problems/formats/support/ForeignFormats.h"
#include "problems/formats/support/TextReader.h"

#include <algorithm>
#include <array>

namespace mrpp
{

namespace
{

struct Format
{
    FormatId id;
    std::string_view name;
    const char *extensions;
    const char *holds;     ///< as a person would say it
    const char *canBeRead; ///< of g(raph), i(nstance) and s(olution)
    bool isWritten;
    std::string_view description; ///< "this is …"
    const char *help;
};

constexpr std::array kFormats = {
    Format{FormatId::graphMl, "graphml", ".graphml .xml .gml", "graph", "g", true, "GraphML",
           "GraphML of this program and of others (NetworkX, yEd, igraph, Boost, roadmaps)"},
    Format{FormatId::movingAiMap, "movingai_map", ".map", "graph", "g", true, "a MovingAI map",
           "grid map of the Moving AI Lab's benchmarks"},
    Format{FormatId::dimacs, "dimacs", ".dimacs .col .gr", "graph", "g", true, "a graph as DIMACS",
           "DIMACS: 'p edge', 'p col' or 'p sp'"},
    Format{FormatId::edgeList, "edge_list", ".edges .edgelist", "graph", "g", true, "a list of edges",
           "two vertices a line, and perhaps a weight"},
    Format{FormatId::matrixMarket, "matrix_market", ".mtx", "graph", "g", false, "a Matrix Market file",
           "sparse square matrix of Matrix Market, as the graph of its entries"},
    Format{FormatId::instanceText, "instance", ".instance", "instance", "i", true, "instance text",
           "text: 'graph = <file>', then 'agent: start = <vertex>, goal = <vertex>' for each robot"},
    Format{FormatId::scenario, "movingai_scenario", ".scen", "instance", "i", true, "a MovingAI scenario",
           "starts and goals on a grid map, of the Moving AI Lab's benchmarks"},
    Format{FormatId::cpf, "cpf", ".cpf .ccpf .mpf .cmpf", "graph and instance", "gi", true,
           "a problem of Surynek's programs", "problem of Surynek's programs (BIBOX, reLOC, boOX)"},
    Format{FormatId::kei18Instance, "kei18_instance", ".txt", "instance", "i", true,
           "an instance of Kei18's programs",
           "starts and goals on a grid map, of Kei18's programs (mapf-IR, pibt2)"},
    Format{FormatId::libMrpInstance, "libmrp_instance", ".yaml .yml", "graph and instance", "gi", true,
           "an instance of libMultiRobotPlanning", "grid or roadmap with robots, of libMultiRobotPlanning"},
    Format{FormatId::libMrpInstance, "libmrp_map", ".yaml .yml", "graph and instance", "", true,
           "an instance of libMultiRobotPlanning", "the same as a map, or not at all (cbs, ecbs, sipp)"},
    Format{FormatId::libMrpInstance, "libmrp_roadmap", ".yaml .yml", "graph and instance", "", true,
           "an instance of libMultiRobotPlanning", "the same as a roadmap, or not at all (cbs_roadmap)"},
    Format{FormatId::vetandInstance, "vetand_instance", ".xml", "graph and instance", "gi", true,
           "an instance of vetand's Push and Rotate", "grid with robots, of vetand's Push and Rotate (XML)"},
    Format{FormatId::solutionCsv, "solution", ".csv", "solution", "s", true, "a solution as CSV",
           "rows 'step,robot,from,to': a solution, or a schedule of moves at once"},
    Format{FormatId::surynekSolution, "surynek_solution", ".txt", "solution", "s", true,
           "a solution of Surynek's programs", "moves of Surynek's programs"},
    Format{FormatId::kei18Result, "kei18_result", ".txt", "solution", "s", true,
           "a result of Kei18's programs",
           "robots' cells at each time, of Kei18's programs (mapf-IR, pibt2, lacam)"},
    Format{FormatId::libMrpSchedule, "libmrp_schedule", ".yaml .yml", "solution", "s", true,
           "a schedule of libMultiRobotPlanning", "schedule of libMultiRobotPlanning"},
    Format{FormatId::vetandResult, "vetand_result", ".xml", "solution", "gis", true,
           "an answer of vetand's Push and Rotate",
           "grid with robots and their moves, of vetand's Push and Rotate (XML)"},
    Format{FormatId::paths, "paths", ".txt", "solution", "s", true, "paths of EECBS or MAPF-LNS",
           "robots' paths of EECBS and MAPF-LNS"},
    Format{FormatId::trackerCsv, "tracker_csv", ".csv", "solution", "s", true, "a plan of the MAPF tracker",
           "plan of the MAPF tracker as CSV"},
    Format{FormatId::trackerJson, "tracker_json", ".json", "solution", "s", true,
           "a plan of the MAPF tracker", "plan of the MAPF tracker as JSON"},
    Format{FormatId::graphRec, "graphrec", ".txt", "animation", "gis", true, "an animation for GraphRec",
           "animation for GraphRec, its text form 'Multirobot': graph, robots and moves"},
    Format{FormatId::graphRecXml, "graphrec_xml", ".xml", "animation", "gs", true,
           "an animation for GraphRec (XML)", "animation for GraphRec, its XML: graph, robots and moves"},
    Format{FormatId::planViz, "planviz", ".json", "animation", "", true, "a plan for PlanViz",
           "animation for PlanViz 2.1 and later, the viewer of the League of Robot Runners"},
    Format{FormatId::planViz, "planviz_2_0", ".json", "animation", "", true, "a plan for PlanViz",
           "the same for PlanViz 1.3.5 to 2.0.0, where U and D mean each other's direction"},
};

/// The first of that id: the one that is read.
const Format *find(FormatId id)
{
    const auto *found = std::find_if(kFormats.begin(), kFormats.end(),
                                     [id](const Format &format) { return format.id == id; });
    return found == kFormats.end() ? nullptr : found;
}

bool canBeRead(FormatId id, char what)
{
    const Format *format = find(id);
    return format != nullptr && std::string_view(format->canBeRead).find(what) != std::string_view::npos;
}

bool isOneOf(std::string_view word, std::initializer_list<std::string_view> words)
{
    return std::find(words.begin(), words.end(), word) != words.end();
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

/// Two numbers in the first line that is no comment, and perhaps a weight.
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
        if (!first || !parseInteger(cursor.until(", \t")))
            return false;
        (void)cursor.take(",");
        if (cursor.atEnd() || cursor.take("{") || cursor.take("#") || cursor.take("%"))
            return true;
        (void)cursor.until(", \t");
        return cursor.atEnd() || cursor.take("#") || cursor.take("%");
    }
    return hasLine(text, "# Nodes:");
}

/// The names in a heading of CSV, perhaps in quotation marks; as `,a,b,`.
std::string headingOf(std::string_view line)
{
    std::string names = ",";
    for (const char c : trimmed(line))
        if (c != '"' && c != ' ' && c != '\t')
            names += c;
    return names + ',';
}

FormatId ofXml(std::string_view text)
{
    const std::string_view root = rootElement(text);
    if (root == "graphml")
        return FormatId::graphMl;
    if (root == "graphrec")
        return FormatId::graphRecXml;
    if (root != "root" || text.find("<map") == std::string_view::npos ||
        text.find("<grid") == std::string_view::npos)
        return FormatId::unknown;
    return text.find("<log") != std::string_view::npos && text.find("<paths") != std::string_view::npos
               ? FormatId::vetandResult
               : FormatId::vetandInstance;
}

/// JSON in one object or list, which may be YAML, too.
FormatId ofJson(std::string_view text)
{
    const auto has = [text](std::string_view word) { return text.find(word) != std::string_view::npos; };
    if (has("\"solution_plan\""))
        return FormatId::trackerJson;
    if (has("\"actionModel\"") && has("\"actualPaths\""))
        return FormatId::planViz;
    if (has("\"schedule\""))
        return FormatId::libMrpSchedule;
    return has("\"agents\"") && (has("\"map\"") || has("\"roadmap\"")) ? FormatId::libMrpInstance
                                                                       : FormatId::unknown;
}

FormatId byFirstWord(std::string_view text)
{
    const std::size_t wordEnd = std::min(text.find_first_of(" \t\r\n:="), text.size());
    const std::string_view word = text.substr(0, wordEnd);
    const bool colon = text.substr(wordEnd, 1) == ":";
    const std::string_view line = text.substr(0, text.find('\n'));
    if (text.starts_with('<'))
        return ofXml(text);
    if (isOneOf(text.substr(0, 1), {"{", "["}))
        return ofJson(text);
    if (text.starts_with("%%MatrixMarket"))
        return FormatId::matrixMarket;
    if (!colon && isOneOf(word, {"type", "height", "width", "map"}))
        return FormatId::movingAiMap;
    if (!colon && word == "version")
        return FormatId::scenario;
    if ((word == "agent" && colon) || (word == "graph" && line.find('=') != std::string_view::npos))
        return FormatId::instanceText;
    if (word == "Agent")
        return FormatId::paths;
    if (!colon && isOneOf(word, {"c", "p"}))
        return FormatId::dimacs;
    if ((word == "id" || word == "ID") && colon)
        return FormatId::graphRec;
    if (isScenarioRecord(line))
        return FormatId::scenario;
    const std::string heading = headingOf(line);
    if (heading.starts_with(",step,robot,"))
        return FormatId::solutionCsv;
    const auto hasColumn = [&heading](const char *name)
    { return heading.find("," + std::string(name) + ",") != std::string::npos; };
    return hasColumn("solution_plan") || (hasColumn("agents") && hasColumn("path")) ? FormatId::trackerCsv
                                                                                    : FormatId::unknown;
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
    if (hasLine(text, "schedule:"))
        return FormatId::libMrpSchedule;
    if (hasLine(text, "map:") || hasLine(text, "roadmap:") ||
        (hasLine(text, "environment:") && hasLine(text, "start:")))
        return FormatId::libMrpInstance;
    if (hasLine(text, "statistics:"))
        return FormatId::libMrpSchedule; // that says that it found nothing
    return beginsWithAnEdge(text) ? FormatId::edgeList : FormatId::unknown;
}

FormatId byExtension(const std::filesystem::path &file, std::string_view text)
{
    std::string extension = file.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    if (isOneOf(extension, {".yaml", ".yml"}) && text.find("schedule") != std::string_view::npos)
        return FormatId::libMrpSchedule;
    if (isOneOf(extension, {".txt", ".json"})) // of too many formats
        return FormatId::unknown;
    for (const Format &format : kFormats)
        if (!extension.empty() &&
            (" " + std::string(format.extensions) + " ").find(" " + extension + " ") != std::string::npos)
            return format.id;
    return FormatId::unknown;
}

/// Formats that say the same things in alike words: where one is broken, it may look like the other.
bool areAlike(FormatId a, FormatId b)
{
    const auto family = [](FormatId id)
    {
        switch (id)
        {
        case FormatId::cpf:
        case FormatId::graphRec:
        case FormatId::surynekSolution:
            return FormatId::cpf;
        case FormatId::vetandResult:
            return FormatId::vetandInstance;
        case FormatId::kei18Result:
            return FormatId::kei18Instance;
        case FormatId::libMrpSchedule:
            return FormatId::libMrpInstance;
        default:
            return id;
        }
    };
    return family(a) == family(b);
}

} // namespace

FormatId formatOf(std::string_view text)
{
    if (!foreignFormat(text).empty())
        return FormatId::unknown;
    text = trimmed(withoutByteOrderMark(text));
    const FormatId format = byFirstWord(text);
    return format != FormatId::unknown ? format : byAnyLine(text);
}

FormatId formatOf(const std::filesystem::path &file, std::string_view text)
{
    if (!foreignFormat(text).empty())
        return FormatId::unknown;
    const FormatId format = formatOf(text);
    return format != FormatId::unknown ? format : byExtension(file, text);
}

std::string_view nameOf(FormatId format)
{
    const Format *found = find(format);
    return found == nullptr ? std::string_view() : found->name;
}

std::string_view describe(FormatId format)
{
    const Format *found = find(format);
    return found == nullptr ? std::string_view("of no known format") : found->description;
}

std::string describe(FormatId format, std::string_view text)
{
    if (format == FormatId::unknown)
        return describeUnknown(text);
    const std::string table = format == FormatId::edgeList ? tableOfNumbers(text) : std::string();
    return table.empty() ? std::string(describe(format)) : table;
}

bool holdsGraph(FormatId format)
{
    return canBeRead(format, 'g');
}

bool holdsInstance(FormatId format)
{
    return canBeRead(format, 'i');
}

bool holdsSolution(FormatId format)
{
    return canBeRead(format, 's');
}

ParseError blamed(const ParseError &error, FormatId expected, std::string_view text, const std::string &file)
{
    const auto other = [&](std::string_view what)
    {
        return ParseError({file, 1, 1}, "this is " + std::string(what) + ", but expected " +
                                            std::string(describe(expected)));
    };
    if (const std::string foreign = foreignFormat(text); !foreign.empty())
        return other(foreign);
    if (const FormatId found = formatOf(text); found != FormatId::unknown)
        return found == expected || areAlike(found, expected) ? error : other(describe(found, text));
    const std::string what = describeUnknown(text);
    if (what == kPlainText || error.complaint().find("empty") != std::string::npos)
        return error; // perhaps it is what was expected, with a mistake in its first line
    return ParseError(error.where(), error.complaint() + " (this looks like " + what + ")");
}

std::vector<FileFormat> fileFormats()
{
    std::vector<FileFormat> formats;
    for (const Format &format : kFormats)
        formats.push_back({std::string(format.name), format.extensions, format.holds,
                           *format.canBeRead != '\0', format.isWritten, format.help});
    return formats;
}

} // namespace mrpp

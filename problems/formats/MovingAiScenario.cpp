#include "problems/formats/MovingAiScenario.h"

#include "framework/support/Config.h"
#include "framework/system/File.h"
#include "problems/formats/FormatId.h"
#include "problems/formats/OctileDistances.h"
#include "problems/formats/support/TextReader.h"

#include <array>
#include <fmt/format.h>

namespace mrpp
{

namespace
{

constexpr std::string_view kRecordHelp =
    "; a record is: bucket, map, width, height, start x, start y, goal x, goal y, length";

struct Field
{
    std::string_view text;
    std::size_t column = 0;
};

/// The bucket, the map (which may hold blanks) and the seven numbers behind it, found from the right.
using Fields = std::array<Field, 9>;

Fields splitRecord(const TextReader &reader, std::string_view line)
{
    constexpr std::string_view blanks = " \t";
    const std::size_t lineEnd = line.find_last_not_of(blanks) + 1;
    const auto refuse = [&](std::size_t column, const char *what)
    { reader.fail(column, std::string("the record has ") + what + std::string(kRecordHelp)); };

    Fields fields;
    std::size_t end = lineEnd;
    for (std::size_t i = fields.size() - 1; i >= 2; --i)
    {
        const std::string_view front = line.substr(0, end);
        const std::size_t separator = front.find_last_of(blanks);
        if (separator == std::string_view::npos)
            refuse(lineEnd + 1, "too few fields");
        fields[i] = {front.substr(separator + 1), separator + 2};
        end = front.substr(0, separator).find_last_not_of(blanks) + 1;
    }
    LineCursor cursor(line.substr(0, end));
    const std::size_t bucketColumn = cursor.column();
    fields[0] = {cursor.word(), bucketColumn};
    const std::size_t mapColumn = cursor.column();
    fields[1] = {cursor.until("\t"), mapColumn};
    if (fields[1].text.empty())
        refuse(lineEnd + 1, "too few fields");
    if (!cursor.atEnd())
        refuse(cursor.column(), "too many fields");
    return fields;
}

std::int64_t wholeNumber(const TextReader &reader, const Field &field, const char *what)
{
    const auto value = parseInteger(field.text);
    if (!value || *value < 0)
        reader.fail(field.column, inQuotes(field.text) + " is no " + what +
                                      "; expected a whole number from 0 on" + std::string(kRecordHelp));
    return *value;
}

Scenario::Cell cell(const TextReader &reader, const Scenario &scenario, const Field &x, const Field &y,
                    const std::string &role)
{
    const auto coordinate = [&](const Field &field, const char *axis, std::int64_t size, const char *side)
    {
        const std::int64_t value = wholeNumber(reader, field, (role + " " + axis).c_str());
        if (value >= size)
            reader.fail(field.column, "the " + role + "'s " + axis + " is " + std::to_string(value) +
                                          ", but the map's " + side + " is " + std::to_string(size) +
                                          " (they count from 0)");
        return value;
    };
    return {coordinate(x, "x", scenario.width, "width"), coordinate(y, "y", scenario.height, "height"),
            x.column};
}

void readRecord(const TextReader &reader, std::string_view line, Scenario &scenario)
{
    const Fields fields = splitRecord(reader, line);
    wholeNumber(reader, fields[0], "bucket");
    const std::int64_t width = wholeNumber(reader, fields[2], "width");
    const std::int64_t height = wholeNumber(reader, fields[3], "height");
    if (scenario.records.empty())
    {
        scenario.width = width;
        scenario.height = height;
        scenario.sizeColumn = fields[2].column;
    }
    else if (width != scenario.width || height != scenario.height)
    {
        reader.fail(fields[2].column,
                    fmt::format("this record's map is {} x {}, the first record's {} x {}; a "
                                "scenario has one map",
                                width, height, scenario.width, scenario.height));
    }
    else if (const std::string_view first = scenario.records.front().map;
             fileNameIn(first) != fileNameIn(fields[1].text))
    {
        reader.fail(fields[1].column, "this record stands on the map " +
                                          inQuotes(fileNameIn(fields[1].text)) + ", the first record on " +
                                          inQuotes(fileNameIn(first)) + "; a scenario has one map");
    }
    Scenario::Record record;
    record.map = fields[1].text;
    record.start = cell(reader, scenario, fields[4], fields[5], "start");
    record.goal = cell(reader, scenario, fields[6], fields[7], "goal");
    record.line = reader.line();
    if (const auto length = parseNumber(fields[8].text); !length || *length < 0)
        reader.fail(fields[8].column,
                    inQuotes(fields[8].text) + " is no length of a path" + std::string(kRecordHelp));
    scenario.records.push_back(std::move(record));
}

/// True for a line `version 1` or `version 1.0`.
bool isVersionLine(const TextReader &reader, std::string_view line)
{
    LineCursor cursor(line);
    if (cursor.word() != "version")
        return false;
    const std::size_t column = cursor.column();
    const std::string_view version = cursor.until("");
    if (version != "1" && version != "1.0")
        reader.fail(column, "version " + inQuotes(version) + " is not known; expected 'version 1'");
    return true;
}

} // namespace

std::string Scenario::mapName() const
{
    if (records.empty())
        return {};
    return std::string(fileNameIn(records.front().map));
}

Scenario readMovingAiScenario(const std::filesystem::path &file)
{
    return parseMovingAiScenario(readFile(file), file.string());
}

namespace
{

Scenario readScenario(std::string_view text, const std::string &file)
{
    TextReader reader(text, file);
    Scenario scenario;
    scenario.file = file;
    bool isFirst = true;
    while (const auto line = reader.next())
    {
        if (trimmed(*line).empty())
            continue;
        if (!isFirst || !isVersionLine(reader, *line))
            readRecord(reader, *line, scenario);
        isFirst = false;
    }
    if (isFirst)
        reader.fail(
            1, 1, "the file is empty; expected 'version 1' and one record a line" + std::string(kRecordHelp));
    return scenario;
}

} // namespace

Scenario parseMovingAiScenario(std::string_view text, const std::string &file)
{
    return readAs(FormatId::scenario, text, file, [&] { return readScenario(text, file); });
}

Instance scenarioInstance(const Scenario &scenario, const GridMap &map, std::size_t robots)
{
    const auto fail = [&scenario](std::size_t line, std::size_t column, const std::string &what) {
        throw ParseError({scenario.file, line, column}, what);
    };

    if (robots > scenario.records.size())
        throw InputError({scenario.file},
                         fmt::format("there are {} records, fewer than the {} robots asked for",
                                     scenario.records.size(), robots));
    if (!scenario.records.empty() && (static_cast<std::size_t>(scenario.width) != map.width ||
                                      static_cast<std::size_t>(scenario.height) != map.height))
        fail(
            scenario.records.front().line, scenario.sizeColumn,
            fmt::format("the records speak of a map of width {} and height {}, but this map has width {} and "
                        "height {}",
                        scenario.width, scenario.height, map.width, map.height));

    Instance instance{map.graph, {}, {}};
    const auto place = [&](const Scenario::Cell &at, std::size_t line, const char *role,
                           std::vector<Robot> &owner, std::vector<Vertex> &vertices)
    {
        const auto x = static_cast<std::size_t>(at.x);
        const auto y = static_cast<std::size_t>(at.y);
        const Vertex v = map.vertexAt(x, y);
        if (v == kNoVertex)
            fail(line, at.column,
                 fmt::format("the {} ({}, {}) is an obstacle ('{}')", role, x, y,
                             map.cells[y * map.width + x]));
        if (owner[v] != kNoRobot)
            fail(line, at.column,
                 fmt::format(
                     "the {0} ({1}, {2}) is the {0} of the record in line {3} too; robots need distinct "
                     "{0}s",
                     role, x, y, scenario.records[owner[v]].line));
        owner[v] = static_cast<Robot>(vertices.size());
        vertices.push_back(v);
    };
    std::vector<Robot> startOwner(map.graph->vertexCount(), kNoRobot);
    std::vector<Robot> goalOwner(map.graph->vertexCount(), kNoRobot);
    for (std::size_t r = 0; r < robots; ++r)
    {
        const Scenario::Record &record = scenario.records[r];
        place(record.start, record.line, "start", startOwner, instance.starts);
        place(record.goal, record.line, "goal", goalOwner, instance.goals);
    }
    return instance;
}

std::string formatMovingAiScenario(const GridMap &map, const Instance &instance, const std::string &mapName,
                                   const Supervision &supervision)
{
    const std::vector<double> lengths = octileDistances(map, instance, supervision);
    std::string text = "version 1\n";
    for (std::size_t r = 0; r < instance.robotCount(); ++r)
    {
        const auto [startX, startY] = map.cellOf(instance.starts[r]);
        const auto [goalX, goalY] = map.cellOf(instance.goals[r]);
        fmt::format_to(std::back_inserter(text), "{}\t{}\t{}\t{}\t{}\t{}\t{}\t{}\t{:.8f}\n",
                       static_cast<std::int64_t>(lengths[r] / 4), mapName, map.width, map.height, startX,
                       startY, goalX, goalY, lengths[r]);
    }
    return text;
}

} // namespace mrpp

#include "problems/formats/Tracker.h"

#include "framework/support/Config.h"
#include "problems/formats/Directions.h"
#include "problems/formats/TextReader.h"
#include "problems/formats/TextWriter.h"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace mrpp
{

namespace
{

/// One robot's letters, and where they stand.
struct Letters
{
    std::string_view text;
    std::size_t line = 0; ///< 0 for unknown
    std::size_t column = 0;
};

struct Plan
{
    std::string text; ///< of all robots; what the letters lie in
    std::vector<Letters> robots;
    std::optional<bool> flipped;
};

/// Rows and cells of quoted CSV, cell by cell.
class CsvReader
{
public:
    CsvReader(std::string_view text, std::string file)
        : rest_(withoutByteOrderMark(text)), file_(std::move(file))
    {}

    struct Cell
    {
        std::string text;
        SourceLocation where; ///< of its first character
        bool endsRow = false;
    };

    /// The next row; nothing at the end of the text. Blank lines are skipped.
    std::vector<Cell> row()
    {
        constexpr std::size_t mostCells = 1000;
        std::vector<Cell> cells;
        while (!rest_.empty() && (rest_.front() == '\n' || rest_.front() == '\r'))
            take();
        while (!rest_.empty() && (cells.empty() || !cells.back().endsRow))
        {
            if (cells.size() == mostCells)
                throw ParseError({file_, line_, column_},
                                 "the row has more than " + std::to_string(mostCells) + " cells");
            cells.push_back(cell());
        }
        return cells;
    }

private:
    char take()
    {
        const char c = rest_.front();
        rest_.remove_prefix(1);
        line_ += c == '\n' ? 1 : 0;
        column_ = c == '\n' ? 1 : column_ + 1;
        return c;
    }

    Cell cell()
    {
        Cell cell;
        const bool quoted = rest_.front() == '"';
        const SourceLocation quote{file_, line_, column_};
        if (quoted)
            take();
        cell.where = {file_, line_, column_};
        while (quoted)
        {
            if (rest_.empty())
                throw ParseError(quote, "this quotation mark is never closed");
            const char c = take();
            if (c == '"' && (rest_.empty() || rest_.front() != '"'))
                break;
            if (c == '"')
                take();
            cell.text += c;
        }
        while (!rest_.empty())
        {
            const SourceLocation where{file_, line_, column_};
            const char c = take();
            if (c == ',')
                return cell;
            if (c == '\n')
                break;
            if (quoted && c != '\r')
                throw ParseError(where, "expected a comma or the line's end behind the quotation mark");
            if (c != '\r')
                cell.text += c;
        }
        cell.endsRow = true;
        return cell;
    }

    std::string_view rest_;
    std::string file_;
    std::size_t line_ = 1;
    std::size_t column_ = 1;
};

std::optional<bool> truth(std::string text)
{
    std::transform(text.begin(), text.end(), text.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    if (text == "true" || text == "1")
        return true;
    return text == "false" || text == "0" ? std::optional(false) : std::nullopt;
}

/// One robot a line of the plan's text.
void splitLines(Plan &plan, const SourceLocation &where)
{
    std::string_view rest = plan.text;
    for (std::size_t index = 0;; ++index)
    {
        const std::size_t end = rest.find('\n');
        std::string_view line = rest.substr(0, end);
        if (!line.empty() && line.back() == '\r')
            line.remove_suffix(1);
        plan.robots.push_back(
            {line, where.line == 0 ? 0 : where.line + index, index == 0 ? where.column : 1});
        if (end == std::string_view::npos)
            return;
        rest.remove_prefix(end + 1);
    }
}

/// Which of a file's plans is meant: the only one, else the one for as many robots as the instance has.
class Choice
{
public:
    explicit Choice(std::size_t robots) : robots_(robots) {}

    /// Whether the next plan may be it. Throws ParseError where there are two.
    /// \param robots as the file says it; anything else than a number of robots is no reason
    bool take(std::string_view robots, const SourceLocation &where)
    {
        const auto number = parseInteger(robots);
        const bool fits = number && *number >= 0 && static_cast<std::uint64_t>(*number) == robots_;
        if (fits && fitting_)
            throw ParseError(where, "a second plan of " + std::to_string(robots_) +
                                        " robots; a file may hold one for each number of robots");
        const bool isFirst = plans_++ == 0;
        fitting_ = fitting_ || fits;
        return isFirst || fits;
    }

    /// Throws ParseError where none was meant.
    void check(const std::string &file) const
    {
        if (plans_ > 1 && !fitting_)
            throw ParseError({file}, "there are " + std::to_string(plans_) + " plans, but none of " +
                                         std::to_string(robots_) + " robots, the instance's number");
    }

private:
    std::size_t robots_;
    std::size_t plans_ = 0;
    bool fitting_ = false;
};

void readCsv(Plan &plan, std::string_view text, const std::string &file, Choice choice)
{
    CsvReader reader(text, file);
    const auto heading = reader.row();
    const auto columnOf = [&heading](std::string_view name)
    {
        return static_cast<std::size_t>(std::find_if(heading.begin(), heading.end(),
                                                     [name](const CsvReader::Cell &cell)
                                                     { return trimmed(cell.text) == name; }) -
                                        heading.begin());
    };
    std::size_t planColumn = columnOf("solution_plan");
    if (planColumn == heading.size())
        planColumn = columnOf("path");
    if (planColumn == heading.size())
        throw ParseError({file, 1, 1}, "the heading has no column 'solution_plan'");
    const std::size_t robotsColumn = columnOf("agents");
    const std::size_t flipColumn = columnOf("flip_up_down");
    std::vector<CsvReader::Cell> chosen;
    for (auto row = reader.row(); !row.empty(); row = reader.row())
    {
        if (row.size() != heading.size())
            throw ParseError(row.front().where, "the row has " + std::to_string(row.size()) +
                                                    " cells, but the heading has " +
                                                    std::to_string(heading.size()));
        if (choice.take(robotsColumn < row.size() ? row[robotsColumn].text : "", row.front().where))
            chosen = std::move(row);
    }
    choice.check(file);
    if (chosen.empty())
        throw ParseError({file}, "there is no plan behind the heading");
    if (flipColumn < chosen.size() && !chosen[flipColumn].text.empty())
    {
        plan.flipped = truth(chosen[flipColumn].text);
        if (!plan.flipped)
            throw ParseError(chosen[flipColumn].where,
                             inQuotes(chosen[flipColumn].text) + " is neither TRUE nor FALSE");
    }
    plan.text = chosen[planColumn].text;
    splitLines(plan, chosen[planColumn].where);
}

SourceLocation placeOf(std::string_view text, std::size_t offset, const std::string &file)
{
    const std::string_view before = text.substr(0, offset);
    const std::size_t lineStart = before.rfind('\n') + 1; // npos + 1 is 0
    return {file, static_cast<std::size_t>(std::count(before.begin(), before.end(), '\n')) + 1,
            before.size() - lineStart + 1};
}

/// A number of robots, as a number or a text.
std::string robotsOf(const nlohmann::json &object)
{
    const auto found = object.is_object() ? object.find("agents") : object.end();
    if (!object.is_object() || found == object.end())
        return {};
    return found->is_string() ? found->get<std::string>() : found->dump();
}

void readJson(Plan &plan, std::string_view text, const std::string &file, Choice choice)
{
    text = withoutByteOrderMark(text);
    nlohmann::json root;
    try
    {
        root = nlohmann::json::parse(text);
    }
    catch (const nlohmann::json::parse_error &error)
    {
        throw ParseError(placeOf(text, error.byte == 0 ? 0 : error.byte - 1, file),
                         "this is no JSON from here on");
    }
    catch (const nlohmann::json::exception &) // a number beyond all bounds
    {
        throw ParseError({file}, "this is no JSON: it holds a number that is too large");
    }
    if (root.is_array())
    {
        nlohmann::json chosen;
        for (nlohmann::json &object : root)
            if (choice.take(robotsOf(object), {file}))
                chosen = std::move(object);
        choice.check(file);
        root = std::move(chosen);
    }
    const auto refuse = [&file](const std::string &what) { throw ParseError({file}, what); };
    if (!root.is_object() || !root.contains("solution_plan"))
        refuse("expected one JSON object with the key 'solution_plan'");
    if (root.contains("flip_up_down"))
    {
        const auto &flip = root["flip_up_down"];
        plan.flipped = flip.is_boolean()  ? std::optional(flip.get<bool>())
                       : flip.is_string() ? truth(flip.get<std::string>())
                                          : std::nullopt;
        if (!plan.flipped)
            refuse("'flip_up_down' must be true or false");
    }
    const auto &robots = root["solution_plan"];
    if (robots.is_string())
    {
        plan.text = robots.get<std::string>();
        return splitLines(plan, {});
    }
    if (!robots.is_array())
        refuse("'solution_plan' must be a text or a list of texts");
    for (const auto &robot : robots)
    {
        if (!robot.is_string())
            refuse("'solution_plan' must be a list of texts");
        const std::string &letters = robot.get_ref<const std::string &>();
        if (letters.find('\n') != std::string::npos)
            refuse("a text of 'solution_plan' has two lines; expected one robot a text");
        plan.text += letters + "\n";
    }
    for (std::string_view rest = plan.text; !rest.empty();)
    {
        const std::size_t end = rest.find('\n');
        plan.robots.push_back({rest.substr(0, end), 0, 0});
        rest.remove_prefix(end + 1);
    }
}

/// Follows the letters from the starts on.
SolutionRows follow(const Plan &plan, const std::string &file, const Instance &instance, const Cells &cells,
                    bool flipped)
{
    constexpr std::size_t mostSteps = 10000000; // of all robots; "999999999w" is ten bytes
    std::size_t steps = 0;
    std::vector<std::vector<PathPoint>> paths;
    const std::size_t robots = std::min(plan.robots.size(), instance.robotCount());
    for (std::size_t robot = 0; robot < robots; ++robot)
    {
        const Letters &letters = plan.robots[robot];
        const auto refuse = [&](std::size_t offset, const std::string &what)
        {
            throw ParseError({file, letters.line, letters.line == 0 ? 0 : letters.column + offset},
                             "robot " + std::to_string(robot) + ": " + what);
        };
        Vertex at = instance.starts[robot];
        std::vector<PathPoint> &path = paths.emplace_back();
        const auto line = static_cast<std::uint32_t>(letters.line);
        path.push_back({at, line});
        LineCursor cursor(letters.text);
        while (!cursor.atEnd())
        {
            const std::size_t offset = cursor.column() - 1;
            const std::string_view digits = cursor.digits();
            const auto count = digits.empty() ? std::optional<std::int64_t>(1) : parseInteger(digits);
            if (!count || *count < 0 || static_cast<std::uint64_t>(*count) > mostSteps ||
                (steps += static_cast<std::size_t>(*count)) > mostSteps)
                refuse(offset, inQuotes(digits) + " steps are too many");
            int dx = 0;
            int dy = 0;
            if (cursor.take("u"))
                dy = flipped ? 1 : -1;
            else if (cursor.take("d"))
                dy = flipped ? -1 : 1;
            else if (cursor.take("l"))
                dx = -1;
            else if (cursor.take("r"))
                dx = 1;
            else if (!cursor.take("w"))
                refuse(cursor.column() - 1,
                       "expected one of u, d, l, r and w, perhaps with a number in front");
            for (std::int64_t i = 0; i < *count; ++i)
            {
                const auto [x, y] = cells.cellOf(at);
                const Vertex next = cells.vertexAt(std::int64_t{x} + dx, std::int64_t{y} + dy);
                if (next == kNoVertex)
                    refuse(offset, "it would go to the cell " +
                                       cellName(std::int64_t{x} + dx, std::int64_t{y} + dy) +
                                       ", where the graph has no vertex");
                at = next;
                path.push_back({at, line});
            }
        }
    }
    paths.resize(plan.robots.size()); // rowsOfPaths complains where the numbers of robots differ
    return rowsOfPaths(file, instance, paths);
}

/// "5r2d": letters with the number of their repetitions.
std::string shortened(const std::string &letters)
{
    std::string text;
    for (std::size_t i = 0; i < letters.size();)
    {
        const std::size_t end = std::min(letters.find_first_not_of(letters[i], i), letters.size());
        if (end - i > 1)
            text += std::to_string(end - i);
        text += letters[i];
        i = end;
    }
    return text;
}

} // namespace

std::optional<TrackerName> trackerName(std::string_view fileName)
{
    if (fileName.ends_with(".scen"))
        fileName.remove_suffix(5);
    const std::size_t second = fileName.rfind('-');
    if (second == std::string_view::npos || second == 0)
        return std::nullopt;
    const std::size_t first = fileName.rfind('-', second - 1);
    if (first == std::string_view::npos || first == 0)
        return std::nullopt;
    const std::string_view type = fileName.substr(first + 1, second - first - 1);
    const auto number = parseInteger(fileName.substr(second + 1));
    if ((type != "even" && type != "random") || !number || *number < 1 || *number > 999)
        return std::nullopt;
    return TrackerName{std::string(fileName.substr(0, first)), std::string(type), static_cast<int>(*number)};
}

SolutionRows parseTracker(std::string_view text, const std::string &file, TrackerForm form,
                          const Instance &instance)
{
    const Cells cells(*instance.graph);
    Plan plan;
    if (form == TrackerForm::csv)
        readCsv(plan, text, file, Choice(instance.robotCount()));
    else
        readJson(plan, text, file, Choice(instance.robotCount()));
    while (plan.robots.size() > instance.robotCount() && plan.robots.back().text.empty())
        plan.robots.pop_back(); // line ends behind the last robot
    if (plan.flipped)
        return follow(plan, file, instance, cells, *plan.flipped);

    const auto validIfFlipped = [&]() -> std::optional<SolutionRows>
    {
        try
        {
            SolutionRows rows = follow(plan, file, instance, cells, true);
            rows.warnings.push_back("the plan is valid only if u goes to the next row, as in old downloads; "
                                    "it was read so");
            return validate(instance, rows.moves, MotionRule::rotation).valid() ? std::optional(rows)
                                                                                : std::nullopt;
        }
        catch (const ParseError &)
        {
            return std::nullopt;
        }
    };
    try
    {
        SolutionRows rows = follow(plan, file, instance, cells, false);
        if (validate(instance, rows.moves, MotionRule::rotation).valid())
            return rows;
        auto flipped = validIfFlipped();
        return flipped ? *flipped : rows;
    }
    catch (const ParseError &)
    {
        if (auto flipped = validIfFlipped())
            return *flipped;
        throw;
    }
}

std::string formatTracker(const Instance &instance, const Schedule &schedule, TrackerForm form,
                          const TrackerName &name)
{
    const Cells cells(*instance.graph);
    std::vector<std::string> robots;
    for (const std::string &letters : directionsOf(instance, schedule, cells))
        robots.push_back(shortened(letters));
    if (form == TrackerForm::json)
    {
        const nlohmann::ordered_json root = {{"map_name", name.map},    {"scen_type", name.type},
                                             {"type_id", name.number},  {"agents", robots.size()},
                                             {"solution_plan", robots}, {"flip_up_down", false}};
        return root.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
    }
    std::string map;
    for (const char c : name.map)
        map += c == '"' ? "\"\"" : std::string(1, c);
    TextWriter out;
    out.line("map_name,scen_type,type_id,agents,solution_plan,flip_up_down");
    if (map.find_first_of("\",\n\r") != std::string::npos)
        map = '"' + map + '"';
    out.add(map, ',', name.type, ',', static_cast<std::uint64_t>(name.number), ',',
            std::uint64_t{robots.size()}, ",\"");
    for (std::size_t robot = 0; robot < robots.size(); ++robot)
        out.add(robot == 0 ? "" : "\n", robots[robot]);
    out.line("\",FALSE");
    return out.take();
}

} // namespace mrpp

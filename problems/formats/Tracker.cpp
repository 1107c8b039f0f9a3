#include "problems/formats/Tracker.h"

#include "framework/support/Config.h"
#include "problems/formats/FormatId.h"
#include "problems/formats/support/CsvReader.h"
#include "problems/formats/support/Directions.h"
#include "problems/formats/support/TextReader.h"
#include "problems/formats/support/TextWriter.h"

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

/// A plan as the file says it. What is not said is empty.
struct Plan
{
    std::string text; ///< of all robots, one a line
    SourceLocation textWhere;
    bool hasRobots = true; ///< a list may be empty, a text may not
    std::optional<bool> flipped;
    std::string map;
    std::string type;
    std::string number;
    std::string robotCount;
    SourceLocation where;

    /// "the plan for empty-8-8, even, 1".
    [[nodiscard]] std::string name() const
    {
        std::string all;
        for (const std::string *part : {&map, &type, &number})
            if (!part->empty())
                all += (all.empty() ? "" : ", ") + *part;
        return all.empty() ? "a plan" : "the plan for " + inQuotes(all);
    }
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
std::vector<Letters> lettersOf(const Plan &plan)
{
    std::vector<Letters> robots;
    if (!plan.hasRobots)
        return robots;
    const SourceLocation &where = plan.textWhere;
    std::string_view rest = plan.text;
    for (std::size_t index = 0;; ++index)
    {
        const std::size_t end = rest.find('\n');
        std::string_view line = rest.substr(0, end);
        if (!line.empty() && line.back() == '\r')
            line.remove_suffix(1);
        robots.push_back({line, where.line == 0 ? 0 : where.line + index, index == 0 ? where.column : 1});
        if (end == std::string_view::npos)
            return robots;
        rest.remove_prefix(end + 1);
    }
}

bool isNumber(const std::string &text, std::size_t number)
{
    const auto value = parseInteger(text);
    return value && *value >= 0 && static_cast<std::uint64_t>(*value) == number;
}

/// The plans that may be the instance's: of its map and scenario, and of its number of robots where there is
/// one such. All others are dropped as they come.
class Candidates
{
public:
    Candidates(std::string file, const TrackerContext &context, std::size_t robots)
        : file_(std::move(file)), context_(context), robots_(robots)
    {}

    [[nodiscard]] const std::string &file() const { return file_; }

    void add(Plan plan)
    {
        if (++count_ == 1)
        {
            firstName_ = plan.name();
            firstWhere_ = plan.where;
        }
        if (!context_.map.empty() && !plan.map.empty() && plan.map != context_.map)
            return;
        ++onMap_;
        const bool isOtherType = !context_.type.empty() && !plan.type.empty() && plan.type != context_.type;
        const bool isOtherNumber = context_.number > 0 && !plan.number.empty() &&
                                   !isNumber(plan.number, static_cast<std::size_t>(context_.number));
        if (isOtherType || isOtherNumber)
            return;
        ++inScenario_;
        if (isNumber(plan.robotCount, robots_))
            fitting_.push_back(std::move(plan));
        else if (count_ == 1)
            only_ = std::move(plan);
    }

    /// Throws ParseError where there is none, or there are too many to try.
    std::vector<Plan> take()
    {
        if (count_ == 0)
            throw ParseError({file_}, "there is no plan behind the heading, or in the list");
        if (onMap_ == 0)
            throw ParseError(firstWhere_, "this is " + firstName_ + ", but the instance stands on the map " +
                                              inQuotes(context_.map));
        if (inScenario_ == 0)
            throw ParseError(firstWhere_,
                             "this is " + firstName_ + ", but the instance is the scenario " +
                                 inQuotes(context_.type + " " + std::to_string(context_.number)));
        if (count_ == 1 && only_)
            fitting_.push_back(std::move(*only_));
        if (fitting_.empty())
            throw ParseError({file_}, "there are " + std::to_string(count_) + " plans, but none of " +
                                          counted(robots_, "robot", "robots") + ", the instance's number");
        constexpr std::size_t most = 50;
        if (fitting_.size() > most)
            throw ParseError(fitting_[most].where,
                             "more than " + std::to_string(most) + " plans of " +
                                 counted(robots_, "robot", "robots") +
                                 " may be meant; give the instance the name of its scenario, as in "
                                 "empty-8-8-even-1.scen");
        return std::move(fitting_);
    }

private:
    std::string file_;
    const TrackerContext &context_;
    std::size_t robots_;
    std::size_t count_ = 0;
    std::size_t onMap_ = 0;
    std::size_t inScenario_ = 0;
    std::string firstName_;
    SourceLocation firstWhere_;
    std::optional<Plan> only_;
    std::vector<Plan> fitting_;
};

void readCsv(std::string_view text, Candidates &plans)
{
    const std::string &file = plans.file();
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
    if (planColumn == heading.size() && columnOf("agents") < heading.size())
        planColumn = columnOf("path"); // old downloads
    if (planColumn == heading.size())
        throw ParseError({file, 1, 1}, "the heading has no column 'solution_plan'");
    const std::size_t flipColumn = columnOf("flip_up_down");
    const std::size_t mapColumn = columnOf("map_name");
    const std::size_t typeColumn = columnOf("scen_type");
    const std::size_t numberColumn = columnOf("type_id");
    const std::size_t robotsColumn = columnOf("agents");
    for (auto row = reader.row(); !row.empty(); row = reader.row())
    {
        if (row.size() != heading.size())
            throw ParseError(row.front().where, "the row has " + std::to_string(row.size()) +
                                                    " cells, but the heading has " +
                                                    std::to_string(heading.size()));
        const auto cell = [&row](std::size_t column)
        { return column < row.size() ? std::string(trimmed(row[column].text)) : std::string(); };
        Plan plan;
        plan.map = cell(mapColumn);
        plan.type = cell(typeColumn);
        plan.number = cell(numberColumn);
        plan.robotCount = cell(robotsColumn);
        plan.where = row.front().where;
        if (flipColumn < row.size() && !row[flipColumn].text.empty())
        {
            plan.flipped = truth(row[flipColumn].text);
            if (!plan.flipped)
                throw ParseError(row[flipColumn].where,
                                 inQuotes(row[flipColumn].text) + " is neither TRUE nor FALSE");
        }
        plan.text = std::move(row[planColumn].text);
        plan.textWhere = row[planColumn].where;
        plans.add(std::move(plan));
    }
}

SourceLocation placeOf(std::string_view text, std::size_t offset, const std::string &file)
{
    const std::string_view before = text.substr(0, offset);
    const std::size_t lineStart = before.rfind('\n') + 1; // npos + 1 is 0
    return {file, static_cast<std::size_t>(std::count(before.begin(), before.end(), '\n')) + 1,
            before.size() - lineStart + 1};
}

/// A number or a text; empty where there is neither.
std::string textOf(const nlohmann::json &object, const char *key)
{
    const auto found = object.find(key);
    if (found == object.end() || found->is_null())
        return {};
    return found->is_string() ? found->get<std::string>() : found->dump();
}

Plan planOf(const nlohmann::json &object, const std::string &file)
{
    const auto refuse = [&file](const std::string &what) { throw ParseError({file}, what); };
    if (!object.is_object() || !object.contains("solution_plan"))
        refuse("this JSON is no plan; expected one object with the key 'solution_plan', or a list of such");
    Plan plan;
    plan.map = textOf(object, "map_name");
    plan.type = textOf(object, "scen_type");
    plan.number = textOf(object, "type_id");
    plan.robotCount = textOf(object, "agents");
    plan.where = {file};
    if (object.contains("flip_up_down"))
    {
        const auto &flip = object["flip_up_down"];
        plan.flipped = flip.is_boolean()  ? std::optional(flip.get<bool>())
                       : flip.is_string() ? truth(flip.get<std::string>())
                                          : std::nullopt;
        if (!plan.flipped)
            refuse("'flip_up_down' must be true or false");
    }
    const auto &robots = object["solution_plan"];
    if (robots.is_string())
    {
        plan.text = robots.get<std::string>();
        return plan;
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
        plan.text += (&robot == &robots.front() ? "" : "\n") + letters;
    }
    plan.hasRobots = !robots.empty();
    return plan;
}

void readJson(std::string_view text, Candidates &plans)
{
    const std::string &file = plans.file();
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
    if (!root.is_array())
        return plans.add(planOf(root, file));
    for (const nlohmann::json &object : root)
        plans.add(planOf(object, file));
}

/// Steps of all robots that are followed at most: "999999999w" is ten bytes.
constexpr std::size_t kMostSteps = 20000000;

/// Follows the letters from the starts on. \param left of kMostSteps
SolutionRows follow(const std::vector<Letters> &plan, const std::string &file, const Instance &instance,
                    const Cells &cells, bool flipped, std::size_t &left)
{
    std::vector<std::vector<PathPoint>> paths;
    const std::size_t robots = std::min(plan.size(), instance.robotCount());
    for (std::size_t robot = 0; robot < robots; ++robot)
    {
        const Letters &letters = plan[robot];
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
            if (!count || *count < 0 || static_cast<std::uint64_t>(*count) > left)
                refuse(offset, inQuotes(digits) + " steps are too many");
            left -= static_cast<std::size_t>(*count);
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
    paths.resize(plan.size()); // rowsOfPaths complains where the numbers of robots differ
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

namespace
{

/// The plan's rows, and whether they solve the instance. Where the file does not say what u and d mean, they
/// are turned round if the plan is valid in no other way.
std::pair<SolutionRows, bool> rowsOf(const Plan &plan, const std::string &file, const Instance &instance,
                                     const Cells &cells, std::size_t &left)
{
    std::vector<Letters> letters = lettersOf(plan);
    while (letters.size() > instance.robotCount() && letters.back().text.empty())
        letters.pop_back(); // line ends behind the last robot
    const auto solves = [&](const SolutionRows &rows)
    { return validate(instance, rows.moves, MotionRule::rotation).valid(); };
    if (plan.flipped)
    {
        SolutionRows rows = follow(letters, file, instance, cells, *plan.flipped, left);
        const bool solved = solves(rows);
        return {std::move(rows), solved};
    }
    const auto validIfFlipped = [&]() -> std::optional<SolutionRows>
    {
        try
        {
            SolutionRows rows = follow(letters, file, instance, cells, true, left);
            rows.warnings.push_back("the plan is valid only if u goes to the next row, as in old downloads; "
                                    "it was read so");
            return solves(rows) ? std::optional(std::move(rows)) : std::nullopt;
        }
        catch (const ParseError &)
        {
            return std::nullopt;
        }
    };
    try
    {
        SolutionRows rows = follow(letters, file, instance, cells, false, left);
        if (solves(rows))
            return {std::move(rows), true};
        auto flipped = validIfFlipped();
        return flipped ? std::pair(std::move(*flipped), true) : std::pair(std::move(rows), false);
    }
    catch (const ParseError &)
    {
        if (auto flipped = validIfFlipped())
            return {std::move(*flipped), true};
        throw;
    }
}

/// The only one of several plans that solves the instance.
SolutionRows onlySolving(const std::vector<Plan> &plans, const std::string &file, const Instance &instance,
                         const Cells &cells)
{
    std::size_t left = 2 * kMostSteps;
    const auto solution = [&](const Plan &plan) -> std::optional<SolutionRows>
    {
        try
        {
            auto [rows, solved] = rowsOf(plan, file, instance, cells, left);
            return solved ? std::optional(std::move(rows)) : std::nullopt;
        }
        catch (const ParseError &)
        {
            return std::nullopt;
        }
    };
    const std::string second =
        "a second plan of " + counted(instance.robotCount(), "robot", "robots") + " that may be meant";
    std::optional<SolutionRows> found;
    const Plan *solving = nullptr;
    for (const Plan &plan : plans)
    {
        auto rows = solution(plan);
        if (rows && found)
            throw ParseError(plan.where, second + ": " + solving->name() + " and " + plan.name() +
                                             " solve the instance; give it the name of its scenario, as in "
                                             "empty-8-8-even-1.scen");
        if (!rows)
            continue;
        found = std::move(rows);
        solving = &plan;
    }
    if (!found)
        throw ParseError(plans[1].where, second + ", and none of them solves the instance");
    found->warnings.push_back("there are " + std::to_string(plans.size()) +
                              " plans that may be meant; read was " + solving->name() +
                              ", the only one that solves the instance");
    return std::move(*found);
}

} // namespace

SolutionRows parseTracker(std::string_view text, const std::string &file, TrackerForm form,
                          const Instance &instance, const TrackerContext &context)
{
    const FormatId id = form == TrackerForm::csv ? FormatId::trackerCsv : FormatId::trackerJson;
    return readAs(id, text, file,
                  [&]
                  {
                      Candidates candidates(file, context, instance.robotCount());
                      if (form == TrackerForm::csv)
                          readCsv(text, candidates);
                      else
                          readJson(text, candidates);
                      const std::vector<Plan> plans = candidates.take();
                      const Cells cells(*instance.graph);
                      std::size_t left = kMostSteps;
                      return plans.size() == 1 ? rowsOf(plans.front(), file, instance, cells, left).first
                                               : onlySolving(plans, file, instance, cells);
                  });
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

#include "reports/summary/SummaryTables.h"

#include "framework/statistics/Profiles.h"
#include "framework/statistics/Proportion.h"
#include "framework/support/Config.h"
#include "framework/support/ReadableText.h"
#include "reports/picture/Numbers.h"
#include "reports/picture/Text.h"
#include "reports/summary/Titles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <map>
#include <tuple>
#include <unordered_map>
#include <utility>

namespace mrpp
{

namespace
{

using Emphasis = PdfTableCell::Emphasis;

/// A measure's column of a summary table.
struct Measure
{
    const char *title;
    std::optional<Quartiles> (*summarize)(const RunGroup &);
    std::string (*format)(double);
};

std::string wholeNumber(double value)
{
    return value == std::floor(value) ? fmt::format("{:.0f}", value) : fmt::format("{:.1f}", value);
}
std::string twoDecimals(double value)
{
    return fmt::format("{:.2f}", value);
}

constexpr std::size_t kTime = 5; ///< its place among the measures: shown in a unit of its own
constexpr std::array<Measure, 6> kMeasures = {{
    {"Path length", [](const RunGroup &g) { return g.cost("path_length"); }, wholeNumber},
    {"Path length, optimized", [](const RunGroup &g) { return g.cost("optimized_path_length"); },
     wholeNumber},
    {"Path length / bound",
     [](const RunGroup &g) { return g.ratio("path_length", "path_length_lower_bound"); }, twoDecimals},
    {"Makespan", [](const RunGroup &g) { return g.cost("makespan"); }, wholeNumber},
    {"Makespan, optimized", [](const RunGroup &g) { return g.cost("optimized_makespan"); }, wholeNumber},
    {"Time", [](const RunGroup &g) { return g.cost("time"); }, threeDigits},
}};

/// "7/8", or "7/8, 2 proved, 1 not applicable" where some instances have no solution, or are not for the
/// planner.
std::string solvedOf(const RunGroup &group)
{
    std::string text = fmt::format("{}/{}", group.solved(), group.counted());
    const std::size_t proved = group.count(Outcome::proved);
    const std::size_t others = group.count(Outcome::doesNotApply);
    if (proved > 0)
        text += fmt::format(", {} proved", proved);
    if (others > 0)
        text += fmt::format(", {} not applicable", others);
    return text;
}

/// The groups of one sweep point or problem, which stand in rows below each other.
struct Place
{
    std::string name; ///< first cell of each row
    std::span<const RunGroup> groups;
};

/// A table before its numbers are written: their unit depends on all of them.
struct Draft
{
    std::string title;
    std::string placeTitle;
    std::vector<Place> places;
};

void addRows(SummaryTable &table, const Place &place, const TimeUnit &unit)
{
    const std::span<const RunGroup> groups = place.groups;
    std::size_t mostSolved = 0;
    for (const RunGroup &group : groups)
        mostSolved = std::max(mostSolved, group.solved());
    std::vector<std::array<std::optional<Quartiles>, kMeasures.size()>> values;
    std::array<double, kMeasures.size()> best{};
    best.fill(std::numeric_limits<double>::infinity());
    for (const RunGroup &group : groups)
    {
        values.emplace_back();
        for (std::size_t m = 0; m < kMeasures.size(); ++m)
        {
            values.back()[m] = kMeasures[m].summarize(group);
            if (values.back()[m] && group.solved() == mostSolved)
                best[m] = std::min(best[m], values.back()[m]->median);
        }
    }
    for (std::size_t i = 0; i < groups.size(); ++i)
    {
        const bool failed = groups[i].solved() == 0 && groups[i].counted() > 0;
        std::vector<PdfTableCell> row = {{place.name},
                                         {withRule(groups[i].planner, groups[i].rule)},
                                         {solvedOf(groups[i]), failed ? Emphasis::warning : Emphasis::none}};
        for (std::size_t m = 0; m < kMeasures.size(); ++m)
        {
            if (!values[i][m])
            {
                row.push_back({"–"});
                continue;
            }
            const double median = values[i][m]->median;
            const bool isLeast = m == kTime ? kAlikeTimes(best[m], median) : median == best[m];
            const bool isBest = groups.size() > 1 && groups[i].solved() == mostSolved && isLeast;
            const double shown = m == kTime ? median / unit.seconds : median;
            row.push_back({kMeasures[m].format(shown), isBest ? Emphasis::best : Emphasis::none});
        }
        table.rows.push_back(std::move(row));
    }
}

SummaryTable makeTable(const Draft &draft)
{
    std::vector<double> times;
    for (const Place &place : draft.places)
        for (const RunGroup &group : place.groups)
            if (const auto time = kMeasures[kTime].summarize(group))
                times.push_back(time->median);
    const TimeUnit unit = timeUnit(times);
    SummaryTable table;
    table.title = draft.title;
    table.columns = {{draft.placeTitle}, {"Planner"}, {"Solved", true}};
    for (const Measure &measure : kMeasures)
        table.columns.push_back({measure.title, true});
    table.columns.back().title += fmt::format(" ({})", unit.name);
    for (const Place &place : draft.places)
        addRows(table, place, unit);
    return table;
}

} // namespace

std::vector<SummaryTable> summaryTables(std::span<const RunRecord> records)
{
    const std::vector<ProblemSummary> problems = summarizeProblems(records);
    std::vector<Draft> drafts;
    std::map<std::string, std::size_t> unswept; // by family
    for (const ProblemSummary &problem : problems)
    {
        const std::span<const RunGroup> groups(problem.groups);
        if (!problem.swept())
        {
            const auto [position, isNew] = unswept.try_emplace(problem.model, drafts.size());
            if (isNew)
                drafts.push_back({spaced(problem.model), "Problem", {}});
            drafts[position->second].places.push_back({problem.problem, groups});
            continue;
        }
        drafts.push_back({fmt::format("{} ({}) against {}", problem.problem, spaced(problem.model),
                                      spaced(problem.sweepVariable)),
                          variableTitle(problem.sweepVariable),
                          {}});
        for (std::size_t first = 0, last = 0; first < groups.size(); first = last)
        {
            while (last < groups.size() && groups[last].sweepValue == groups[first].sweepValue)
                ++last;
            drafts.back().places.push_back(
                {formatNumber(groups[first].sweepValue.value_or(0)), groups.subspan(first, last - first)});
        }
    }
    std::vector<SummaryTable> tables;
    for (const Draft &draft : drafts)
        tables.push_back(makeTable(draft));
    return tables;
}

SummaryTable plannerTable(std::span<const RunRecord> records, double timeLimit)
{
    struct Planner
    {
        std::string name;
        std::string rule;
        std::size_t runs = 0;
        std::vector<Answer> answers;
        std::unordered_map<std::size_t, std::size_t> byInstance = {};
    };
    std::vector<Planner> planners;
    std::map<std::string, std::size_t> positions;
    InstanceNumbers instances(records);
    for (const RunRecord &record : records)
    {
        const auto [position, isNew] = positions.try_emplace(record.planner, planners.size());
        if (isNew)
            planners.push_back({record.planner, record.rule, 0, {}});
        Planner &planner = planners[position->second];
        ++planner.runs;
        const auto [answer, isFirst] =
            planner.byInstance.try_emplace(instances.of(record), planner.answers.size());
        if (isFirst)
            planner.answers.emplace_back();
        planner.answers[answer->second].add(record);
    }
    SummaryTable table;
    table.title = "Planners";
    table.columns = {{"Planner"},         {"Runs", true},       {"Instances", true},
                     {"Solved", true},    {"Proved", true},     {"Not applicable", true},
                     {"Failed", true},    {"Solved (%)", true}, {"95 % interval", true},
                     {"PAR-2 (s)", true}, {"PAR-10 (s)", true}, {"Failures"}};
    for (const Planner &planner : planners)
    {
        std::map<Outcome, std::size_t> outcomes;
        std::map<PlannerStatus, std::size_t> failures;
        std::vector<std::optional<double>> times;
        std::size_t hopeless = 0; // failures on instances without a solution
        for (const Answer &answer : planner.answers)
        {
            ++outcomes[answer.outcome()];
            if (answer.counts())
                times.push_back(answer.cost("time"));
            if (answer.outcome() != Outcome::failed)
                continue;
            ++failures[answer.status()];
            hopeless += answer.unsolvable() ? 1 : 0;
        }
        std::string others;
        for (const auto &[status, count] : failures)
            others += fmt::format("{}{} {}", others.empty() ? "" : ", ", count, spaced(toString(status)));
        if (hopeless > 0)
            others += fmt::format("; {} of them without a solution", hopeless);
        const std::size_t solved = outcomes[Outcome::solved];
        const Interval interval = wilsonInterval(solved, times.size());
        const auto average = [&](double factor)
        {
            const auto time = penalizedAverage(times, timeLimit, factor);
            return time ? threeDigits(*time) : std::string("–");
        };
        const std::string percent = times.empty()
                                        ? "–"
                                        : fmt::format("{:.1f}", 100 * static_cast<double>(solved) /
                                                                    static_cast<double>(times.size()));
        table.rows.push_back(
            {{withRule(planner.name, planner.rule)},
             {std::to_string(planner.runs)},
             {std::to_string(planner.answers.size())},
             {std::to_string(solved)},
             {std::to_string(outcomes[Outcome::proved])},
             {std::to_string(outcomes[Outcome::doesNotApply])},
             {std::to_string(outcomes[Outcome::failed])},
             {percent},
             {times.empty() ? "–" : fmt::format("{:.1f}–{:.1f}", 100 * interval.low, 100 * interval.high)},
             {average(2)},
             {average(10)},
             {others, failures.contains(PlannerStatus::invalid) ? Emphasis::warning : Emphasis::none}});
    }
    return table;
}

namespace
{

/// A message with "#" for every number: what differs in numbers alone is one kind of failure.
std::string withoutNumbers(const std::string &message)
{
    std::string kind;
    for (const char c : message)
    {
        const bool isDigit = c >= '0' && c <= '9';
        if (!isDigit)
            kind += c;
        else if (kind.empty() || kind.back() != '#')
            kind += '#';
    }
    return kind;
}

/// The last three lines that say something, in one, as far as a table has room.
std::string lastLines(const std::string &text)
{
    constexpr std::size_t kLines = 3;
    constexpr std::size_t kMost = 240; // bytes
    std::string last;
    std::size_t end = text.size();
    for (std::size_t lines = 0; lines < kLines && end != std::string::npos && end > 0;)
    {
        const std::size_t begin = text.rfind('\n', end - 1);
        const std::size_t first = begin == std::string::npos ? 0 : begin + 1;
        const std::string line = oneLine(text.substr(first, end - first));
        if (line.find_first_not_of(' ') != std::string::npos)
        {
            last.insert(0, last.empty() ? line : std::string(line).append(" / "));
            ++lines;
        }
        end = begin;
    }
    return last.size() <= kMost ? last : "…" + std::string(tail(last, kMost));
}

/// Why it ended so, and what its program said last.
std::string reasonAndWords(const RunRecord &record)
{
    std::string text = record.reason;
    for (const auto &[column, stream] :
         {std::pair("error_output", "standard error"), std::pair("standard_output", "standard output")})
        if (const auto found = record.extra.find(column); found != record.extra.end())
            if (const std::string words = lastLines(toText(found->second)); !words.empty())
                text += (text.empty() ? "" : "; ") + fmt::format("{}: {}", stream, words);
    return text;
}

} // namespace

SummaryTable failureTable(std::span<const RunRecord> records, std::size_t limit)
{
    struct Failure
    {
        const RunRecord *first = nullptr;
        std::size_t count = 0;
    };
    std::map<std::tuple<std::string, PlannerStatus, std::string>, std::size_t> positions;
    std::vector<Failure> failures;
    for (const RunRecord &record : records)
    {
        if (record.solved())
            continue;
        const auto [position, isNew] = positions.try_emplace(
            {record.planner, record.status, withoutNumbers(record.reason)}, failures.size());
        if (isNew)
            failures.push_back({&record, 0});
        ++failures[position->second].count;
    }
    std::stable_sort(failures.begin(), failures.end(),
                     [](const Failure &a, const Failure &b) {
                         return std::tie(a.first->planner, a.first->status) <
                                std::tie(b.first->planner, b.first->status);
                     });

    SummaryTable table;
    table.title = "Runs without a solution";
    table.columns = {{"Planner"}, {"Status"}, {"Runs", true}, {"Reason"}, {"First case"}, {"Its key"}};
    for (const Failure &failure : failures)
    {
        if (table.rows.size() == limit)
        {
            table.rows.push_back({{"…"},
                                  {""},
                                  {""},
                                  {counted(failures.size() - limit, "kind") + " more, see results.csv"},
                                  {""},
                                  {""}});
            break;
        }
        const bool isInvalid = failure.first->status == PlannerStatus::invalid;
        table.rows.push_back(
            {{failure.first->planner},
             {spaced(toString(failure.first->status)), isInvalid ? Emphasis::warning : Emphasis::none},
             {std::to_string(failure.count)},
             {reasonAndWords(*failure.first)},
             {failure.first->caseId},
             {failure.first->runKey}});
    }
    return table;
}

} // namespace mrpp

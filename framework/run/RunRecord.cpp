#include "framework/run/RunRecord.h"

#include "framework/support/Config.h"

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace mrpp
{

namespace
{

using Type = RunColumn::Type;

Value toValue(const std::string &text)
{
    return text;
}
Value toValue(std::int64_t number)
{
    return number;
}
Value toValue(Seed seed)
{
    return static_cast<std::int64_t>(seed); // 63 bits, see deriveSeed()
}
Value toValue(PlannerStatus status)
{
    return std::string(toString(status));
}
template <class T>
Value toValue(const std::optional<T> &cell)
{
    return cell ? Value(*cell) : Value();
}

void fromValue(Value &&value, std::string &slot)
{
    if (auto *text = std::get_if<std::string>(&value))
        slot = std::move(*text);
}
void fromValue(Value &&value, std::int64_t &slot)
{
    if (const auto *number = std::get_if<std::int64_t>(&value))
        slot = *number;
}
void fromValue(Value &&value, Seed &slot)
{
    if (const auto *number = std::get_if<std::int64_t>(&value))
        slot = static_cast<Seed>(*number);
}
void fromValue(Value &&value, PlannerStatus &slot)
{
    if (const auto *text = std::get_if<std::string>(&value))
        slot = plannerStatus(*text).value_or(PlannerStatus::unknown);
}
void fromValue(Value &&value, std::optional<std::int64_t> &slot)
{
    if (const auto *number = std::get_if<std::int64_t>(&value))
        slot = *number;
    else if (std::holds_alternative<std::monostate>(value))
        slot.reset();
}
void fromValue(Value &&value, std::optional<double> &slot)
{
    if (const auto *number = std::get_if<double>(&value))
        slot = *number;
    else if (const auto *whole = std::get_if<std::int64_t>(&value))
        slot = static_cast<double>(*whole);
    else if (std::holds_alternative<std::monostate>(value))
        slot.reset();
}

template <class T>
constexpr Type typeOf()
{
    if constexpr (std::is_same_v<T, std::int64_t> || std::is_same_v<T, Seed> ||
                  std::is_same_v<T, std::optional<std::int64_t>>)
        return Type::integer;
    else if constexpr (std::is_same_v<T, std::optional<double>>)
        return Type::real;
    else
        return Type::text;
}

template <class T>
RunColumn column(std::string_view name, T RunRecord::*member, bool inSolveJson)
{
    return {name, typeOf<T>(), inSolveJson,
            [member](const RunRecord &record) { return toValue(record.*member); },
            [member](RunRecord &record, Value value) { fromValue(std::move(value), record.*member); }};
}

std::vector<RunColumn> makeColumns()
{
    using R = RunRecord;
    constexpr bool solve = true; // `solve --json` has it
    constexpr bool campaign = false;
    return {
        column("run_key", &R::runKey, campaign),
        column("case", &R::caseId, campaign),
        column("model", &R::model, campaign),
        column("problem", &R::problem, campaign),
        column("sweep_variable", &R::sweepVariable, campaign),
        column("sweep_value", &R::sweepValue, campaign),
        column("repetition", &R::repetition, campaign),
        column("planner", &R::planner, solve),
        column("status", &R::status, solve),
        column("reason", &R::reason, solve),
        column("completed", &R::completed, solve),
        column("vertices", &R::vertices, solve),
        column("edges", &R::edges, solve),
        column("robots", &R::robots, solve),
        column("free", &R::free, campaign),
        column("occupancy", &R::occupancy, campaign),
        column("time", &R::time, solve),
        column("setup_time", &R::setupTime, solve),
        column("optimization_time", &R::optimizationTime, solve),
        column("memory", &R::memory, solve),
        column("path_length", &R::pathLength, solve),
        column("actions", &R::actions, solve),
        column("makespan", &R::makespan, solve),
        column("sum_of_costs", &R::sumOfCosts, solve),
        column("optimized_path_length", &R::optimizedPathLength, solve),
        column("optimized_actions", &R::optimizedActions, solve),
        column("optimized_makespan", &R::optimizedMakespan, solve),
        column("optimized_sum_of_costs", &R::optimizedSumOfCosts, solve),
        column("path_length_lower_bound", &R::pathLengthLowerBound, solve),
        column("makespan_lower_bound", &R::makespanLowerBound, solve),
        column("motion", &R::motion, campaign),
        column("graph_seed", &R::graphSeed, campaign),
        column("instance_seed", &R::instanceSeed, campaign),
        column("planner_seed", &R::plannerSeed, campaign),
        column("attempt", &R::attempt, campaign),
        column("instance_fingerprint", &R::instanceFingerprint, campaign),
        column("solution_fingerprint", &R::solutionFingerprint, campaign),
        column("solvable", &R::solvable, solve),
        column("unsolvable_reason", &R::unsolvableReason, solve),
        column("plan_key", &R::planKey, campaign),
        column("termination_reason", &R::terminationReason, campaign),
        column("cpu_time", &R::cpuTime, solve),
        column("timed", &R::timed, solve),
        column("time_min", &R::timeMin, solve),
        column("time_max", &R::timeMax, solve),
        column("time_iqr", &R::timeIqr, solve),
        column("repeatable", &R::repeatable, campaign),
        column("load", &R::load, campaign),
        column("cores", &R::cores, campaign),
        column("limit_means", &R::limitMeans, campaign),
        column("rule", &R::rule, solve),
        column("path_length_bound_name", &R::pathLengthBoundName, solve),
        column("makespan_bound_name", &R::makespanBoundName, solve),
        column("sum_of_costs_lower_bound", &R::sumOfCostsLowerBound, solve),
        column("sum_of_costs_bound_name", &R::sumOfCostsBoundName, solve),
        column("bound_time", &R::boundTime, solve),
    };
}

} // namespace

const std::vector<RunColumn> &runColumns()
{
    static const std::vector<RunColumn> columns = makeColumns();
    return columns;
}

const RunColumn *findRunColumn(std::string_view name)
{
    const auto &columns = runColumns();
    const auto found = std::find_if(columns.begin(), columns.end(),
                                    [name](const RunColumn &column) { return column.name == name; });
    return found == columns.end() ? nullptr : &*found;
}

std::optional<double> numericValue(const RunRecord &record, std::string_view column)
{
    Value value;
    if (const RunColumn *known = findRunColumn(column))
        value = known->get(record);
    else if (const auto found = record.extra.find(std::string(column)); found != record.extra.end())
        value = found->second;
    if (const auto *number = std::get_if<double>(&value))
        return std::isfinite(*number) ? std::optional(*number) : std::nullopt;
    if (const auto *whole = std::get_if<std::int64_t>(&value))
        return static_cast<double>(*whole);
    return std::nullopt;
}

std::string toText(const Value &value)
{
    struct Writer
    {
        std::string operator()(std::monostate) const { return {}; }
        std::string operator()(std::int64_t number) const { return std::to_string(number); }
        std::string operator()(double number) const
        {
            return std::isfinite(number) ? formatNumber(number) : std::string();
        }
        std::string operator()(const std::string &text) const { return text; }
    };
    return std::visit(Writer(), value);
}

} // namespace mrpp

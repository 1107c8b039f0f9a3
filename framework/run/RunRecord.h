#pragma once
/// \file
/// One row of results: one planner on one instance once. A single table of columns (runColumns) drives the
/// store, the CSV and the JSON, so that they cannot disagree.

#include "framework/PlannerStatus.h"
#include "framework/support/Random.h"

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace mrpp
{

/// A cell: nothing, a whole number, a number, or text.
using Value = std::variant<std::monostate, std::int64_t, double, std::string>;

struct RunRecord
{
    // Which run it is.
    std::string runKey; ///< content key: the same key, the same question to the same planner
    std::string
        planKey;        ///< of the question as the plan asks it, whatever the program's defaults and versions
    std::string caseId; ///< "small_benchmark/tree/0": the same instance for every planner
    std::string model;  ///< the problem family: "small_benchmark"
    std::string problem;
    std::string sweepVariable; ///< empty where nothing is swept
    std::optional<double> sweepValue;
    std::int64_t repetition = 0;
    Seed graphSeed = 0;
    Seed instanceSeed = 0;
    Seed plannerSeed = 0;
    std::int64_t attempt = 1; ///< how often this run was begun, this time included
    std::string planner;      ///< the name in the plan, else the planner's own
    std::string motion;       ///< the campaign's motion rule: the widest that planners may use
    std::string rule;         ///< the motion rule that the planner's solutions need

    // The instance.
    std::optional<std::int64_t> vertices;
    std::optional<std::int64_t> edges;
    std::optional<std::int64_t> robots;
    std::optional<std::int64_t> free;
    std::optional<double> occupancy;
    std::optional<std::int64_t> pathLengthLowerBound;
    std::optional<std::int64_t> makespanLowerBound;
    std::optional<std::int64_t> sumOfCostsLowerBound;
    std::string pathLengthBoundName; ///< what kind of bound it is: "distances", … (LowerBounds.h)
    std::string makespanBoundName;
    std::string sumOfCostsBoundName;
    std::optional<double> boundTime; ///< seconds that all bounds of the instance took together
    std::string instanceFingerprint;
    std::string solvable; ///< "yes" or "no", under the planner's own motion rule; empty where nobody knows
    std::string unsolvableReason; ///< where it is "no"

    // How it ended.
    PlannerStatus status = PlannerStatus::unknown;
    std::string reason;
    std::string
        terminationReason; ///< why it was ended: "walltime", "cputime", …; empty where it ended itself
    std::optional<double> completed; ///< share of robots at their goals

    // What it cost: wall seconds on the monotonic clock, MB.
    std::optional<double> time; ///< of solve() alone
    std::optional<double> setupTime;
    std::optional<double> optimizationTime;
    std::optional<double> memory;      ///< peak of the run
    std::optional<double> cpuTime;     ///< of solve() and what it started, all cores together
    std::optional<std::int64_t> timed; ///< how often solve() was timed; `time` is the median
    std::optional<double> timeMin;
    std::optional<double> timeMax;
    std::optional<double> timeIqr; ///< third quartile minus first
    std::string repeatable;        ///< "yes", or "no: " and what differed; empty where solved once only

    // Under which conditions.
    std::optional<double> load; ///< the machine's load average of the last minute when the run began
    std::string cores;          ///< those that the run was confined to: "0", "2-3"; empty where to none
    std::string limitMeans;     ///< how limits were kept and measured: "memory rlimit, cpu cgroup2, …"

    // The solution; nothing where there is none.
    std::optional<std::int64_t> pathLength;
    std::optional<std::int64_t> actions;
    std::optional<std::int64_t> makespan;
    std::optional<std::int64_t> sumOfCosts;
    std::optional<std::int64_t> optimizedPathLength;
    std::optional<std::int64_t> optimizedActions;
    std::optional<std::int64_t> optimizedMakespan;
    std::optional<std::int64_t> optimizedSumOfCosts;
    std::string solutionFingerprint;

    /// Columns that pre- and post-run events added.
    std::map<std::string, Value> extra;

    [[nodiscard]] bool unsolvable() const { return solvable == "no"; }
    [[nodiscard]] bool solved() const { return status == PlannerStatus::solved; }
};

/// One column of RunRecord.
struct RunColumn
{
    enum class Type
    {
        integer,
        real,
        text,
    };
    std::string_view name;
    Type type = Type::text;
    bool inSolveJson = false; ///< whether `solve --json` has it
    std::function<Value(const RunRecord &)> get;
    std::function<void(RunRecord &, Value)> set; ///< takes what get gave; wrong types are ignored
};

/// All columns in the order of results.csv; those that events added (RunRecord::extra) stand behind them, by
/// name.
[[nodiscard]] const std::vector<RunColumn> &runColumns();

/// The column of that name, or null.
[[nodiscard]] const RunColumn *findRunColumn(std::string_view name);

/// A metric's (any numeric column's) value in a record; nothing where it is empty.
[[nodiscard]] std::optional<double> numericValue(const RunRecord &record, std::string_view column);

/// The cell as text: shortest numbers that read back as the same value, nothing for empty and for numbers
/// that are not finite.
[[nodiscard]] std::string toText(const Value &value);

} // namespace mrpp

#include "framework/run/RunRecord.h"
#include "framework/evaluation/Metrics.h"

#include "framework/run/RunRecordJson.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace mrpp
{
namespace
{

TEST(RunRecord, HasTheColumnsOfTheResultsFileInTheirOrder)
{
    const std::vector<std::string> expected = {"run_key",
                                               "case",
                                               "model",
                                               "problem",
                                               "sweep_variable",
                                               "sweep_value",
                                               "repetition",
                                               "planner",
                                               "status",
                                               "reason",
                                               "completed",
                                               "vertices",
                                               "edges",
                                               "robots",
                                               "free",
                                               "occupancy",
                                               "time",
                                               "setup_time",
                                               "optimization_time",
                                               "memory",
                                               "path_length",
                                               "actions",
                                               "makespan",
                                               "sum_of_costs",
                                               "optimized_path_length",
                                               "optimized_actions",
                                               "optimized_makespan",
                                               "optimized_sum_of_costs",
                                               "path_length_lower_bound",
                                               "makespan_lower_bound",
                                               "motion",
                                               "graph_seed",
                                               "instance_seed",
                                               "planner_seed",
                                               "attempt",
                                               "instance_fingerprint",
                                               "solution_fingerprint",
                                               "solvable",
                                               "unsolvable_reason",
                                               "plan_key",
                                               "termination_reason",
                                               "cpu_time",
                                               "timed",
                                               "time_min",
                                               "time_max",
                                               "time_iqr",
                                               "repeatable",
                                               "load",
                                               "cores",
                                               "limit_means",
                                               "rule",
                                               "path_length_bound_name",
                                               "makespan_bound_name",
                                               "sum_of_costs_lower_bound",
                                               "sum_of_costs_bound_name",
                                               "bound_time"};
    std::vector<std::string> names;
    for (const RunColumn &column : runColumns())
        names.emplace_back(column.name);
    EXPECT_EQ(names, expected);
}

TEST(RunRecord, HasEveryMeasureAsAColumnOfSolveJson)
{
    for (const Metric &metric : metrics())
    {
        const RunColumn *column = findRunColumn(metric.name);
        ASSERT_NE(column, nullptr) << metric.name;
        EXPECT_TRUE(column->inSolveJson) << metric.name;
    }
    for (const char *name : {"timed", "time_min", "time_max", "time_iqr", "path_length_bound_name"})
        EXPECT_TRUE(findRunColumn(name)->inSolveJson) << name;
}

TEST(RunRecord, ComesBackThroughItsColumns)
{
    RunRecord record;
    record.runKey = "key";
    record.status = PlannerStatus::partial;
    record.sweepValue = 0.5;
    record.plannerSeed = 9223372036854775807U;
    record.pathLength = 12;
    record.time = 3; // as a whole number from a database
    RunRecord copy;
    for (const RunColumn &column : runColumns())
        column.set(copy, column.get(record));
    EXPECT_EQ(copy.runKey, "key");
    EXPECT_EQ(copy.status, PlannerStatus::partial);
    EXPECT_EQ(copy.sweepValue, 0.5);
    EXPECT_EQ(copy.plannerSeed, 9223372036854775807U);
    EXPECT_EQ(copy.pathLength, 12);
    EXPECT_EQ(copy.time, 3);
    EXPECT_EQ(copy.makespan, std::nullopt);
    EXPECT_EQ(toJson(copy, JsonColumns::all), toJson(record, JsonColumns::all));

    findRunColumn("time")->set(copy, std::int64_t{4});
    EXPECT_EQ(copy.time, 4);
    findRunColumn("path_length")->set(copy, std::string("not a number"));
    EXPECT_EQ(copy.pathLength, 12);
}

TEST(RunRecord, GivesNumbersByColumnName)
{
    RunRecord record;
    record.pathLength = 7;
    record.extra["turns"] = 2.5;
    record.extra["colour"] = std::string("red");
    record.extra["ratio"] = std::nan("");
    EXPECT_EQ(numericValue(record, "path_length"), 7);
    EXPECT_EQ(numericValue(record, "turns"), 2.5);
    EXPECT_EQ(numericValue(record, "makespan"), std::nullopt);
    EXPECT_EQ(numericValue(record, "colour"), std::nullopt);
    EXPECT_EQ(numericValue(record, "planner"), std::nullopt);
    EXPECT_EQ(numericValue(record, "ratio"), std::nullopt);
    EXPECT_EQ(numericValue(record, "no_such_column"), std::nullopt);
}

TEST(RunRecord, WritesTheShortestNumbersThatReadBack)
{
    EXPECT_EQ(toText(Value()), "");
    EXPECT_EQ(toText(Value(std::int64_t{-3})), "-3");
    EXPECT_EQ(toText(Value(0.1)), "0.1");
    EXPECT_EQ(toText(Value(2.0)), "2");
    EXPECT_EQ(toText(Value(1.0 / 3)), "0.3333333333333333");
    EXPECT_EQ(toText(Value(std::numeric_limits<double>::infinity())), "");
    EXPECT_EQ(toText(Value(std::string("a,b"))), "a,b");
}

TEST(RunRecordJson, HasTheColumnsOfSolve)
{
    RunRecord record;
    record.planner = "push \"and\" swap";
    record.status = PlannerStatus::gave_up;
    record.reason = "line\nbreak";
    record.vertices = 5;
    record.time = 0.25;
    EXPECT_EQ(toJson(record, JsonColumns::solve), R"({
  "planner": "push \"and\" swap",
  "status": "gave_up",
  "reason": "line\nbreak",
  "completed": null,
  "vertices": 5,
  "edges": null,
  "robots": null,
  "time": 0.25,
  "setup_time": null,
  "optimization_time": null,
  "memory": null,
  "path_length": null,
  "actions": null,
  "makespan": null,
  "sum_of_costs": null,
  "optimized_path_length": null,
  "optimized_actions": null,
  "optimized_makespan": null,
  "optimized_sum_of_costs": null,
  "path_length_lower_bound": null,
  "makespan_lower_bound": null,
  "solvable": "",
  "unsolvable_reason": "",
  "cpu_time": null,
  "timed": null,
  "time_min": null,
  "time_max": null,
  "time_iqr": null,
  "rule": "",
  "path_length_bound_name": "",
  "makespan_bound_name": "",
  "sum_of_costs_lower_bound": null,
  "sum_of_costs_bound_name": "",
  "bound_time": null
}
)");
}

} // namespace
} // namespace mrpp

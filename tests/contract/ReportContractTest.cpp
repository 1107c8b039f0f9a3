/// \file
/// What every registered report must do.

#include "framework/store/ResultTable.h"
#include "framework/system/File.h"
#include "tests/contract/EverythingRegistered.h"

#include <filesystem>
#include <fstream>
#include <unistd.h>

namespace mrpp
{
namespace
{

const Catalog &catalog()
{
    static const Catalog kCatalog = test::everythingRegistered();
    return kCatalog;
}

/// A campaign of two planners on two small problems.
BenchmarkPlan plan(const std::string &plannerName)
{
    BenchmarkPlan plan;
    plan.campaign = "contract";
    plan.text = "campaign: contract\n";
    for (const char *name : {"tree", "theta"})
    {
        std::shared_ptr<Problem> problem = catalog().problems.create("small_benchmark");
        problem->configure(Config::scalar(name), {.catalog = &catalog()});
        plan.points.push_back({.model = "small_benchmark",
                               .problem = problem,
                               .name = name,
                               .sweepVariable = "",
                               .sweepValue = {},
                               .settings = problem->identity()});
    }
    plan.planners = {{"push_and_swap", plannerName, {}}, {"push_and_swap", "other", {{"attempts", "2"}}}};
    return plan;
}

std::vector<RunRecord> records(const BenchmarkPlan &plan)
{
    std::vector<RunRecord> list;
    for (const RunSpec &spec : expand(plan))
    {
        RunRecord record;
        record.runKey = spec.runKey;
        record.caseId = spec.caseId;
        record.model = plan.points[spec.point].model;
        record.problem = plan.points[spec.point].name;
        record.planner = plan.planners[spec.planner].name;
        record.graphSeed = spec.graphSeed;
        record.instanceSeed = spec.instanceSeed;
        record.vertices = record.edges = 7;
        record.robots = 3;
        if (spec.planner == 0)
        {
            record.status = PlannerStatus::solved;
            record.pathLength = record.makespan = record.optimizedPathLength = 12;
            record.time = 0.25;
            record.completed = 1;
        }
        else
        {
            record.status = PlannerStatus::gave_up;
            record.reason = "robots 0 and 1 cannot `pass`; $(touch nothing) <b>\"'\n%s";
        }
        list.push_back(record);
    }
    return list;
}

/// What push_and_swap answers to the run of that key.
std::optional<Solution> solutionOf(const BenchmarkPlan &plan, const std::string &runKey)
{
    for (const RunSpec &spec : expand(plan))
    {
        if (spec.runKey != runKey || spec.planner != 0)
            continue;
        const Problem &problem = *plan.points[spec.point].problem;
        const auto planner = catalog().planners.create("push_and_swap");
        planner->setInstance(std::make_shared<Instance>(
            makeInstance(problem, problem.makeGraph(spec.graphSeed), spec.instanceSeed)));
        planner->setup();
        EXPECT_EQ(planner->solve({}), PlannerStatus::solved);
        return planner->takeSolution();
    }
    return std::nullopt;
}

class EveryReport : public testing::TestWithParam<std::string>
{
protected:
    void SetUp() override
    {
        report_ = catalog().reports.create(GetParam());
        folder_ = std::filesystem::temp_directory_path() /
                  ("mrpp-report-contract-" + std::to_string(::getpid()) + "-" + GetParam());
        std::filesystem::create_directories(folder_);
    }
    void TearDown() override { std::filesystem::remove_all(folder_); }

    [[nodiscard]] std::vector<std::filesystem::path> write(const ResultTable &table) const
    {
        return report_->write(table, Provenance::here(), folder_);
    }

    static ResultTable table(const std::string &plannerName)
    {
        BenchmarkPlan p = plan(plannerName);
        auto r = records(p);
        return {p, std::move(r), [p](const std::string &runKey) { return solutionOf(p, runKey); }};
    }

    std::unique_ptr<Report> report_;
    std::filesystem::path folder_;
};

TEST_P(EveryReport, WritesTheFilesThatItNames)
{
    const auto files = write(table("PnS"));
    EXPECT_FALSE(files.empty());
    for (const auto &file : files)
    {
        EXPECT_TRUE(std::filesystem::is_regular_file(file)) << file;
        EXPECT_GT(std::filesystem::file_size(file), 0U) << file;
    }
}

TEST_P(EveryReport, ServesACampaignWithoutFinishedRuns)
{
    EXPECT_NO_THROW(static_cast<void>(
        write(ResultTable(plan("PnS"), {}, [](const std::string &) { return std::nullopt; }))));
}

TEST_P(EveryReport, TakesAnyPlannerNameAsText)
{
    const auto marker = folder_ / "ran";
    const std::string nasty =
        "a`touch " + marker.string() + "`$(touch " + marker.string() + ")'\"\\\n<b>&amp;\x01 %d @x_y^z";
    EXPECT_NO_THROW(static_cast<void>(write(table(nasty))));
    EXPECT_FALSE(std::filesystem::exists(marker));
}

TEST_P(EveryReport, RefusesAFolderThatIsAFile)
{
    const auto file = folder_ / "file";
    std::ofstream(file) << "x";
    EXPECT_THROW(static_cast<void>(report_->write(table("PnS"), Provenance::here(), file)), FileError);
}

INSTANTIATE_TEST_SUITE_P(Registered, EveryReport, testing::ValuesIn(catalog().reports.names()), test::nameOf);
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(EveryReport);

} // namespace
} // namespace mrpp

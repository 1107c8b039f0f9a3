#include "tests/cli/Comparison.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

namespace mrpp::test
{

namespace
{

using Files = std::map<std::string, std::string>;

/// Names of the files that only one of the folders has, or that differ.
std::vector<std::string> differences(const Files &a, const Files &b)
{
    std::vector<std::string> names;
    for (const auto &[name, contents] : a)
        if (!b.contains(name) || b.at(name) != contents)
            names.push_back(name);
    for (const auto &[name, contents] : b)
        if (!a.contains(name))
            names.push_back(name);
    return names;
}

} // namespace

std::string campaignPlan(int repetitions)
{
    return "campaign: test\nseed: 5\nrepetitions: " + std::to_string(repetitions) +
           R"(
limits: {time: 20 s}
problems:
  - small_benchmark: [tree, connector]
  - public_benchmark: {map: room.map, robots: [2, 4]}
planners:
  - push_and_swap
  - {planner: push_and_swap, name: another order, set: {order: random}}
optimizers: [redundancy_removal]
reports: [csv]
keep: {instances: true, solutions: true}
)";
}

void prepareCampaign(const Scratch &scratch, int repetitions)
{
    scratch.write("room.map", "type octile\nheight 4\nwidth 5\nmap\n.....\n.@@..\n..@..\n.....\n");
    scratch.write("plan.yaml", campaignPlan(repetitions));
}

std::vector<std::vector<std::string>> lastingResults(const Scratch &scratch, const std::string &folder)
{
    auto rows = parseCsv(scratch.read(folder + "/results.csv"));
    const std::set<std::string> passing = {
        "time", "setup_time", "optimization_time", "memory",    "attempt", "cpu_time",
        "load", "cores",      "limit_means",       "bound_time"};
    const std::vector<std::string> heading = rows.at(0);
    for (auto &row : rows)
        for (std::size_t i = heading.size(); i-- > 0;)
            if (passing.contains(heading[i]))
                row.erase(row.begin() + static_cast<std::ptrdiff_t>(i));
    return rows;
}

void expectSameAnswers(const Scratch &scratch, const std::string &a, const std::string &b)
{
    for (const char *folder : {"/instances", "/solutions"})
    {
        const Files files = scratch.tree(a + folder);
        EXPECT_FALSE(files.empty());
        EXPECT_THAT(differences(files, scratch.tree(b + folder)), ::testing::IsEmpty());
    }
}

void expectSameCampaign(const Scratch &scratch, const std::string &a, const std::string &b)
{
    expectSameAnswers(scratch, a, b);
    EXPECT_TRUE(lastingResults(scratch, a) == lastingResults(scratch, b));
}

} // namespace mrpp::test

#include "tests/cli/Program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace mrpp::test
{

namespace
{

using ::testing::HasSubstr;
using ::testing::MatchesRegex;
using ::testing::StartsWith;

const std::string kData = std::string(MRPP_SOURCE_DIR) + "/problems/data/";

/// Solves a small problem and writes every file.
Outcome solveEverything(const std::string &problem, const Scratch &scratch)
{
    return mrppsim({"solve",
                    "--graph",
                    kData + problem + ".graphml",
                    "--instance",
                    kData + problem + ".instance",
                    "--planner",
                    "push_and_swap",
                    "--seed",
                    "7",
                    "--time-limit",
                    "20",
                    "--set",
                    "order=far_first",
                    "--solution",
                    "s.csv",
                    "--schedule",
                    "c.csv",
                    "--optimized-solution",
                    "o.csv",
                    "--animation",
                    "a.txt",
                    "--json",
                    "s.json"},
                   scratch);
}

Outcome validateFile(const std::string &problem, const std::string &file, const Scratch &scratch,
                     const std::string &motion = "rotation")
{
    return mrppsim(
        {"validate", "--instance", kData + problem + ".instance", "--solution", file, "--motion", motion},
        scratch);
}

std::vector<std::string> lines(const std::string &text)
{
    std::vector<std::string> list;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);)
        list.push_back(line);
    return list;
}

std::string joined(const std::vector<std::string> &list)
{
    std::string text;
    for (const std::string &line : list)
        text += line + "\n";
    return text;
}

TEST(Solve, everyFileAgreesWithTheJson)
{
    const Scratch scratch;
    const Outcome outcome = solveEverything("connector", scratch);
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const auto json = nlohmann::json::parse(scratch.read("s.json"));
    EXPECT_EQ(json.at("planner"), "push_and_swap");
    EXPECT_EQ(json.at("status"), "solved");
    EXPECT_EQ(json.at("vertices"), 18);
    EXPECT_EQ(json.at("edges"), 19);
    EXPECT_EQ(json.at("robots"), 10);
    EXPECT_EQ(json.at("completed"), 1.0);
    EXPECT_EQ(json.at("path_length_lower_bound"), 44);
    EXPECT_EQ(json.at("path_length_bound_name"), "distances");
    EXPECT_EQ(json.at("sum_of_costs_lower_bound"), 44);
    EXPECT_GE(json.at("cpu_time").get<double>(), 0);
    for (const char *name : {"timed", "time_min", "time_max", "time_iqr", "bound_time"})
        EXPECT_TRUE(json.contains(name)) << name;
    EXPECT_GE(json.at("time").get<double>(), 0);
    EXPECT_GT(json.at("memory").get<double>(), 0);
    EXPECT_LE(json.at("optimized_path_length"), json.at("path_length"));

    const auto moves = lines(scratch.read("s.csv"));
    EXPECT_EQ(moves.front(), "step,robot,from,to");
    EXPECT_EQ(moves.size() - 1, json.at("path_length"));
    const auto optimized = lines(scratch.read("o.csv"));
    EXPECT_EQ(optimized.size() - 1, json.at("optimized_path_length"));
    const auto schedule = lines(scratch.read("c.csv"));
    EXPECT_EQ(std::stoi(schedule.back()) + 1, json.at("makespan"));
    EXPECT_FALSE(scratch.read("a.txt").empty());

    EXPECT_EQ(validateFile("connector", "s.csv", scratch, "pebble").code, 0);
    EXPECT_EQ(validateFile("connector", "o.csv", scratch, "pebble").code, 0);
    EXPECT_EQ(validateFile("connector", "c.csv", scratch, "following").code, 0);
    EXPECT_EQ(validateFile("connector", "c.csv", scratch, "pebble").code, 1);
}

TEST(Solve, writesAllOfItsFilesOrNone)
{
    const Scratch scratch;
    scratch.write("folder/in.txt", "");
    const Outcome outcome =
        mrppsim({"solve", "--instance", kData + "tree.instance", "--planner", "push_and_swap", "--json",
                 "s.json", "--solution", "s.csv", "--animation", "folder"},
                scratch);
    EXPECT_EQ(outcome.code, 2);
    EXPECT_THAT(outcome.err, HasSubstr("folder: cannot be written: it is a folder"));
    EXPECT_THAT(scratch.tree(), ::testing::SizeIs(1));
}

TEST(Solve, anAnimationKeepsTheMotionRule)
{
    const Scratch scratch;
    const auto animation = [&scratch](const char *motion)
    {
        const Outcome outcome = mrppsim({"solve", "--instance", kData + "connector.instance", "--planner",
                                         "push_and_swap", "--motion", motion, "--animation", "a.txt"},
                                        scratch);
        EXPECT_EQ(outcome.code, 0) << outcome.err;
        EXPECT_EQ(validateFile("connector", "a.txt", scratch, motion).code, 0) << motion;
        return scratch.read("a.txt");
    };
    EXPECT_THAT(animation("rotation"), HasSubstr("M:TRANSITIVE"));
    EXPECT_THAT(animation("following"), HasSubstr("M:TRANSITIVE"));
    EXPECT_THAT(animation("parallel"), HasSubstr("M:IMMEDIATE"));
    EXPECT_THAT(animation("pebble"), HasSubstr("M:IMMEDIATE"));
}

TEST(Solve, jsonHasEveryPromisedKeyAlsoWithoutASolution)
{
    const Scratch scratch;
    const Outcome outcome = solveEverything("tree_with_cycle_leaves", scratch);
    EXPECT_EQ(outcome.code, 1);
    EXPECT_THAT(outcome.err, HasSubstr("no file of moves was written"));
    const auto json = nlohmann::json::parse(scratch.read("s.json"));
    for (const char *key : {"planner",
                            "status",
                            "reason",
                            "vertices",
                            "edges",
                            "robots",
                            "time",
                            "setup_time",
                            "optimization_time",
                            "memory",
                            "path_length",
                            "actions",
                            "makespan",
                            "optimized_path_length",
                            "optimized_actions",
                            "optimized_makespan",
                            "sum_of_costs",
                            "optimized_sum_of_costs",
                            "path_length_lower_bound",
                            "makespan_lower_bound",
                            "completed"})
        EXPECT_TRUE(json.contains(key)) << key;
    EXPECT_NE(json.at("status"), "solved");
    EXPECT_TRUE(json.at("path_length").is_null());
    EXPECT_FALSE(json.at("reason").get<std::string>().empty());
    EXPECT_FALSE(scratch.has("s.csv"));
    EXPECT_FALSE(scratch.has("c.csv"));
    EXPECT_FALSE(scratch.has("a.txt"));
}

TEST(Solve, aPlannerOfAWiderRuleThanAllowedIsUnsupported)
{
    const Scratch scratch;
    EXPECT_EQ(mrppsim({"solve", "--instance", kData + "tree.instance", "--planner", "push_and_swap",
                       "--motion", "pebble"},
                      scratch)
                  .code,
              0);
}

TEST(Solve, aScenarioGivesAsManyRobotsAsAsked)
{
    const Scratch scratch;
    scratch.write("room.map", "type octile\nheight 3\nwidth 4\nmap\n....\n.@@.\n....\n");
    scratch.write("room.scen", "version 1\n"
                               "0\troom.map\t4\t3\t0\t0\t3\t0\t3\n"
                               "0\troom.map\t4\t3\t3\t2\t0\t2\t3\n"
                               "0\troom.map\t4\t3\t1\t0\t2\t2\t4\n");
    const auto solved = [&scratch](std::vector<std::string> more)
    {
        std::vector<std::string> words = {"solve",         "--instance", "room.scen", "--planner",
                                          "push_and_swap", "--json",     "out.json"};
        words.insert(words.end(), more.begin(), more.end());
        const Outcome outcome = mrppsim(words, scratch);
        EXPECT_EQ(outcome.code, 0) << outcome.err;
        return nlohmann::json::parse(scratch.read("out.json")).at("robots").get<int>();
    };
    EXPECT_EQ(solved({}), 3);
    EXPECT_EQ(solved({"--robots", "2"}), 2);
    EXPECT_EQ(solved({"--robots", "2", "--graph", "room.map"}), 2);
    const Outcome tooMany =
        mrppsim({"solve", "--instance", "room.scen", "--planner", "push_and_swap", "--robots", "4"}, scratch);
    EXPECT_EQ(tooMany.code, 2);
    EXPECT_THAT(tooMany.err, HasSubstr("room.scen"));
}

TEST(Solve, theSameSeedGivesTheSameFiles)
{
    const Scratch first;
    const Scratch second;
    ASSERT_EQ(solveEverything("loop_chain", first).code, 0);
    ASSERT_EQ(solveEverything("loop_chain", second).code, 0);
    for (const char *file : {"s.csv", "o.csv", "c.csv", "a.txt"})
        EXPECT_EQ(first.read(file), second.read(file)) << file;
}

/// Every way to break one row of a right solution is noticed, and the row is named.
TEST(Validate, namesTheFirstBadMoveOfEveryMutation)
{
    const Scratch scratch;
    ASSERT_EQ(solveEverything("tree", scratch).code, 0);
    const auto rows = lines(scratch.read("s.csv"));
    const Outcome right = validateFile("tree", "s.csv", scratch);
    EXPECT_EQ(right.code, 0);
    EXPECT_THAT(right.out, StartsWith("valid: "));

    for (std::size_t i = 1; i < rows.size(); ++i)
    {
        std::vector<std::vector<std::string>> mutants(3, rows);
        const std::string step = rows[i].substr(0, rows[i].find(','));
        mutants[0].erase(mutants[0].begin() + static_cast<std::ptrdiff_t>(i));           // dropped
        mutants[1].insert(mutants[1].begin() + static_cast<std::ptrdiff_t>(i), rows[i]); // repeated
        mutants[2][i] = step + ",0,0,6";                                                 // no such edge
        for (std::size_t kind = 0; kind < mutants.size(); ++kind)
        {
            scratch.write("bad.csv", joined(mutants[kind]));
            const Outcome outcome = validateFile("tree", "bad.csv", scratch);
            EXPECT_EQ(outcome.code, 1) << "row " << i << ", mutation " << kind;
            EXPECT_EQ(outcome.err, "");
            const bool cutShort = kind == 0 && i + 1 == rows.size(); // legal, but a robot misses its goal
            const std::size_t line = kind == 1 ? i + 2 : i + 1;
            EXPECT_THAT(outcome.out, StartsWith(cutShort ? "invalid: bad.csv: robot "
                                                         : "invalid: bad.csv:" + std::to_string(line) + ": "))
                << "row " << i << ", mutation " << kind;
        }
    }
}

TEST(Validate, tellsWrongNumbersFromText)
{
    const Scratch scratch;
    const auto check = [&scratch](const std::string &rows)
    {
        scratch.write("x.csv", rows);
        return validateFile("tree", "x.csv", scratch);
    };
    EXPECT_EQ(check("step,robot,from,to\n0,99,1,0\n").code, 1);
    EXPECT_EQ(check("step,robot,from,to\n0,-1,1,0\n").code, 1);
    EXPECT_EQ(check("step,robot,from,to\n0,0,1,4294967296\n").code, 1);
    EXPECT_EQ(check("step,robot,from,to\n5,0,1,0\n").code, 1);
    EXPECT_EQ(check("step,robot,from,to\n").code, 1);
    for (const char *text :
         {"", "step,robot,from\n0,0,1\n", "step,robot,from,to\n0,0,one,0\n", "step,robot,from,to\n0,0,1\n",
          "step,robot,from,to\n0,0,1,0,0\n", "step,robot,from,to\n0,0,1.5,0\n"})
    {
        const Outcome outcome = check(text);
        EXPECT_EQ(outcome.code, 2) << text;
        EXPECT_THAT(outcome.err, StartsWith("x.csv:")) << text;
    }
}

} // namespace
} // namespace mrpp::test

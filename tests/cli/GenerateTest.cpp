#include "problems/formats/Formats.h"
#include "tests/cli/Program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace mrpp::test
{

namespace
{

using ::testing::HasSubstr;

TEST(Generate, writesAGraphAndAnInstance)
{
    const Scratch scratch;
    const Outcome outcome =
        mrppsim({"generate", "biconnected", "--initial-cycle", "5", "--handles", "4", "--max-handle-length",
                 "3", "--seed", "1", "--graph", "g.graphml", "--robots", "6", "--instance", "g.instance"},
                scratch);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(outcome.out, "biconnected 5-4-3: 9 vertices, 13 edges, 6 robots\n");
    const LoadedInstance loaded = loadInstance({scratch.path() / "g.instance", std::nullopt, std::nullopt});
    EXPECT_EQ(loaded.instance.graph->edgeCount(), 13U);
    EXPECT_TRUE(loaded.instance.graph->hasEdge(0, 8)) << "as in the generator's own test";
    EXPECT_EQ(loaded.instance.robotCount(), 6U);
}

TEST(Generate, dependsOnTheSeedAlone)
{
    const Scratch scratch;
    const auto made = [&scratch](const char *seed)
    {
        const Outcome outcome = mrppsim({"generate", "random", "--vertices", "30", "--seed", seed}, scratch);
        EXPECT_EQ(outcome.code, 0) << outcome.err;
        return outcome.out;
    };
    EXPECT_EQ(made("1"), made("1"));
    EXPECT_NE(made("1"), made("2"));
    EXPECT_THAT(made("1"), HasSubstr("</graphml>"));
    EXPECT_TRUE(scratch.tree().empty());
}

TEST(Generate, writesMapsAndScenarios)
{
    const Scratch scratch;
    const Outcome outcome =
        mrppsim({"generate", "rooms", "--width", "15", "--height", "11", "--room", "3", "--graph", "r.map",
                 "--robots", "4", "--instance", "r.scen", "--solvable"},
                scratch);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_THAT(scratch.read("r.map"), HasSubstr("height 11\nwidth 15\nmap\n...@...@"));
    const Outcome solved = mrppsim({"solve", "--graph", "r.map", "--instance", "r.scen", "--planner",
                                    "push_and_swap", "--time-limit", "20"},
                                   scratch);
    EXPECT_EQ(solved.code, 0) << solved.out << solved.err;
}

TEST(Generate, hasEveryGeneratorWithItsParameters)
{
    const Scratch scratch;
    const std::string help = mrppsim({"generate", "--help"}, scratch).out;
    std::size_t families = 0;
    for (const auto &problem : nlohmann::json::parse(mrppsim({"list", "problems", "--json"}, scratch).out))
    {
        const auto name = problem.at("name").get<std::string>();
        const Outcome one = mrppsim({"generate", name, "--help"}, scratch);
        if (one.code == 2)
        {
            EXPECT_THAT(one.err, HasSubstr("there is no '" + name + "' to generate")); // it comes from files
            continue;
        }
        ASSERT_EQ(one.code, 0) << name;
        ++families;
        EXPECT_THAT(help, HasSubstr(name));
        EXPECT_THAT(one.out, HasSubstr("--seed"));
        for (const auto &parameter : problem.at("parameters"))
        {
            auto flag = "--" + parameter.at("name").get<std::string>();
            std::replace(flag.begin(), flag.end(), '_', '-');
            EXPECT_THAT(one.out, HasSubstr(flag)) << name;
        }
        EXPECT_EQ(mrppsim({"generate", name, "--graph", name + ".graphml"}, scratch).code, 0) << name;
    }
    EXPECT_GE(families, 9U);
}

} // namespace
} // namespace mrpp::test

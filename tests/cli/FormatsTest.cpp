/// Files of other tools, given to the program.

#include "tests/cli/Program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace mrpp::test
{

namespace
{

using ::testing::HasSubstr;
using ::testing::Not;

TEST(FormatsOfOthers, EmitterCellsArePassableWhereAsked)
{
    const Scratch scratch;
    scratch.write("w.map", "type octile\nheight 1\nwidth 4\nmap\n.ES.\n");
    scratch.write("w.instance", "graph = w.map\nagent: start = 0, goal = 3\n");
    scratch.write("moves.csv", "step,robot,from,to\n0,0,0,1\n1,0,1,2\n2,0,2,3\n");
    const auto runs = [&](std::vector<std::string> words)
    {
        const Outcome refused = mrppsim(words, scratch);
        EXPECT_EQ(refused.code, 2) << words[0];
        EXPECT_THAT(refused.err, HasSubstr("w.map:5:2: unknown symbol 'E'")) << words[0];
        EXPECT_THAT(refused.err, HasSubstr("known under the passability lorr")) << words[0];
        words.insert(words.end(), {"--passability", "lorr"});
        const Outcome done = mrppsim(words, scratch);
        EXPECT_EQ(done.code, 0) << words[0] << done.err;
    };
    runs({"check", "--instance", "w.instance"});
    runs({"solve", "--instance", "w.instance", "--planner", "push_and_swap"});
    runs({"validate", "--instance", "w.instance", "--solution", "moves.csv"});
    runs({"convert", "w.map", "w.graphml"});
    runs({"view", "--instance", "w.instance", "--solution", "moves.csv", "-o", "w.html"});
    scratch.write("plan.yaml", "problems: [fully_controlled: {instance: w.instance, passability: lorr}]\n"
                               "planners: [push_and_swap]\nreports: [csv]\n");
    EXPECT_EQ(mrppsim({"run", "plan.yaml", "-o", "out", "-q"}, scratch).code, 0);
    EXPECT_THAT(scratch.read("out/results.csv"), HasSubstr("solved"));
}

TEST(FormatsOfOthers, CoordinatesOfAnySizeAreDrawn)
{
    for (const std::string unit : {"1e308", "1e-320"})
    {
        const Scratch scratch;
        std::string nodes;
        for (const std::string x : {unit, "-" + unit, std::string("0")})
            nodes += "<node id=\"n" + std::to_string(nodes.size()) + "\"><data key=\"x\">" + x +
                     "</data><data key=\"y\">0</data></node>";
        scratch.write("g.graphml", "<graphml><key id=\"x\" for=\"node\" attr.name=\"x\"/><key id=\"y\" "
                                   "for=\"node\" attr.name=\"y\"/>"
                                   "<graph edgedefault=\"undirected\">" +
                                       nodes + "<edge source=\"n0\" target=\"n" +
                                       std::to_string(nodes.find("<node", 1)) + "\"/></graph></graphml>");
        scratch.write("g.instance", "graph = g.graphml\nagent: start = 0, goal = 1\n");
        scratch.write("plan.yaml", "problems: [fully_controlled: g.instance]\nplanners: [push_and_swap]\n"
                                   "reports: [layouts, animations, html]\n");
        const Outcome outcome = mrppsim({"run", "plan.yaml", "-o", "out", "-q"}, scratch);
        EXPECT_EQ(outcome.code, 0) << outcome.err;
        EXPECT_TRUE(scratch.has("out/report.html"));
        for (const auto &[name, text] : scratch.tree("out/animations"))
        {
            EXPECT_THAT(text, Not(HasSubstr("inf"))) << name;
            EXPECT_THAT(text, HasSubstr("POS =")) << name;
        }
    }
}

TEST(FormatsOfOthers, OlderPlanVizIsAskedFor)
{
    const Scratch scratch;
    scratch.write("w.map", "type octile\nheight 2\nwidth 1\nmap\n.\n.\n");
    scratch.write("w.instance", "graph = w.map\nagent: start = 0, goal = 1\n");
    scratch.write("moves.csv", "step,robot,from,to\n0,0,0,1\n");
    const auto actions = [&](const std::string &format)
    {
        const Outcome outcome =
            mrppsim({"convert", "moves.csv", "p.json", "--instance", "w.instance", "--to", format}, scratch);
        EXPECT_EQ(outcome.code, 0) << outcome.err;
        return scratch.read("p.json");
    };
    EXPECT_THAT(actions("planviz"), HasSubstr("\"actualPaths\":[\"U\"]"));
    EXPECT_THAT(actions("planviz_2_0"), HasSubstr("\"actualPaths\":[\"D\"]"));
}

} // namespace

} // namespace mrpp::test

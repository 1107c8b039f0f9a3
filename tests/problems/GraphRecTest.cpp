/// GraphRec's text and XML: what is written is what GraphRec plays, and comes back when it is read.

#include "problems/formats/GraphRec.h"

#include "tests/problems/FormatCases.h"
#include "tests/problems/GraphRecChecker.h"

namespace mrpp
{
namespace
{

constexpr const char *kExample = "id:1\nV =\n(1:0)[1:0:0]\n(2:0)[-1:2:2]\n(3:0)[2:1:1]\nE =\n{1,2} (0)\n"
                                 "{2,3} (0)\n{1,3} (0)\nMOD =\nM:TRANSITIVE\nPOS =\n1:X0:Y0\n2:X80:Y0\n"
                                 "3:X40:Y70\nSolution\n1 ---> 2 [0 ---> 0] (0)\n3 ---> 1 [0 ---> 0] (0)\n"
                                 "Length:2\n";

TEST(GraphRecChecker, KnowsWhatGraphRecPlays)
{
    EXPECT_EQ(checkGraphRecText(kExample).complaint, "");
    const auto damaged = [](const std::string &old, const std::string &now)
    {
        std::string text = kExample;
        return checkGraphRecText(text.replace(text.find(old), old.size(), now)).complaint;
    };
    EXPECT_THAT(damaged("id:1\n", ""), testing::HasSubstr("no id"));
    EXPECT_THAT(damaged("V =", "V="), testing::HasSubstr("'V ='"));
    EXPECT_THAT(damaged("Length:2\n", ""), testing::HasSubstr("no line Length:"));
    EXPECT_THAT(damaged("X80", "X8e1"), testing::HasSubstr("no known kind"));
    EXPECT_THAT(damaged("{1,2} (0)", "{1,2}(0)"), testing::HasSubstr("no known kind"));
    EXPECT_THAT(damaged("0] (0)\nLength", "0] (2)\nLength"), testing::HasSubstr("a gap"));
    EXPECT_THAT(damaged("3 ---> 1", "3 ---> 3"), testing::HasSubstr("a loop"));
    EXPECT_THAT(damaged("3 ---> 1", "2 ---> 1"), testing::HasSubstr("nobody there"));
    EXPECT_THAT(damaged("1 ---> 2", "1 ---> 3"), testing::HasSubstr("a swap"));
    EXPECT_THAT(damaged("M:TRANSITIVE", "M:IMMEDIATE"), testing::HasSubstr("not empty"));
}

RC_GTEST_PROP(GraphRec, PlaysEverySchedule, ())
{
    const Case given = randomCase(*rc::gen::arbitrary<bool>() ? randomCells() : randomGraph());
    for (const MotionRule rule :
         {MotionRule::pebble, MotionRule::parallel, MotionRule::following, MotionRule::rotation})
    {
        if (!validate(given.instance, given.schedule, rule).legal)
            continue;
        const CheckedAnimation played =
            checkGraphRecText(formatGraphRec(given.instance, given.schedule, rule));
        RC_ASSERT(played.complaint == "");
        RC_ASSERT(played.moves == given.schedule.pathLength());
        RC_ASSERT(played.steps == given.schedule.makespan());
        for (std::size_t robot = 0; robot < given.instance.robotCount(); ++robot)
        {
            const int goal = static_cast<int>(given.instance.goals[robot]) + 1;
            RC_ASSERT(played.robotAt.at(goal) == static_cast<int>(robot) + 1);
        }
    }
}

TEST(GraphRec, ARotationIsTransitive)
{
    const auto graph = Graph::fromEdges(3, {{0, 1}, {1, 2}, {0, 2}});
    const Instance instance{graph, {0, 1, 2}, {1, 2, 0}};
    const Schedule schedule({{0, 0, 1}, {1, 1, 2}, {2, 2, 0}}, {3});
    const std::string text = formatGraphRec(instance, schedule, MotionRule::rotation);
    EXPECT_EQ(checkGraphRecText(text).complaint, "");
    EXPECT_THAT(text, testing::HasSubstr("M:TRANSITIVE"));
    EXPECT_THAT(formatGraphRec(instance, Schedule(), MotionRule::parallel),
                testing::HasSubstr("M:IMMEDIATE"));
}

TEST(GraphRec, IsWrittenInPieces)
{
    const auto graph = Graph::fromEdges(2, {{0, 1}});
    Schedule schedule;
    for (Vertex i = 0; i < 1000000; ++i)
        schedule.appendStep(std::vector<Move>{{0, i % 2, (i + 1) % 2}});
    std::size_t largest = 0;
    std::size_t total = 0;
    writeGraphRec({graph, {0}, {0}}, schedule, MotionRule::pebble, GraphRecForm::text,
                  [&](std::string_view piece)
                  {
                      largest = std::max(largest, piece.size());
                      total += piece.size();
                  });
    EXPECT_GT(total, 17000000);
    EXPECT_LT(largest, 70000);
}

TEST(GraphRecReader, ReadsWhatGraphRecReads)
{
    const GraphRecFile file = parseGraphRec(kExample, "f");
    EXPECT_EQ(file.graph->vertexCount(), 3);
    EXPECT_EQ(file.graph->edgeCount(), 3);
    EXPECT_EQ(file.graph->coordinate(1), (Point{80, 0, 0}));
    EXPECT_EQ(file.starts, (std::vector<Vertex>{0, 2}));
    EXPECT_EQ(file.goals, (std::vector<Vertex>{2, 1}));
    const SolutionRows rows = graphRecRows(file, {file.graph, file.starts, {1, 0}});
    ASSERT_EQ(rows.moves.size(), 2);
    EXPECT_EQ(rows.moves[1].robot, 1);
    EXPECT_EQ(rows.lineOf(1), 18);
}

TEST(GraphRecReader, SkipsWhatMeansNothing)
{
    const GraphRecFile file = parseGraphRec(
        "id:-\r\nV=\r\n(7:0)[5:0:0]\r\n(-3:0)[0:0:0] 7\r\nE=\r\n{7,-3} (0)\r\nwords\r\n"
        "B_SCN:A:#ffffff\r\nANGLE:0\r\n1 (7,-3): 1 2 [3] {4}\r\nSolution\r\n7 -> -3 (0)\r\nLength:1",
        "f");
    EXPECT_EQ(file.starts, std::vector<Vertex>{0});
    EXPECT_TRUE(file.goals.empty());
    ASSERT_EQ(file.moves.size(), 1);
    EXPECT_EQ(file.moves[0].to, 1);
    EXPECT_FALSE(file.graph->hasCoordinates());
}

TEST(GraphRecReader, RefusesWhatIsMalformed)
{
    const std::string begin = "id:1\nV =\n(1:0)[1:0:0]\n(2:0)[0:1:1]\n";
    const std::vector<Refusal> refusals = {
        {"Empty", "", "bad:1:1", "without a line 'Length:"},
        {"Cut", begin + "E =\n{1,2", "bad:6:5", "expected '}'"},
        {"NoLength", begin, "bad:5:1", "without a line 'Length:"},
        {"TwoGraphs", begin + "id:2\n", "bad:5:1", "a second graph"},
        {"Behind", begin + "Length:0\nid:2\n", "bad:6:1", "behind 'Length:'"},
        {"VertexTwice", begin + "(1:0)[0:0:0]\n", "bad:5:2", "vertex 1 is there already"},
        {"RobotTwice", begin + "(3:0)[1:0:0]\n", "bad:5:7", "robot 1 stands on another vertex"},
        {"GoalTwice", begin + "(3:0)[0:1:1]\n", "bad:5:11", "robot 1 has a goal on another"},
        {"EdgeOfNothing", begin + "{1,9} (0)\n", "bad:5:2", "there is no vertex 9"},
        {"EdgeWithoutCycle", begin + "{1,2}\n", "bad:5:6", "expected '('"},
        {"MoveOfNothing", begin + "1 ---> 9 (0)\n", "bad:5:1", "there is no vertex 9"},
        {"MoveWithoutStep", begin + "1 ---> 2\n", "bad:5:9", "expected '('"},
        {"MoveBeforeTheFirst", begin + "1 ---> 2 (-1)\n", "bad:5:1", "comes before the first"},
        {"PositionTwice", begin + "1:X0:Y0\n1:X0:Y0\n", "bad:6:1", "has a position already"},
        {"PositionIsAWord", begin + "1:Xa:Y0\n", "bad:5:4", "'a' is no coordinate"},
        {"Huge", begin + "99999999999999999999 ---> 2 (0)\n", "bad:5:1", "too large"},
    };
    for (const Refusal &refusal : refusals)
        expectRefusal(refusal,
                      [](const std::string &text, const char *file) { (void)parseGraphRec(text, file); });
    const GraphRecFile file = parseGraphRec(kExample, "f");
    EXPECT_THROW((void)graphRecRows(file, {Graph::fromEdges(2, {{0, 1}}), {0}, {1}}), ParseError);
    EXPECT_THROW((void)graphRecRows(file, {file.graph, {0}, {1}}), ParseError); // nobody on vertex 2
}

RC_GTEST_PROP(GraphRecReader, ReadsWhatIsWritten, ())
{
    const Case given = randomCase(*rc::gen::arbitrary<bool>() ? randomCells() : randomGraph());
    const std::string text = formatGraphRec(given.instance, given.schedule);
    const GraphRecFile file = parseGraphRec(text, "f");
    RC_ASSERT(file.warnings.empty());
    RC_ASSERT(file.graph->fingerprint() == given.instance.graph->fingerprint());
    RC_ASSERT(file.starts == given.instance.starts);
    RC_ASSERT(file.goals == given.instance.goals);
    RC_ASSERT(scheduleOf(graphRecRows(file, given.instance), given.instance) == given.schedule);
}

RC_GTEST_PROP(GraphRecXml, ReadsWhatIsWritten, ())
{
    const Case given = randomCase(*rc::gen::arbitrary<bool>() ? randomCells() : randomGraph());
    const std::string text =
        formatGraphRec(given.instance, given.schedule, MotionRule::rotation, GraphRecForm::xml);
    const GraphRecFile file = parseGraphRecXml(text, "f");
    RC_ASSERT(file.graph->fingerprint() == given.instance.graph->fingerprint());
    RC_ASSERT(file.graph->hasCoordinates() == given.instance.graph->hasCoordinates());
    RC_ASSERT(file.starts == given.instance.starts);
    RC_ASSERT(file.goals.empty());
    RC_ASSERT(scheduleOf(graphRecRows(file, given.instance), given.instance) == given.schedule);
}

TEST(GraphRecXml, RefusesWhatIsMalformed)
{
    const std::string begin = "<graphrec version=\"1.0\">\n<solution><graph>";
    const std::string end = "</graph></solution></graphrec>";
    const std::vector<Refusal> refusals = {
        {"OtherRoot", "<svg/>", "bad:1:1", "this is an SVG picture, but expected an animation for GraphRec"},
        {"OtherVersion", "<graphrec version=\"2\"/>", "bad:1:1", "expected 1.0"},
        {"NoSolution", "<graphrec version=\"1.0\"/>", "bad:1:1", "no <solution>"},
        {"TwoSolutions", begin + "</graph></solution>\n<solution/></graphrec>", "bad:3:1",
         "second <solution>"},
        {"NoNumber", begin + "\n<node id=\"x\"/>" + end, "bad:3:1", "'x' is no whole number"},
        {"NoId", begin + "\n<node/>" + end, "bad:3:1", "needs an attribute 'id'"},
        {"HalfPosition", begin + "\n<node id=\"1\" x=\"3\"/>" + end, "bad:3:1", "needs an attribute 'y'"},
        {"EdgeOfNothing", begin + "\n<edge n1=\"1\" n2=\"2\"/>" + end, "bad:3:1", "there is no vertex 1"},
    };
    for (const Refusal &refusal : refusals)
        expectRefusal(refusal,
                      [](const std::string &text, const char *file) { (void)parseGraphRecXml(text, file); });
}

} // namespace
} // namespace mrpp

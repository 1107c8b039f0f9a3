/// Files of Surynek's programs: problems and solutions.

#include "problems/formats/Surynek.h"

#include "tests/problems/FormatCases.h"

namespace mrpp
{
namespace
{

constexpr const char *kTree = "V =\n(0:-1)[1:0:0]\n(1:-1)[0:2:2]\n(2:-1)[2:0:0]\n(3:-1)[0:1:1]\n"
                              "E =\n{0,1} (-1)\n{1,2} (-1)\n{1,3} (-1)\n";

TEST(Cpf, ReadsGraphStartsAndGoals)
{
    const Instance instance = parseCpf(kTree, "f").instance;
    EXPECT_EQ(instance.graph->vertexCount(), 4);
    EXPECT_EQ(instance.graph->edgeCount(), 3);
    EXPECT_TRUE(instance.graph->hasEdge(1, 3));
    EXPECT_EQ(instance.starts, (std::vector<Vertex>{0, 2}));
    EXPECT_EQ(instance.goals, (std::vector<Vertex>{3, 1}));
    EXPECT_EQ(formatCpf(instance), kTree);
}

TEST(Cpf, ReadsTheVariants)
{
    const std::string fingerprint = parseCpf(kTree, "f").instance.fingerprint();
    for (const char *text : {
             // capacities
             "V =\n(0:-1:1)[1:0:0]\n(1:-1:1)[0:2:2]\n(2:-1:1)[2:0:0]\n(3:-1:1)[0:1:1]\n"
             "E =\n{0,1} (-1)\n{1,2} (-1)\n{1,3} (-1)\n",
             // short forms
             "V =\n(0,1,0)\n(1,0,2)\n(2,2,0)\n(3,0,1)\nE =\n{0,1}\n{1,2}\n{1,3}\n",
             "V =\n(0,1,1,0)\n(1,1,0,2)\n(2,1,2,0)\n(3,1,0,1)\nE =\n{0,1}\n{1,2}\n{1,3}\n",
             // BIBOX: blanks behind the headings, neighbours behind the brackets, cycles at the end
             "Multirobot\r\nV = \r\n(0:0)[1:0:0] 1\r\n(1:0)[-1:2:2] 0 2 3\r\n(2:1)[2:-1:0] 1\r\n(3:1)[0:1:1] "
             "1\r\nE = \r\n{0,1} (0)\r\n{1,2} (1)\r\n{1,3} (1)\r\nC =\r\nwhatever\r\n",
             // empty lists of conflicts
             "V =\n(0:-1)[1:0:0]<>\n(1:-1)[0:2:2]< >\n(2:-1)[2:0:0]\n(3:-1)[0:1:1]\n"
             "E =\n{0,1} (-1) < >\n{1,2} (-1)\n{1,3} (-1)",
         })
        EXPECT_EQ(parseCpf(text, "f").instance.fingerprint(), fingerprint) << text;
}

TEST(Cpf, LeavesOutLoopsAndRepetitionsAndSaysSo)
{
    const CpfProblem problem =
        parseCpf("V =\n(0:0)[0:0:0]\n(1:0)[0:0:0]\nE =\n{0,1} (0)\n{1,0} (0)\n{1,1} (0)", "f");
    EXPECT_EQ(problem.instance.graph->edgeCount(), 1);
    ASSERT_EQ(problem.warnings.size(), 1);
    EXPECT_THAT(problem.warnings[0], testing::HasSubstr("2 loops or repeated edges"));
}

TEST(Cpf, RefusesWhatIsMalformed)
{
    const std::string v = "V =\n(0:-1)[1:0:0]\n";
    const std::vector<Refusal> refusals = {
        {"Empty", "", "bad:1:1", "without a line 'V ='"},
        {"NoEdges", v, "bad:3:1", "without a line 'E ='"},
        {"NoVertex", v + "hello\nE =\n", "bad:3:1", "expected a vertex"},
        {"NumberLeftOut", v + "(2:-1)[0:1:1]\nE =\n", "bad:3:2", "expected 1"},
        {"NumberIsHuge", v + "(99999999999999999999:-1)[0:1:1]\nE =\n", "bad:3:2", "too large for a vertex"},
        {"BracketMissing", v + "(1:-1)\nE =\n", "bad:3:7", "expected '['"},
        {"GoalTwice", v + "(1:-1)[0:1:2]\nE =\n", "bad:3:12", "the same twice"},
        {"GoalSet", v + "(1:-1)[0:{1,2}:{1,2}]\nE =\n", "bad:3:10", "a set of goals"},
        {"Capacity", v + "(1:-1:2)[0:1:1]\nE =\n", "bad:3:7", "the capacity is 2"},
        {"Conflicts", v + "(1:-1)[0:1:1]<3>\nE =\n", "bad:3:14", "conflicts"},
        {"RobotTwice", v + "(1:-1)[1:1:1]\nE =\n", "bad:3:8", "robot 1 starts in line 2 too"},
        {"RobotWithoutGoal", v + "E =\n", "bad:2:1", "robot 1 starts here, but ends nowhere"},
        {"RobotWithoutStart", "V =\n(0:-1)[0:1:1]\nE =\n", "bad:2:1", "ends here, but starts nowhere"},
        {"RobotLeftOut", "V =\n(0:-1)[2:2:2]\nE =\n", "bad", "robot 1 is missing"},
        {"RobotIsHuge", "V =\n(0:-1)[999999999999:0:0]\nE =\n", "bad:2:8", "more than the file can hold"},
        {"EdgeOutside", "V =\n(0:-1)[0:0:0]\nE =\n{0,1} (-1)\n", "bad:4:4", "there is no vertex 1"},
        {"EdgeNegative", "V =\n(0:-1)[0:0:0]\nE =\n{-1,0} (-1)\n", "bad:4:2", "there is no vertex -1"},
        {"EdgeCut", "V =\n(0:-1)[0:0:0]\nE =\n{0,\n", "bad:4:4", "expected a whole number"},
        {"TextBehind", "V =\n(0:-1)[0:0:0]\nE =\n{0,0} (-1) x\n", "bad:4:12", "expected the line's end"},
    };
    for (const Refusal &refusal : refusals)
        expectRefusal(refusal, [](const std::string &text, const char *file) { (void)parseCpf(text, file); });
}

RC_GTEST_PROP(Cpf, ComesBackAsItWasWritten, ())
{
    const Instance instance = randomCase(randomGraph()).instance;
    const CpfProblem again = parseCpf(formatCpf(instance), "f");
    RC_ASSERT(again.instance.fingerprint() == instance.fingerprint());
    RC_ASSERT(again.warnings.empty());
}

TEST(SurynekSolution, ReadsMoves)
{
    const SolutionRows rows = parseSurynekSolution("Some words\nFine solution\nLength:3\n1 # 0 ---> 1 (0)\n"
                                                   "1 # 1 ---> 3 (1)\n2 # 2 ---> 1 (5)\n",
                                                   "f");
    ASSERT_EQ(rows.moves.size(), 3);
    EXPECT_EQ(rows.moves[1].robot, 0);
    EXPECT_EQ(rows.moves[1].from, 1);
    EXPECT_EQ(rows.moves[1].to, 3);
    EXPECT_EQ(rows.moves[2].robot, 1);
    EXPECT_EQ(rows.moves[2].step, 2); // nobody moves in the steps 2 to 4
    EXPECT_EQ(rows.lineOf(2), 6);
}

TEST(SurynekSolution, RefusesWhatIsMalformed)
{
    const std::string begin = "Fine solution\nLength:1\n";
    const std::vector<Refusal> refusals = {
        {"Empty", "", "bad:1:1", "without a line 'Fine solution'"},
        {"NoLength", "Fine solution\n", "bad:2:1", "expected a line 'Length:"},
        {"LengthIsAWord", "Fine solution\nLength:x\n", "bad:2:8", "expected a whole number"},
        {"Robot0", begin + "0 # 0 ---> 1 (0)\n", "bad:3:1", "counted from 1"},
        {"Arrow", begin + "1 # 0 -> 1 (0)\n", "bad:3:7", "expected '--->'"},
        {"StepMissing", begin + "1 # 0 ---> 1\n", "bad:3:13", "expected '('"},
        {"StepsDown", begin + "1 # 0 ---> 1 (1)\n1 # 1 ---> 0 (0)\n", "bad:4:15",
         "step 0 comes after step 1"},
        {"TooFewMoves", "Fine solution\nLength:2\n1 # 0 ---> 1 (0)\n", "bad:2:8", "but 1 moves follow"},
    };
    for (const Refusal &refusal : refusals)
        expectRefusal(refusal, [](const std::string &text, const char *file)
                      { (void)parseSurynekSolution(text, file); });
}

RC_GTEST_PROP(SurynekSolution, ComesBackAsItWasWritten, ())
{
    const Case given = randomCase(randomGraph());
    const SolutionRows rows = parseSurynekSolution(formatSurynekSolution(given.schedule), "f");
    RC_ASSERT(scheduleOf(rows, given.instance) == given.schedule);
}

} // namespace
} // namespace mrpp

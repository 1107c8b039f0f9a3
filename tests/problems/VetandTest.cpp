/// XML of vetand's Push and Rotate.

#include "problems/formats/VetandXml.h"

#include "problems/formats/FormatId.h"
#include "tests/problems/FormatCases.h"

#include <tuple>

namespace mrpp
{
namespace
{

using testing::HasSubstr;

/// As the program's own examples are laid out.
std::string instanceText(const std::string &diagonal, const std::string &log = "")
{
    return "<?xml version=\"1.0\"?><root><map><width>3</width><height>2</height><agents>"
           "<agent "
           "id=\"2\"><startx>2</startx><starty>1</starty><finishx>0</finishx><finishy>0</finishy></agent>"
           "<agent "
           "id=\"1\"><startx>0</startx><starty>0</starty><finishx>2</finishx><finishy>0</finishy></agent>"
           "</agents><grid><row>0 0 0</row><row>0 1 0</row></grid>" +
           diagonal + "</map>" + log + "</root>";
}

const std::string kStraight = "<allowdiagonal>false</allowdiagonal><cutcorners>false</cutcorners>"
                              "<allowsqueeze>false</allowsqueeze>";

auto numbersOf(const TimedMove &move)
{
    return std::tuple(move.step, move.robot, move.from, move.to);
}

TEST(Vetand, RobotsAreInTheOrderOfTheirIdsOnCellsOfColumnAndRow)
{
    const VetandInstance read = parseVetandInstance(instanceText(kStraight), "f");
    ASSERT_TRUE(read.map);
    EXPECT_EQ(read.instance.graph->vertexCount(), 5);
    EXPECT_EQ(read.instance.graph->edgeCount(), 4);
    EXPECT_THAT(read.instance.starts, testing::ElementsAre(0, 4));
    EXPECT_THAT(read.instance.goals, testing::ElementsAre(2, 0));
}

TEST(Vetand, DiagonalNeighboursAreJoinedAsTheFileAllows)
{
    const auto edges = [](const std::string &rules)
    { return parseVetandInstance(instanceText(rules), "f").instance.graph->edgeCount(); };
    EXPECT_EQ(edges("<allowdiagonal>true</allowdiagonal>"), 4);
    EXPECT_EQ(edges("<allowdiagonal>true</allowdiagonal><cutcorners>true</cutcorners>"), 6);
    EXPECT_EQ(edges("<cutcorners>true</cutcorners>"), 4);
}

TEST(Vetand, MovementsSayWhereARobotStandsAfterItsStep)
{
    const Instance instance = parseVetandInstance(instanceText(kStraight), "f").instance;
    const std::string answer =
        instanceText(kStraight, "<log><general/><paths><agent id=\"1\"><movement x=\"0\" y=\"1\" step=\"0\"/>"
                                "<movement x=\"0\" y=\"0\" step=\"5\"/></agent><agent id=\"2\">"
                                "<movement x=\"2\" y=\"0\" step=\"2\"/></agent></paths></log>");
    const SolutionRows rows = parseVetandResult(answer, "f", instance);
    ASSERT_EQ(rows.moves.size(), 3U);
    EXPECT_EQ(numbersOf(rows.moves[0]), std::tuple(0, 0, 0, 3));
    EXPECT_EQ(numbersOf(rows.moves[1]), std::tuple(1, 1, 4, 2));
    EXPECT_EQ(numbersOf(rows.moves[2]), std::tuple(2, 0, 3, 0));
}

TEST(Vetand, AnAnswerWithoutALogSaysThatThereIsNoSolution)
{
    const Instance instance = parseVetandInstance(instanceText(kStraight), "f").instance;
    EXPECT_THROW((void)parseVetandResult(instanceText(kStraight), "f", instance), NoSolution);
}

TEST(Vetand, RefusesWhatIsMalformed)
{
    const auto map = [](const std::string &inside) { return "<root>\n<map>" + inside + "</map></root>"; };
    const std::string size = "<width>2</width><height>1</height>";
    const std::vector<Refusal> refusals = {
        {"NoMap", "<root></root>", "bad:1:1", "there is no <map>"},
        {"NoGrid", map(size), "bad:2:1", "there is no <grid>"},
        {"ShortRow", map(size + "<grid><row>0</row></grid>"), "bad:2:46", "the row has 1 cells"},
        {"Rows", map(size + "<grid></grid>"), "bad:2:40", "there are 0 rows"},
        {"Cell", map(size + "<grid><row>0 2</row></grid>"), "bad:2:46", "'2' is no cell"},
        {"Misspelt", map(size + "<gird/>"), "bad:2:40", "did you mean 'grid'"},
        {"Flag", map(size + "<grid><row>0 0</row></grid><cutcorners>maybe</cutcorners>"), "bad:2:67",
         "neither true nor false"},
        {"Obstacle",
         map(size + "<grid><row>0 1</row></grid><agents><agent id='1'><startx>1</startx><starty>0</starty>"
                    "<finishx>0</finishx><finishy>0</finishy></agent></agents>"),
         "bad:2:75", "(1, 0) is an obstacle"},
    };
    for (const Refusal &refusal : refusals)
        expectRefusal(refusal, [](const std::string &text, const char *file)
                      { (void)parseVetandInstance(text, file); });
}

RC_GTEST_PROP(Vetand, ComesBackAsItWasWritten, ())
{
    const Case drawn = randomCase(randomCells());
    const VetandInstance again = parseVetandInstance(formatVetandInstance(drawn.instance), "f");
    RC_ASSERT(again.instance.graph->fingerprint() == drawn.instance.graph->fingerprint());
    RC_ASSERT(again.instance.starts == drawn.instance.starts);
    RC_ASSERT(again.instance.goals == drawn.instance.goals);
    const SolutionRows rows =
        parseVetandResult(formatVetandResult(drawn.instance, drawn.schedule), "f", drawn.instance);
    RC_ASSERT(formatVetandResult(drawn.instance, stepsOf(rows)) ==
              formatVetandResult(drawn.instance, drawn.schedule));
}

TEST(Vetand, DiagonalGraphsComeBack)
{
    const VetandInstance read = parseVetandInstance(
        instanceText("<allowdiagonal>true</allowdiagonal><cutcorners>true</cutcorners>"), "f");
    const VetandInstance again = parseVetandInstance(formatVetandInstance(read.instance), "f");
    EXPECT_EQ(again.instance.graph->fingerprint(), read.instance.graph->fingerprint());
    EXPECT_THROW((void)formatVetandInstance({Graph::fromEdges(3, {{0, 1}, {1, 2}}), {}, {}}), InputError);
}

} // namespace
} // namespace mrpp

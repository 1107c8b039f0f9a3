/// The MAPF tracker's columns are obeyed.

#include "problems/formats/Tracker.h"

#include "problems/formats/MovingAiScenario.h"
#include "tests/problems/FormatCases.h"

namespace mrpp
{
namespace
{

using testing::ElementsAre;
using testing::HasSubstr;

/// From the second of four cells to the third.
Instance row()
{
    return {parseMovingAiMap("type octile\nheight 1\nwidth 4\nmap\n....\n", "row.map").graph, {1}, {2}};
}

const std::string kTwo = "map_name,scen_type,type_id,agents,solution_plan,flip_up_down\n"
                         "row,even,1,1,r,FALSE\nrow,random,1,1,l,FALSE\n";

std::vector<std::int64_t> targets(const SolutionRows &rows)
{
    std::vector<std::int64_t> vertices;
    for (const TimedMove &move : rows.moves)
        vertices.push_back(move.to);
    return vertices;
}

TEST(TrackerColumns, ThePlanOfTheScenarioIsRead)
{
    const auto read = [](const TrackerContext &context)
    { return targets(parseTracker(kTwo, "f", TrackerForm::csv, row(), context)); };
    EXPECT_THAT(read({"row", "even", 1}), ElementsAre(2));
    EXPECT_THAT(read({"row", "random", 1}), ElementsAre(0));
}

TEST(TrackerColumns, WhereTheScenarioIsNotKnownTheOnlyPlanThatSolvesItIsRead)
{
    const SolutionRows rows = parseTracker(kTwo, "f", TrackerForm::csv, row(), {"row"});
    EXPECT_THAT(targets(rows), ElementsAre(2));
    EXPECT_THAT(rows.warnings, ElementsAre(HasSubstr("read was the plan for 'row, even, 1'")));
}

TEST(TrackerColumns, PlansOfOtherMapsAndScenariosAreRefused)
{
    const auto refuse =
        [](const std::string &text, const TrackerContext &context, const char *where, const char *fragment)
    {
        expectRefusal({"Other", text, where, fragment}, [&](const std::string &t, const char *file)
                      { (void)parseTracker(t, file, TrackerForm::csv, row(), context); });
    };
    refuse(kTwo, {"line"}, "bad:2:1", "the instance stands on the map 'line'");
    refuse(kTwo, {"row", "even", 2}, "bad:2:1", "the instance is the scenario 'even 2'");
    refuse("solution_plan\nr\nwr\n", {}, "bad", "none of 1 robot, the instance's number");
    refuse("agents,solution_plan\n1,r\n1,wr\n", {}, "bad:3:1", "a second plan of 1 robot that may be meant");
    refuse("agents,solution_plan\n1,l\n1,ll\n", {}, "bad:3:1", "none of them solves");
}

TEST(TrackerColumns, AFileOfManyMapsHoldsTheInstancesPlan)
{
    const std::string text =
        R"([{"map_name":"other","agents":1,"solution_plan":["l"]},)"
        R"({"map_name":"row","scen_type":"even","type_id":1,"agents":1,"solution_plan":["r"]}])";
    EXPECT_THAT(targets(parseTracker(text, "f", TrackerForm::json, row(), {"row", "even", 1})),
                ElementsAre(2));
}

TEST(TrackerColumns, HeadingsMayStandInQuotationMarks)
{
    const std::string text =
        "\"agents\",\"lower_cost\",\"lower_date\",\"solution_cost\",\"solution_date\",\"path\"\n"
        "\"1\",\"1\",\"2022-11-29\",\"1\",\"2022-11-29\",\"r\"\n";
    EXPECT_THAT(targets(parseTracker(text, "f", TrackerForm::csv, row())), ElementsAre(2));
}

TEST(Scenario, RecordsStandOnOneMap)
{
    EXPECT_EQ(parseMovingAiScenario("version 1\n0 maps/a.map 2 1 0 0 1 0 1\n0 a.map 2 1 1 0 0 0 1\n", "f")
                  .records.size(),
              2U);
    expectRefusal({"TwoMaps", "version 1\n0\ta.map\t2\t1\t0\t0\t1\t0\t1\n0\tb.map\t2\t1\t1\t0\t0\t0\t1\n",
                   "bad:3:3", "this record stands on the map 'b.map', the first record on 'a.map'"},
                  [](const std::string &text, const char *file) { (void)parseMovingAiScenario(text, file); });
}

} // namespace
} // namespace mrpp

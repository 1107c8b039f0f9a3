#include "tests/support/BruteForce.h"
#include "tests/support/RandomCases.h"

#include <gtest/gtest.h>

#include <optional>
#include <ostream>
#include <stdexcept>

namespace mrpp::test
{
namespace
{

struct Known
{
    const char *name;
    std::size_t vertices;
    std::vector<Graph::Edge> edges;
    std::vector<std::pair<Vertex, Vertex>> robots; ///< start, goal
    std::optional<std::uint32_t> pebble;
    std::optional<std::uint32_t> parallel;
    std::optional<std::uint32_t> following;
    std::optional<std::uint32_t> rotation;

    friend std::ostream &operator<<(std::ostream &out, const Known &known) { return out << known.name; }
};

const Known kKnown[] = {
    {"tree", 7, {{0, 1}, {1, 2}, {3, 1}, {4, 3}, {4, 5}, {6, 4}}, {{1, 6}, {4, 1}, {6, 4}}, 12, 8, 6, 6},
    {"tunnel",
     9,
     {{0, 1}, {1, 2}, {2, 3}, {3, 4}, {4, 8}, {4, 5}, {5, 6}, {6, 7}},
     {{0, 3}, {1, 2}, {2, 1}, {4, 0}},
     49,
     27,
     15,
     15},
    {"string",
     11,
     {{0, 3}, {1, 5}, {2, 3}, {2, 8}, {3, 4}, {4, 5}, {4, 9}, {5, 6}, {6, 7}, {6, 10}},
     {{8, 0}, {0, 9}, {9, 1}, {1, 10}, {10, 8}},
     20,
     9,
     8,
     8},
    {"polygon", 6, {{0, 1}, {1, 2}, {2, 3}, {3, 4}, {4, 5}, {5, 0}}, {{0, 5}, {5, 0}}, 6, 5, 5, 5},
    {"loop_chain",
     9,
     {{0, 1}, {0, 3}, {1, 2}, {2, 4}, {3, 5}, {4, 7}, {5, 6}, {6, 7}, {7, 8}},
     {{0, 2}, {3, 4}, {5, 7}, {6, 6}, {7, 5}, {4, 3}, {2, 0}},
     98,
     60,
     18,
     18},
    {"tree_with_cycle_leaves",
     10,
     {{0, 1}, {1, 2}, {2, 0}, {2, 3}, {3, 4}, {4, 5}, {5, 6}, {6, 7}, {7, 8}, {8, 9}, {9, 7}},
     {{1, 2}, {2, 6}, {5, 5}, {8, 9}},
     std::nullopt,
     std::nullopt,
     std::nullopt,
     8},
};

Instance instanceOf(const Known &known)
{
    Instance instance{Graph::fromEdges(known.vertices, known.edges), {}, {}};
    for (const auto &[start, goal] : known.robots)
    {
        instance.starts.push_back(start);
        instance.goals.push_back(goal);
    }
    return instance;
}

class BruteForce : public ::testing::TestWithParam<Known>
{};

TEST_P(BruteForce, FindsTheKnownOptima)
{
    const Instance instance = instanceOf(GetParam());
    EXPECT_EQ(fewestMoves(instance), GetParam().pebble);
    EXPECT_EQ(leastMakespan(instance, MotionRule::parallel), GetParam().parallel);
    EXPECT_EQ(leastMakespan(instance, MotionRule::following), GetParam().following);
    EXPECT_EQ(leastMakespan(instance, MotionRule::rotation), GetParam().rotation);
    EXPECT_EQ(isSolvable(instance, MotionRule::following), GetParam().following.has_value());
    EXPECT_EQ(isSolvable(instance, MotionRule::rotation), GetParam().rotation.has_value());
}

INSTANTIATE_TEST_SUITE_P(SmallProblems, BruteForce, ::testing::ValuesIn(kKnown),
                         [](const auto &known) { return std::string(known.param.name); });

TEST(BruteForceLimits, RefusesWhatIsTooLarge)
{
    const Instance wide{gridGraph(20, 20), {0, 1, 2, 3, 4, 5, 6, 7}, {1, 0, 2, 3, 4, 5, 6, 7}};
    EXPECT_THROW((void)fewestMoves(wide), std::length_error);
    const Instance many{gridGraph(5, 5), {0, 1, 2, 3}, {3, 2, 1, 0}};
    EXPECT_THROW((void)fewestMoves(many, 1000), std::length_error);
}

TEST(BruteForceLimits, NothingToDoTakesNoMoves)
{
    EXPECT_EQ(fewestMoves({gridGraph(2, 2), {}, {}}), 0U);
    EXPECT_EQ(fewestMoves({gridGraph(2, 2), {0, 1, 2, 3}, {0, 1, 2, 3}}), 0U);
}

TEST(BruteForceLimits, AFullGraphMovesByRotationsOnly)
{
    const Instance full{gridGraph(2, 2), {0, 1, 3, 2}, {1, 3, 2, 0}};
    EXPECT_EQ(leastMakespan(full, MotionRule::following), std::nullopt);
    EXPECT_EQ(leastMakespan(full, MotionRule::rotation), 1U);
}

} // namespace
} // namespace mrpp::test

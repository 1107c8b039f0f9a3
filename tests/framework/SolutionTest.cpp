#include "framework/model/Solution.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace mrpp
{
namespace
{

using ::testing::ElementsAre;

constexpr Move kCycle[] = {{0, 0, 1}, {1, 1, 2}, {2, 2, 0}};

std::vector<std::size_t> actionSizes(const Solution &solution)
{
    std::vector<std::size_t> sizes;
    solution.forEachAction([&](std::span<const Move> action) { sizes.push_back(action.size()); });
    return sizes;
}

/// Move, rotation, rotation, move.
Solution mixed()
{
    Solution solution;
    solution.append({3, 3, 4});
    solution.appendRotation(kCycle);
    solution.appendRotation(kCycle);
    solution.append({3, 4, 3});
    return solution;
}

TEST(Solution, CountsARotationAsOneActionOfSeveralMoves)
{
    EXPECT_EQ(mixed().pathLength(), 8U);
    EXPECT_EQ(mixed().actionCount(), 4U);
    EXPECT_THAT(actionSizes(mixed()), ElementsAre(1, 3, 3, 1));
    EXPECT_EQ(Solution().actionCount(), 0U);
    EXPECT_TRUE(Solution().empty());
}

TEST(Solution, ActionsComeInOrder)
{
    std::vector<Move> seen;
    mixed().forEachAction([&](std::span<const Move> action)
                          { seen.insert(seen.end(), action.begin(), action.end()); });
    const Solution solution = mixed();
    EXPECT_EQ(seen, std::vector<Move>(solution.moves().begin(), solution.moves().end()));
}

TEST(Solution, TruncateDropsMovesAndRotationsBehindTheCut)
{
    Solution solution = mixed();
    solution.truncate(4);
    EXPECT_THAT(actionSizes(solution), ElementsAre(1, 3));
    solution.truncate(1);
    EXPECT_THAT(actionSizes(solution), ElementsAre(1));
    solution.append({5, 1, 2});
    EXPECT_THAT(actionSizes(solution), ElementsAre(1, 1));
    solution.clear();
    EXPECT_EQ(solution, Solution());
}

TEST(Solution, IsMadeOfMovesAndRotations)
{
    const Solution solution({{3, 3, 4}, kCycle[0], kCycle[1], kCycle[2]}, {{1, 3}});
    Solution same;
    same.append({3, 3, 4});
    same.appendRotation(kCycle);
    EXPECT_EQ(solution, same);
    EXPECT_NE(solution, Solution({{3, 3, 4}, kCycle[0], kCycle[1], kCycle[2]}));
}

TEST(Solution, GivesItsMovesAway)
{
    Solution solution = mixed();
    const std::vector<Move> moves = std::move(solution).releaseMoves();
    EXPECT_EQ(moves.size(), 8U);
    EXPECT_EQ(moves.front(), (Move{3, 3, 4}));
}

TEST(Solution, FingerprintDependsOnMovesAndRotations)
{
    EXPECT_EQ(Solution({{0, 1, 2}, {1, 0, 1}}).fingerprint(), "56b26a3d9b77c7831719c92fcb65bdb5");
    Solution rotation;
    rotation.appendRotation(kCycle);
    EXPECT_EQ(rotation.fingerprint(), "9b9f52da99fe9bf809618362a9627862");
    EXPECT_NE(Solution({kCycle[0], kCycle[1], kCycle[2]}).fingerprint(), rotation.fingerprint());
}

} // namespace
} // namespace mrpp

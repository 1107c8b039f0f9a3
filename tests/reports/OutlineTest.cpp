#include "framework/geometry/Outline.h"

#include <gtest/gtest.h>

namespace mrpp
{
namespace
{

double areaOf(const std::vector<Point> &corners)
{
    double twice = 0;
    for (std::size_t i = 0; i < corners.size(); ++i)
    {
        const Point &a = corners[i];
        const Point &b = corners[(i + 1) % corners.size()];
        twice += a.x * b.y - b.x * a.y;
    }
    return twice / 2;
}

TEST(Outline, JoinsRowsAndDropsStraightCorners)
{
    const std::vector<Rectangle> rows = {{0, 0, 3, 1}, {0, 1, 3, 2}, {0, 2, 1, 3}};
    const auto outlines = outlinesOf(rows);
    ASSERT_EQ(outlines.size(), 1U);
    EXPECT_EQ(outlines[0].boundary.size(), 6U);
    EXPECT_TRUE(outlines[0].holes.empty());
    EXPECT_EQ(areaOf(outlines[0].boundary), 7);
}

TEST(Outline, KeepsHolesAndIslands)
{
    // A ring of cells around a hole, and an island beside it.
    const std::vector<Rectangle> rows = {
        {0, 0, 3, 1}, {0, 1, 1, 2}, {2, 1, 3, 2}, {0, 2, 3, 3}, {5, 5, 6, 6}};
    const auto outlines = outlinesOf(rows);
    ASSERT_EQ(outlines.size(), 2U);
    double area = 0;
    std::size_t holes = 0;
    for (const Outline &outline : outlines)
    {
        area += areaOf(outline.boundary);
        for (const auto &hole : outline.holes)
        {
            ++holes;
            EXPECT_EQ(hole.size(), 4U);
            area += areaOf(hole); // clockwise: negative
        }
    }
    EXPECT_EQ(holes, 1U);
    EXPECT_EQ(area, 9);
}

TEST(Outline, CornersThatOnlyTouchDoNotJoin)
{
    const std::vector<Rectangle> cells = {{0, 0, 1, 1}, {1, 1, 2, 2}};
    double area = 0;
    for (const Outline &outline : outlinesOf(cells))
        area += areaOf(outline.boundary);
    EXPECT_EQ(area, 2);
    EXPECT_TRUE(outlinesOf({}).empty());
}

} // namespace
} // namespace mrpp

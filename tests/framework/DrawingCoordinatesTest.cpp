#include "framework/model/DrawingCoordinates.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace mrpp
{
namespace
{

std::vector<Point> drawn(std::vector<Point> points)
{
    const std::size_t count = points.size();
    return drawingCoordinates(*Graph::fromEdges(count, {}, std::move(points)));
}

TEST(DrawingCoordinates, OrdinaryOnesStayAsTheyAre)
{
    EXPECT_EQ(drawn({{0.1, -3, 7}, {1e20, 1e-20, 0}}), (std::vector<Point>{{0.1, -3, 0}, {1e20, 1e-20, 0}}));
    EXPECT_EQ(drawn({{5, 5, 0}}), (std::vector<Point>{{5, 5, 0}}));
}

TEST(DrawingCoordinates, FarAndTinyOnesKeepTheirShape)
{
    for (const double unit :
         {1e308, 1e-320, std::numeric_limits<double>::max() / 2, std::numeric_limits<double>::denorm_min()})
    {
        const std::vector<Point> points = drawn({{unit, 0, 0}, {-unit, 0, 0}, {0, unit, 0}});
        const double width = points[0].x - points[1].x;
        EXPECT_GE(width, 1) << unit;
        EXPECT_LT(width, 2) << unit;
        EXPECT_EQ(points[1].x, 0) << unit;
        EXPECT_NEAR(points[2].y - points[0].y, width / 2, 1e-9) << unit;
    }
}

TEST(DrawingCoordinates, OnePlaceFarAwayIsThePlace0)
{
    EXPECT_EQ(drawn({{1e300, -1e300, 0}, {1e300, -1e300, 0}}), (std::vector<Point>{{0, 0, 0}, {0, 0, 0}}));
}

} // namespace
} // namespace mrpp

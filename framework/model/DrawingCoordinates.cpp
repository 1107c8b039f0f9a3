#include "framework/model/DrawingCoordinates.h"

#include <algorithm>
#include <cmath>

namespace mrpp
{

namespace
{

constexpr int kOrdinary = 100; ///< exponent of two

struct Box
{
    double left = 0;
    double right = 0;
    double low = 0;
    double high = 0;

    [[nodiscard]] double extent() const { return std::max(right - left, high - low); }
    [[nodiscard]] double largest() const
    {
        return std::max({std::abs(left), std::abs(right), std::abs(low), std::abs(high)});
    }
};

Box boxOf(const std::vector<Point> &points)
{
    Box box{points.front().x, points.front().x, points.front().y, points.front().y};
    for (const Point &point : points)
    {
        box.left = std::min(box.left, point.x);
        box.right = std::max(box.right, point.x);
        box.low = std::min(box.low, point.y);
        box.high = std::max(box.high, point.y);
    }
    return box;
}

void scaleBy(std::vector<Point> &points, int exponent)
{
    for (Point &point : points)
        point = {std::ldexp(point.x, exponent), std::ldexp(point.y, exponent), 0};
}

} // namespace

std::vector<Point> drawingCoordinates(const Graph &graph)
{
    std::vector<Point> points(graph.coordinates().begin(), graph.coordinates().end());
    if (points.empty())
        return points;
    for (Point &point : points)
        point.z = 0;
    const double largest = boxOf(points).largest();
    const double extent = boxOf(points).extent();
    if (largest < std::ldexp(1.0, kOrdinary) && (extent == 0 || extent > std::ldexp(1.0, -kOrdinary)))
        return points;
    scaleBy(points, -std::ilogb(largest) - 1); // all within 1, so that differences are numbers
    const Box box = boxOf(points);
    for (Point &point : points)
        point = {point.x - box.left, point.y - box.low, 0};
    if (box.extent() > 0)
        scaleBy(points, -std::ilogb(box.extent()));
    return points;
}

} // namespace mrpp

#include "problems/formats/OctileDistances.h"

#include "framework/analysis/Components.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace mrpp
{

OctileDistances::OctileDistances(const GridMap &map)
    : map_(map), width_(static_cast<Cell>(map.width + 2)), free_((map.width + 2) * (map.height + 2), 0),
      labels_(free_.size())
{
    for (Vertex v = 0; v < map.graph->vertexCount(); ++v)
        free_[cellOf(v)] = 1;
}

OctileDistances::Cell OctileDistances::cellOf(Vertex v) const
{
    const auto [x, y] = map_.cellOf(v);
    return static_cast<Cell>((y + 1) * width_ + x + 1);
}

double OctileDistances::distance(Vertex start, Vertex goal)
{
    const Cell target = cellOf(goal);
    search(cellOf(start), target);
    const Label &label = labels_[target];
    return label.stamp == stamp_ ? label.straight + label.diagonal * std::sqrt(2.0) : -1;
}

/// At most what is left from a cell to the target.
OctileDistances::Length OctileDistances::estimate(Cell cell, Cell target) const
{
    const auto gap = [](Cell a, Cell b) { return static_cast<Length>(a < b ? b - a : a - b); };
    const Length dx = gap(cell % width_, target % width_);
    const Length dy = gap(cell / width_, target / width_);
    const Length onOpenMap = std::max(dx, dy) * kStraight + std::min(dx, dy) * (kDiagonal - kStraight);
    if (landmarks_.empty())
        return onOpenMap;
    const Row &a = landmarks_[cell];
    const Row &b = landmarks_[target];
    std::uint32_t most = 1;
    for (std::size_t l = 0; l < kLandmarks; ++l)
        most = std::max(most, a[l] < b[l] ? b[l] - a[l] : a[l] - b[l]);
    return std::max(onOpenMap, (most - 1) * kLandmarkUnit); // one for the rounding
}

/// Labels the target with the best path, or everything that can be reached where there is no target.
void OctileDistances::search(Cell source, Cell target)
{
    if (++stamp_ == 0)
    {
        std::fill(labels_.begin(), labels_.end(), Label{});
        stamp_ = 1;
    }
    for (std::vector<Open> &bucket : buckets_)
        bucket.clear();
    open_ = 0;
    best_ = std::numeric_limits<Length>::max();
    bucket_ = target == kNoCell ? 0 : estimate(source, target) >> kBucketBits;
    reach(source, {0, 0, stamp_}, target);
    for (; open_ > 0; ++bucket_)
    {
        std::vector<Open> &bucket = buckets_[static_cast<std::size_t>(bucket_) % kBuckets];
        while (!bucket.empty())
        {
            // Within a bucket the order is any, and a cell may be visited again on a shorter path; what may
            // still lead to a shorter path to the target is visited.
            const Open last = bucket.back();
            bucket.pop_back();
            --open_;
            if (last.total < best_ && labels_[last.cell].length() == last.length)
                expand(last.cell, target);
        }
    }
}

void OctileDistances::expand(Cell cell, Cell target)
{
    ++visits_;
    const Label here = labels_[cell];
    const Label straight{here.straight + 1, here.diagonal, stamp_};
    const Label diagonal{here.straight, here.diagonal + 1, stamp_};
    for (const Cell side : {cell - 1, cell + 1})
        if (free_[side] != 0)
            reach(side, straight, target);
    for (const Cell row : {cell - width_, cell + width_})
    {
        if (free_[row] == 0)
            continue;
        reach(row, straight, target);
        if (free_[cell - 1] != 0 && free_[row - 1] != 0)
            reach(row - 1, diagonal, target);
        if (free_[cell + 1] != 0 && free_[row + 1] != 0)
            reach(row + 1, diagonal, target);
    }
}

void OctileDistances::reach(Cell cell, const Label &label, Cell target)
{
    const Length length = label.length();
    if (labels_[cell].stamp == stamp_ && labels_[cell].length() <= length)
        return;
    labels_[cell] = label;
    if (cell == target)
    {
        best_ = length;
        return;
    }
    const Length total = target == kNoCell ? length : length + estimate(cell, target);
    if (total >= best_)
        return;
    // Rounded bounds may let the sum fall a little.
    const Length bucket = std::max(bucket_, total >> kBucketBits);
    buckets_[static_cast<std::size_t>(bucket) % kBuckets].push_back({cell, length, total});
    ++open_;
}

void OctileDistances::addLandmarks()
{
    const Components components(*map_.graph);
    if (components.count() == 0)
        return;
    const std::uint64_t visitsBefore = visits_;
    const std::vector<Vertex> vertices = components.vertices(components.largest());
    std::vector<Row> rows(free_.size(), Row{});
    std::vector<Length> nearest(vertices.size(), std::numeric_limits<Length>::max());
    const auto searchFrom = [&](Vertex v)
    {
        search(cellOf(v), kNoCell);
        for (std::size_t i = 0; i < vertices.size(); ++i)
            nearest[i] = std::min(nearest[i], labels_[cellOf(vertices[i])].length());
        return vertices[static_cast<std::size_t>(std::max_element(nearest.begin(), nearest.end()) -
                                                 nearest.begin())];
    };
    Vertex landmark = searchFrom(vertices.front());
    std::fill(nearest.begin(), nearest.end(), std::numeric_limits<Length>::max());
    for (std::size_t l = 0; l < kLandmarks; ++l)
    {
        const Vertex next = searchFrom(landmark);
        for (const Vertex v : vertices)
            rows[cellOf(v)][l] = static_cast<std::uint32_t>(labels_[cellOf(v)].length() / kLandmarkUnit);
        landmark = next;
    }
    landmarks_ = std::move(rows);
    visits_ = visitsBefore;
}

std::vector<double> octileDistances(const GridMap &map, const Instance &instance,
                                    const Supervision &supervision)
{
    // So many robots tell whether landmarks, which cost as much as visiting every cell so often, are worth
    // it.
    constexpr std::size_t kSample = 32;
    constexpr std::size_t kLandmarksCost = 16;
    const std::size_t robots = instance.robotCount();
    std::vector<double> lengths(robots, 0);
    OctileDistances distances(map);
    for (std::size_t r = 0; r < robots && !supervision.mustStop("lengths of paths", r, robots); ++r)
    {
        if (r == kSample && distances.visits() / kSample * robots > kLandmarksCost * map.cells.size())
            distances.addLandmarks();
        lengths[r] = std::max(0.0, distances.distance(instance.starts[r], instance.goals[r]));
    }
    return lengths;
}

} // namespace mrpp

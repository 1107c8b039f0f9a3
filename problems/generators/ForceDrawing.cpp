#include "problems/generators/ForceDrawing.h"

#include "framework/support/Random.h"
#include "problems/generators/Drawing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <tuple>

namespace mrpp
{

namespace
{

/// A graph whose vertices are clusters of a finer one.
struct Coarser
{
    std::shared_ptr<const Graph> graph;
    std::vector<Vertex> cluster; ///< by vertex of the finer graph
};

/// Every vertex, in random order, that is in no cluster yet takes its neighbours that are in none along; one
/// that has no such neighbour joins the cluster of one. No cluster is a single vertex.
Coarser coarsen(const Graph &graph, Random &random)
{
    std::vector<Vertex> order(graph.vertexCount());
    std::iota(order.begin(), order.end(), 0);
    random.shuffle(std::span(order));
    Coarser coarser{nullptr, std::vector<Vertex>(graph.vertexCount(), kNoVertex)};
    std::vector<Vertex> &cluster = coarser.cluster;
    Vertex clusters = 0;
    for (const Vertex v : order)
    {
        if (cluster[v] != kNoVertex)
            continue;
        bool alone = true;
        for (const Vertex u : graph.neighbors(v))
            if (cluster[u] == kNoVertex)
            {
                cluster[u] = clusters;
                alone = false;
            }
        cluster[v] = alone ? cluster[graph.neighbors(v).front()] : clusters;
        clusters += alone ? 0 : 1;
    }
    std::vector<Graph::Edge> edges;
    for (Vertex v = 0; v < graph.vertexCount(); ++v)
        for (const Vertex u : graph.neighbors(v))
            if (cluster[v] < cluster[u])
                edges.push_back({cluster[v], cluster[u]});
    coarser.graph = Graph::fromEdges(clusters, edges);
    return coarser;
}

struct Place
{
    double x = 0;
    double y = 0;
};

double meanEdgeLength(const Graph &graph, const std::vector<Place> &places)
{
    double sum = 0;
    for (Vertex v = 0; v < graph.vertexCount(); ++v)
        for (const Vertex u : graph.neighbors(v))
            sum += std::sqrt((places[u].x - places[v].x) * (places[u].x - places[v].x) +
                             (places[u].y - places[v].y) * (places[u].y - places[v].y));
    return graph.edgeCount() == 0 ? 1 : sum / (2 * static_cast<double>(graph.edgeCount()));
}

/// Every vertex around the place of its cluster, spread out until edges have a mean length of about one.
std::vector<Place> placeClusters(const Graph &graph, const Coarser &coarser, const std::vector<Place> &coarse,
                                 Random &random)
{
    std::vector<Place> places(graph.vertexCount());
    for (Vertex v = 0; v < graph.vertexCount(); ++v)
        places[v] = coarse[coarser.cluster[v]];
    const double growth =
        std::sqrt(static_cast<double>(graph.vertexCount()) / static_cast<double>(coarse.size()));
    const double length = meanEdgeLength(graph, places);
    const double scale = length > 0 ? std::max(growth, 1 / length) : 1;
    for (Place &place : places)
        place = {place.x * scale + random.uniform() - 0.5, place.y * scale + random.uniform() - 0.5};
    return places;
}

struct Box
{
    Place least;
    Place most;

    explicit Box(const std::vector<Place> &places) : least(places.front()), most(places.front())
    {
        for (const Place &place : places)
        {
            least = {std::min(least.x, place.x), std::min(least.y, place.y)};
            most = {std::max(most.x, place.x), std::max(most.y, place.y)};
        }
    }
    [[nodiscard]] double width() const { return most.x - least.x; }
    [[nodiscard]] double height() const { return most.y - least.y; }
};

/// How far apart the vertices would be if they filled their box evenly.
double meanGap(const std::vector<Place> &places)
{
    const Box box(places);
    return std::sqrt(box.width() * box.height() / static_cast<double>(places.size()));
}

/// Vertices sorted into cells, so that only those of neighbouring cells are looked at.
class Cells
{
public:
    /// \param side how far a vertex may be from another that it is to meet
    Cells(const std::vector<Place> &places, double side) : order_(places.size()), sorted_(places.size())
    {
        const Box box(places);
        side = std::max(side, meanGap(places));
        columns_ = static_cast<std::size_t>(box.width() / side) + 1;
        rows_ = static_cast<std::size_t>(box.height() / side) + 1;
        first_.assign(columns_ * rows_ + 1, 0);
        const auto cellOf = [&](const Place &place)
        {
            return static_cast<std::size_t>((place.y - box.least.y) / side) * columns_ +
                   static_cast<std::size_t>((place.x - box.least.x) / side);
        };
        for (const Place &place : places)
            ++first_[cellOf(place) + 1];
        std::partial_sum(first_.begin(), first_.end(), first_.begin());
        std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
        for (Vertex v = 0; v < places.size(); ++v)
        {
            const std::uint32_t i = next[cellOf(places[v])]++;
            order_[i] = v;
            sorted_[i] = places[v];
        }
    }

    /// Adds, for every two vertices up to `reach` apart, factor(squared distance) times their difference to
    /// the one's force, and takes it from the other's. \pre reach is at most the side of the cells
    template <class Factor>
    void repel(double reach, std::vector<Place> &forces, Factor factor) const
    {
        std::vector<Place> sortedForces(sorted_.size());
        const auto meet = [&](std::uint32_t i, std::uint32_t begin, std::uint32_t end)
        {
            for (std::uint32_t j = begin; j < end; ++j)
            {
                const double x = sorted_[i].x - sorted_[j].x;
                const double y = sorted_[i].y - sorted_[j].y;
                const double squared = x * x + y * y;
                if (squared > reach * reach)
                    continue;
                const double strength = factor(squared);
                sortedForces[i].x += x * strength;
                sortedForces[i].y += y * strength;
                sortedForces[j].x -= x * strength;
                sortedForces[j].y -= y * strength;
            }
        };
        for (std::size_t cell = 0; cell < columns_ * rows_; ++cell)
        {
            // The cell to the right, and the three in the row below, lie side by side in the order.
            const std::size_t left = cell % columns_ > 0 ? 1 : 0;
            const std::size_t right = (cell + 1) % columns_ > 0 ? 1 : 0;
            const std::size_t below = cell + columns_;
            for (std::uint32_t i = first_[cell]; i < first_[cell + 1]; ++i)
            {
                meet(i, i + 1, first_[cell + right + 1]);
                if (below < columns_ * rows_)
                    meet(i, first_[below - left], first_[below + right + 1]);
            }
        }
        for (std::size_t i = 0; i < order_.size(); ++i)
        {
            forces[order_[i]].x += sortedForces[i].x;
            forces[order_[i]].y += sortedForces[i].y;
        }
    }

private:
    std::size_t columns_ = 1;
    std::size_t rows_ = 1;
    std::vector<std::uint32_t> first_; ///< of each cell, in order_
    std::vector<Vertex> order_;        ///< vertices by cell
    std::vector<Place> sorted_;        ///< beside order_
};

/// Repulsion over long ways, from a mesh: what the vertices around each of its points do to all points is
/// interpolated between them.
void repelFar(const std::vector<Place> &places, std::vector<Place> &forces)
{
    constexpr std::size_t kMesh = 16; ///< points in a row
    const Box box(places);
    const double side = std::max(box.width(), box.height()) / (kMesh - 1) + 1e-9;
    // The point up and left of a place, and how far behind it the place lies, in sides.
    struct Spot
    {
        std::size_t point;
        double x;
        double y;
    };
    const auto spotOf = [&](const Place &place)
    {
        const double x = (place.x - box.least.x) / side;
        const double y = (place.y - box.least.y) / side;
        const double column = std::min(std::floor(x), kMesh - 2.0);
        const double row = std::min(std::floor(y), kMesh - 2.0);
        return Spot{static_cast<std::size_t>(row) * kMesh + static_cast<std::size_t>(column), x - column,
                    y - row};
    };
    constexpr std::array<std::size_t, 4> kCorners = {0, 1, kMesh, kMesh + 1};
    const auto sharesOf = [](const Spot &spot)
    {
        return std::array{(1 - spot.x) * (1 - spot.y), spot.x * (1 - spot.y), (1 - spot.x) * spot.y,
                          spot.x * spot.y};
    };

    std::array<double, kMesh * kMesh> mass{};
    for (const Place &place : places)
    {
        const Spot spot = spotOf(place);
        const auto shares = sharesOf(spot);
        for (std::size_t corner = 0; corner < shares.size(); ++corner)
            mass[spot.point + kCorners[corner]] += shares[corner];
    }
    const auto columnOf = [](std::size_t point) { return static_cast<double>(point % kMesh); };
    const auto rowOf = [](std::size_t point)
    {
        const std::size_t row = point / kMesh;
        return static_cast<double>(row);
    };
    std::array<Place, kMesh * kMesh> field{};
    for (std::size_t p = 0; p < field.size(); ++p)
        for (std::size_t q = 0; q < field.size(); ++q)
        {
            const double x = columnOf(p) - columnOf(q);
            const double y = rowOf(p) - rowOf(q);
            const double strength = mass[q] / ((x * x + y * y + 1) * side);
            field[p].x += x * strength;
            field[p].y += y * strength;
        }
    for (std::size_t v = 0; v < places.size(); ++v)
    {
        const Spot spot = spotOf(places[v]);
        const auto shares = sharesOf(spot);
        for (std::size_t corner = 0; corner < shares.size(); ++corner)
        {
            forces[v].x += field[spot.point + kCorners[corner]].x * shares[corner];
            forces[v].y += field[spot.point + kCorners[corner]].y * shares[corner];
        }
    }
}

/// The force grows with the square of an edge's length, which keeps bridges short, but in proportion beyond
/// kStiffest: without that, graphs that cannot be spread out would be pulled into a point.
void attract(const Graph &graph, const std::vector<Place> &places, std::vector<Place> &forces)
{
    constexpr double kStiffest = 4;
    for (Vertex v = 0; v < graph.vertexCount(); ++v)
        for (const Vertex u : graph.neighbors(v))
        {
            const double x = places[u].x - places[v].x;
            const double y = places[u].y - places[v].y;
            const double strength = std::min(kStiffest, std::sqrt(x * x + y * y));
            forces[v].x += x * strength;
            forces[v].y += y * strength;
        }
}

/// Moves every vertex along the force on it, at most by `farthest`.
void follow(const std::vector<Place> &forces, double farthest, std::vector<Place> &places)
{
    for (std::size_t v = 0; v < places.size(); ++v)
    {
        const double length = std::sqrt(forces[v].x * forces[v].x + forces[v].y * forces[v].y);
        const double factor = length > farthest ? farthest / length : 1;
        places[v].x += forces[v].x * factor;
        places[v].y += forces[v].y * factor;
    }
}

/// How often the places of so many vertices are improved.
std::size_t iterations(std::size_t vertices)
{
    const double rounds = 100 * std::sqrt(std::min(1.0, 1000 / static_cast<double>(vertices)));
    return static_cast<std::size_t>(std::ceil(rounds));
}

/// Springs against repulsion: over all ways that matter in small graphs, in large ones over short ways and by
/// the mesh.
void relax(const Graph &graph, std::vector<Place> &places)
{
    constexpr std::size_t kExact = 150; // vertices
    constexpr double kFar = 6;
    constexpr double kNear = 2;
    const bool exact = places.size() <= kExact;
    const std::size_t rounds = iterations(places.size());
    std::vector<Place> forces;
    for (std::size_t i = 0; i < rounds; ++i)
    {
        forces.assign(places.size(), {});
        attract(graph, places, forces);
        const double reach = exact ? kFar : std::min(kNear, 1.5 * meanGap(places));
        Cells(places, reach).repel(reach, forces, [](double squared) { return 1 / (squared + 1e-6); });
        if (!exact)
            repelFar(places, forces);
        follow(forces, 1 - static_cast<double>(i) / static_cast<double>(rounds), places);
    }
}

/// Pushes apart what would overlap, were vertices drawn as circles.
void separate(const Graph &graph, std::vector<Place> &places)
{
    const double gap = std::min(1.0, 0.65 * meanEdgeLength(graph, places)); // in dense graphs no more than 1
    std::vector<Place> forces;
    const std::size_t rounds = (iterations(places.size()) + 2) / 3;
    for (std::size_t i = 0; i < rounds; ++i)
    {
        forces.assign(places.size(), {});
        Cells(places, gap)
            .repel(gap, forces,
                   [gap](double squared) { return 0.4 * (gap / std::sqrt(squared + 1e-9) - 1); });
        follow(forces, gap, places);
    }
}

std::vector<Place> drawing(const Graph &graph, Random &random)
{
    if (graph.vertexCount() == 1)
        return {Place{}};
    const Coarser coarser = coarsen(graph, random);
    auto places = placeClusters(graph, coarser, drawing(*coarser.graph, random), random);
    relax(graph, places);
    return places;
}

/// Moves points that lie on others a little to the right.
void makeDistinct(std::vector<Point> &points)
{
    constexpr double kLittle = 0.001;
    std::vector<Vertex> order(points.size());
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(),
              [&](Vertex a, Vertex b)
              { return std::tie(points[a].y, points[a].x, a) < std::tie(points[b].y, points[b].x, b); });
    for (std::size_t i = 1; i < order.size(); ++i)
    {
        const Point &before = points[order[i - 1]];
        Point &point = points[order[i]];
        if (point.y == before.y && point.x <= before.x)
            point = drawnPoint(before.x + kLittle, point.y);
    }
}

} // namespace

std::vector<Point> forceDrawing(const Graph &graph)
{
    if (graph.vertexCount() == 0)
        return {};
    Random random(graph.vertexCount());
    auto places = drawing(graph, random);
    separate(graph, places);
    const double unit = meanEdgeLength(graph, places);
    std::vector<Point> points;
    points.reserve(places.size());
    for (const Place &place : places)
        points.push_back(drawnPoint(place.x / unit, place.y / unit));
    makeDistinct(points);
    return points;
}

} // namespace mrpp

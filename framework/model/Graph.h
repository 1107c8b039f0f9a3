#pragma once
/// \file
/// The environment: an immutable undirected graph on whose vertices the robots stand.
///
/// Compressed sparse rows: the neighbours of all vertices lie in one array, so that a search touches memory
/// in order. No loops, no parallel edges, neighbours sorted by id. Built once, shared by every planner
/// (`std::shared_ptr<const Graph>`), read by many threads at once.
///
/// \code
/// const auto graph = Graph::fromEdges(3, {{0, 1}, {1, 2}});
/// for (Vertex v : graph->neighbors(1))
///     …
/// \endcode
///
/// For algorithms of Boost.Graph include BglAdaptor.h: a Graph is one of its graphs.

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace mrpp
{

using Vertex = std::uint32_t; ///< 0 … vertexCount()−1
using Robot = std::uint32_t;  ///< 0 … robotCount()−1

inline constexpr Vertex kNoVertex = static_cast<Vertex>(-1);
inline constexpr Robot kNoRobot = static_cast<Robot>(-1);

/// A vertex's place in a drawing; no unit, neighbours usually lie one apart.
struct Point
{
    double x = 0;
    double y = 0;
    double z = 0;

    friend bool operator==(const Point &, const Point &) = default;
};

/// Where y grows to, for drawings: mathematics draws it upwards, maps of cells downwards.
enum class YAxis
{
    up,
    down
};

class Graph
{
public:
    struct Edge
    {
        Vertex a = 0;
        Vertex b = 0;
        double weight = 1; ///< kept as an attribute; one move takes one unit of time whatever the weight
    };

    Graph() = default;

    /// Builds a graph. Loops are dropped, and of parallel edges the first is kept.
    /// \param coordinates one a vertex, or none
    /// \pre every end of an edge is below vertexCount (readers check their input and report it)
    /// O(V + E log degree).
    [[nodiscard]] static std::shared_ptr<const Graph> fromEdges(std::size_t vertexCount,
                                                                std::span<const Edge> edges,
                                                                std::vector<Point> coordinates = {},
                                                                YAxis yAxis = YAxis::up);
    [[nodiscard]] static std::shared_ptr<const Graph>
    fromEdges(std::size_t vertexCount, std::initializer_list<std::pair<Vertex, Vertex>> edges);

    [[nodiscard]] std::size_t vertexCount() const { return offsets_.size() - 1; }
    [[nodiscard]] std::size_t edgeCount() const { return neighbors_.size() / 2; }

    /// The vertices next to v, ascending.
    [[nodiscard]] std::span<const Vertex> neighbors(Vertex v) const
    {
        return {neighbors_.data() + offsets_[v], neighbors_.data() + offsets_[v + 1]};
    }
    [[nodiscard]] std::size_t degree(Vertex v) const { return offsets_[v + 1] - offsets_[v]; }

    /// O(log degree).
    [[nodiscard]] bool hasEdge(Vertex a, Vertex b) const { return arc(a, b).has_value(); }

    /// The position of the arc a→b among all arcs (0 … 2E−1, ordered by source, then target), if there is
    /// one. O(log degree).
    [[nodiscard]] std::optional<std::size_t> arc(Vertex a, Vertex b) const;

    /// The weight of an existing edge; 1 unless the file says otherwise. O(log degree).
    [[nodiscard]] double weight(Vertex a, Vertex b) const;

    /// True when some edge has a weight other than 1.
    [[nodiscard]] bool isWeighted() const { return !weights_.empty(); }

    /// Every edge once, with a < b, ordered by a, then b. O(V + E).
    [[nodiscard]] std::vector<Edge> edges() const;

    [[nodiscard]] bool hasCoordinates() const { return !coordinates_.empty(); }
    [[nodiscard]] const Point &coordinate(Vertex v) const { return coordinates_[v]; }
    [[nodiscard]] std::span<const Point> coordinates() const { return coordinates_; }
    [[nodiscard]] YAxis yAxis() const { return yAxis_; }

    /// Depends on vertices, edges and weights, not on coordinates. O(V + E).
    [[nodiscard]] std::string fingerprint() const;

private:
    std::vector<std::uint32_t> offsets_ = {0}; ///< size V+1
    std::vector<Vertex> neighbors_;            ///< size 2E
    std::vector<double> weights_;              ///< beside neighbors_, or empty where all are 1
    std::vector<Point> coordinates_;           ///< size V, or empty
    YAxis yAxis_ = YAxis::up;
};

} // namespace mrpp

#pragma once
/// \file
/// Connected components.

#include "framework/model/Graph.h"

#include <cstdint>
#include <vector>

namespace mrpp
{

/// Components are numbered by their smallest vertex. Building takes O(V + E).
class Components
{
public:
    explicit Components(const Graph &graph);

    [[nodiscard]] std::size_t count() const { return sizes_.size(); }
    [[nodiscard]] std::uint32_t of(Vertex v) const { return component_[v]; }
    [[nodiscard]] std::size_t size(std::uint32_t component) const { return sizes_[component]; }

    /// The first of the components with the most vertices; 0 on an empty graph.
    [[nodiscard]] std::uint32_t largest() const;

    /// Its vertices, ascending. O(V).
    [[nodiscard]] std::vector<Vertex> vertices(std::uint32_t component) const;

private:
    std::vector<std::uint32_t> component_; ///< size V
    std::vector<std::size_t> sizes_;       ///< size count()
};

/// On a path the robots keep their order whatever they do, on a polygon their cyclic order.
enum class ComponentShape
{
    path,      ///< a tree without a vertex of degree three or more; also a single vertex
    polygon,   ///< one cycle and nothing else
    branching, ///< has a vertex of degree three or more
};

/// The shape of each component. O(V).
[[nodiscard]] std::vector<ComponentShape> componentShapes(const Graph &graph, const Components &components);

} // namespace mrpp

#pragma once
/// \file
/// Blocks, cut vertices and 2-edge-connected components: what decides which robots can change places.
///
/// A *block* is a maximal biconnected subgraph: a single edge (a bridge), a cycle, or something richer. Two
/// blocks share at most one vertex, a *cut vertex*. Taking away all bridges leaves the *2-edge-connected
/// components*; those of three or more vertices are the unions of blocks with cycles that share cut vertices.
///
/// \code
/// const Blocks blocks(graph);
/// for (std::uint32_t block : blocks.of(v))
///     if (!blocks.isEdge(block) && blocks.isBipartite(block))
///         use(blocks.vertices(block));
/// \endcode
///
/// By one depth-first search (Hopcroft and Tarjan, Algorithm 447, 1973), which is iterative and whose tree
/// stays available: the vertices below a tree edge are a range of preorder(). Any graph, also of several
/// components; a vertex without edges is in no block. Building takes O(V + E), holding some 60 bytes a vertex
/// and 8 an edge.

#include "framework/model/Graph.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace mrpp
{

class Blocks
{
public:
    struct Edge
    {
        Vertex a = 0; ///< the nearer one to the root of the search
        Vertex b = 0;

        friend bool operator==(const Edge &, const Edge &) = default;
    };

    explicit Blocks(const Graph &graph);

    /// Blocks are numbered from the leaves of the search tree to its roots: what hangs below a block has
    /// smaller numbers.
    [[nodiscard]] std::size_t count() const { return tops_.size(); }

    /// Ascending.
    [[nodiscard]] std::span<const Vertex> vertices(std::uint32_t block) const
    {
        return range(vertices_, vertexOffsets_, block);
    }
    [[nodiscard]] std::span<const Edge> edges(std::uint32_t block) const
    {
        return range(edges_, edgeOffsets_, block);
    }
    /// The blocks that hold a vertex, ascending.
    [[nodiscard]] std::span<const std::uint32_t> of(Vertex v) const
    {
        return range(blocksOf_, blocksOfOffsets_, v);
    }
    /// The block of an existing edge. O(1).
    [[nodiscard]] std::uint32_t ofEdge(Vertex a, Vertex b) const
    {
        return parentBlock_[position_[a] < position_[b] ? b : a];
    }
    static constexpr std::uint32_t kNoBlock = static_cast<std::uint32_t>(-1);
    /// The block of v in which the root of the search is, or to which it leads; kNoBlock at a root. O(1).
    [[nodiscard]] std::uint32_t towardsRoot(Vertex v) const { return parentBlock_[v]; }
    /// The block's vertex that is nearest to the root of the search.
    [[nodiscard]] Vertex top(std::uint32_t block) const { return tops_[block]; }

    [[nodiscard]] bool isEdge(std::uint32_t block) const { return vertices(block).size() == 2; }
    /// A simple cycle of three or more vertices.
    [[nodiscard]] bool isCycle(std::uint32_t block) const
    {
        return !isEdge(block) && edges(block).size() == vertices(block).size();
    }
    [[nodiscard]] bool isBipartite(std::uint32_t block) const { return bipartite_[block] != 0; }

    /// Whether taking v away separates some of its neighbours from others.
    [[nodiscard]] bool isCutVertex(Vertex v) const { return of(v).size() > 1; }
    /// Whether an existing edge is one.
    [[nodiscard]] bool isBridge(Vertex a, Vertex b) const { return isEdge(ofEdge(a, b)); }

    /// 2-edge-connected components, single vertices among them, are numbered by their smallest vertex.
    [[nodiscard]] std::size_t twoEdgeCount() const { return twoEdgeSizes_.size(); }
    [[nodiscard]] std::uint32_t twoEdgeOf(Vertex v) const { return twoEdge_[v]; }
    [[nodiscard]] std::size_t twoEdgeSize(std::uint32_t component) const { return twoEdgeSizes_[component]; }
    /// Whether v lies on a cycle or between cycles without bridges.
    [[nodiscard]] bool inTwoEdgeComponent(Vertex v) const { return twoEdgeSizes_[twoEdge_[v]] > 1; }

    /// The vertices in the order in which the search met them: each component is a range, and so is each
    /// subtree.
    [[nodiscard]] std::span<const Vertex> preorder() const { return preorder_; }
    [[nodiscard]] std::size_t position(Vertex v) const { return position_[v]; } ///< of v in preorder()
    [[nodiscard]] std::size_t subtreeSize(Vertex v) const { return subtreeSize_[v]; }
    [[nodiscard]] Vertex parent(Vertex v) const { return parent_[v]; } ///< kNoVertex at a root
    /// The root of the search in the component of v: its smallest vertex.
    [[nodiscard]] Vertex root(Vertex v) const { return root_[v]; }

private:
    template <class T>
    static std::span<const T> range(const std::vector<T> &items, const std::vector<std::uint32_t> &offsets,
                                    std::size_t i)
    {
        return {items.data() + offsets[i], items.data() + offsets[i + 1]};
    }
    void search(const Graph &graph);
    void collectVertices();
    void collectEdges(const Graph &graph);
    void findTwoEdgeComponents();

    std::vector<Vertex> preorder_;
    std::vector<std::uint32_t> position_;
    std::vector<std::uint32_t> subtreeSize_;
    std::vector<Vertex> parent_;
    std::vector<Vertex> root_;
    std::vector<std::uint32_t> parentBlock_; ///< see towardsRoot()
    std::vector<Vertex> tops_;               ///< size count()
    std::vector<std::uint32_t> vertexOffsets_;
    std::vector<Vertex> vertices_;
    std::vector<std::uint32_t> edgeOffsets_;
    std::vector<Edge> edges_;
    std::vector<std::uint32_t> blocksOfOffsets_;
    std::vector<std::uint32_t> blocksOf_;
    std::vector<std::uint8_t> bipartite_;
    std::vector<std::uint32_t> twoEdge_;
    std::vector<std::uint32_t> twoEdgeSizes_;
};

} // namespace mrpp

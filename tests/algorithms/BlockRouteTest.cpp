#include "algorithms/search/BlockRoute.h"
#include "tests/support/RandomCases.h"

#include <gtest/gtest.h>
#include <vector>

namespace mrpp
{
namespace
{

/// Vertices on simple paths from a to b, by trying them all.
class SimplePaths
{
public:
    SimplePaths(const Graph &graph, Vertex from, Vertex to)
        : graph_(graph), to_(to), onPath_(graph.vertexCount(), 0), found(graph.vertexCount(), 0)
    {
        extend(from);
    }

private:
    bool extend(Vertex v)
    {
        onPath_[v] = 1;
        bool arrives = v == to_;
        if (v != to_)
            for (const Vertex w : graph_.neighbors(v))
                if (onPath_[w] == 0 && extend(w))
                    arrives = true;
        onPath_[v] = 0;
        found[v] |= arrives ? 1 : 0;
        return arrives;
    }

    const Graph &graph_;
    Vertex to_;
    std::vector<char> onPath_;

public:
    std::vector<char> found; ///< nonzero for those vertices
};

TEST(BlockRoute, HasTheVerticesOfAllSimplePathsAndNoOther)
{
    for (Seed seed = 1; seed <= 60; ++seed)
    {
        Random random(seed);
        const std::size_t vertices = 1 + random.below(12);
        const auto graph = test::randomConnectedGraph(vertices, random.below(5), seed);
        const Blocks blocks(*graph);
        BlockRoute route(blocks);
        for (Vertex from = 0; from < vertices; ++from)
        {
            for (Vertex to = 0; to < vertices; ++to)
            {
                const SimplePaths paths(*graph, from, to);
                route.lead(from, to);
                for (Vertex v = 0; v < vertices; ++v)
                    ASSERT_EQ(route.has(v), paths.found[v] != 0)
                        << "seed " << seed << ": " << v << " between " << from << " and " << to;
            }
        }
    }
}

TEST(BlockRoute, IsWorthwhileOnTreesAndNotOnGrids)
{
    EXPECT_TRUE(BlockRoute::isWorthwhile(Blocks(*test::randomConnectedGraph(100, 0, 1))));
    EXPECT_FALSE(BlockRoute::isWorthwhile(Blocks(*test::gridGraph(10, 10))));
}

} // namespace
} // namespace mrpp

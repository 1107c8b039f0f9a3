#include "problems/generators/Roadmap.h"
#include "framework/geometry/Delaunay.h"
#include "tests/problems/Generated.h"
#include "tests/support/CpuClock.h"

#include <gtest/gtest.h>

#include <set>

namespace mrpp::test
{
namespace
{

/// Twice the area of a triangle, above 0 where it turns left; exact for the thousandths of these tests.
std::int64_t turn(const Point &a, const Point &b, const Point &c)
{
    const auto whole = [](double x) { return static_cast<std::int64_t>(x * 1000 + (x < 0 ? -0.5 : 0.5)); };
    return (whole(b.x) - whole(a.x)) * (whole(c.y) - whole(a.y)) -
           (whole(b.y) - whole(a.y)) * (whole(c.x) - whole(a.x));
}

/// Whether two edges without a common end cross as straight lines.
bool crosses(const Graph &graph, const Graph::Edge &e, const Graph::Edge &f)
{
    if (e.a == f.a || e.a == f.b || e.b == f.a || e.b == f.b)
        return false;
    const auto at = [&](Vertex v) -> const Point & { return graph.coordinate(v); };
    const auto apart = [](std::int64_t x, std::int64_t y) { return (x > 0) != (y > 0); };
    return apart(turn(at(e.a), at(e.b), at(f.a)), turn(at(e.a), at(e.b), at(f.b))) &&
           apart(turn(at(f.a), at(f.b), at(e.a)), turn(at(f.a), at(f.b), at(e.b)));
}

TEST(Delaunay, TriangulatesPoints)
{
    const std::vector<Point> square = {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {1, 1, 0}};
    std::vector<std::pair<Vertex, Vertex>> edges;
    for (const Graph::Edge &edge : delaunayEdges(square))
        edges.emplace_back(edge.a, edge.b);
    EXPECT_EQ(edges, (std::vector<std::pair<Vertex, Vertex>>{
                         {0, 1}, {0, 3}, {0, 4}, {1, 2}, {1, 4}, {2, 3}, {2, 4}, {3, 4}}));
    EXPECT_EQ(delaunayEdges(std::vector<Point>{{0, 0, 0}, {1, 1, 0}, {2, 2, 0}}).size(), 2U) << "on one line";
    EXPECT_TRUE(delaunayEdges({}).empty());
    EXPECT_TRUE(delaunayEdges(std::vector<Point>{{1, 2, 0}}).empty());
}

TEST(RoadmapGenerator, IsConnectedAndPlanarWithItsMeanDegree)
{
    for (const auto &[degree, edges] :
         std::vector<std::pair<const char *, std::size_t>>{{"0", 99}, {"2", 100}, {"3", 150}, {"4.5", 225}})
        for (Seed seed = 0; seed < 500; ++seed)
        {
            const auto graph = make<Roadmap>({{"vertices", "100"}, {"mean_degree", degree}})->makeGraph(seed);
            ASSERT_EQ(graph->vertexCount(), 100U);
            ASSERT_EQ(graph->edgeCount(), edges);
            ASSERT_TRUE(isConnected(*graph)) << degree << ", seed " << seed;
            ASSERT_TRUE(isPlanar(*graph)) << degree << ", seed " << seed;
        }
    for (const char *few : {"1", "2", "3", "4"})
        for (Seed seed = 0; seed < 50; ++seed)
            ASSERT_TRUE(isConnected(*make<Roadmap>({{"vertices", few}})->makeGraph(seed))) << few;
}

TEST(RoadmapGenerator, IsConnectedAndPlanarForTenThousandSeeds)
{
    const auto roadmap = make<Roadmap>({{"vertices", "20"}, {"mean_degree", "4"}});
    for (Seed seed = 0; seed < 10'000; ++seed)
    {
        const auto graph = roadmap->makeGraph(seed);
        ASSERT_EQ(graph->vertexCount(), 20U);
        ASSERT_EQ(graph->edgeCount(), 40U);
        ASSERT_TRUE(isConnected(*graph) && isPlanar(*graph)) << "seed " << seed;
    }
}

TEST(RoadmapGenerator, IsDrawnWithoutCrossings)
{
    for (Seed seed = 0; seed < 20; ++seed)
    {
        const auto graph = make<Roadmap>({{"vertices", "60"}, {"mean_degree", "6"}})->makeGraph(seed);
        const auto edges = graph->edges();
        for (std::size_t i = 0; i < edges.size(); ++i)
            for (std::size_t j = i + 1; j < edges.size(); ++j)
                ASSERT_FALSE(crosses(*graph, edges[i], edges[j])) << "seed " << seed;
    }
}

TEST(RoadmapGenerator, MakesTheSameGraphOnEveryMachine)
{
    EXPECT_EQ(make<Roadmap>({{"vertices", "50"}})->makeGraph(1)->fingerprint(),
              "ec49518bb0e099af8fe05edc1bd81b76");
}

TEST(RoadmapGenerator, MakesAMillionVerticesInSeconds)
{
    const double before = cpuSeconds();
    EXPECT_EQ(make<Roadmap>({{"vertices", "1000000"}})->makeGraph(1)->edgeCount(), 1'500'000U);
    EXPECT_LT(cpuSeconds() - before, 30);
}

} // namespace
} // namespace mrpp::test

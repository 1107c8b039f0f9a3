#include "framework/analysis/Components.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace mrpp
{
namespace
{

using ::testing::ElementsAre;
using ::testing::IsEmpty;

TEST(Components, AreNumberedByTheirSmallestVertex)
{
    const auto graph = Graph::fromEdges(7, {{5, 0}, {1, 6}, {6, 3}, {2, 4}});
    const Components components(*graph);
    ASSERT_EQ(components.count(), 3U);
    EXPECT_THAT(components.vertices(0), ElementsAre(0, 5));
    EXPECT_THAT(components.vertices(1), ElementsAre(1, 3, 6));
    EXPECT_THAT(components.vertices(2), ElementsAre(2, 4));
    EXPECT_EQ(components.of(3), 1U);
    EXPECT_EQ(components.size(1), 3U);
    EXPECT_EQ(components.largest(), 1U);
}

TEST(Components, OfEquallyLargeTheFirstIsTheLargest)
{
    EXPECT_EQ(Components(*Graph::fromEdges(5, {{1, 2}, {3, 4}})).largest(), 1U);
}

TEST(Components, AnEmptyGraphHasNone)
{
    const Components components(*Graph::fromEdges(0, {}));
    EXPECT_EQ(components.count(), 0U);
    EXPECT_EQ(components.largest(), 0U);
    EXPECT_THAT(components.vertices(0), IsEmpty());
}

TEST(Components, ALongPathIsOne)
{
    std::vector<Graph::Edge> edges;
    for (Vertex v = 0; v + 1 < 200000; ++v)
        edges.push_back({v, v + 1});
    EXPECT_EQ(Components(*Graph::fromEdges(200000, edges)).count(), 1U);
}

TEST(Components, ArePathsPolygonsOrBranching)
{
    const auto graph = Graph::fromEdges(15, {{1, 2},
                                             {2, 3},
                                             {4, 5},
                                             {5, 6},
                                             {6, 4},
                                             {7, 8},
                                             {8, 9},
                                             {9, 7},
                                             {9, 10},
                                             {11, 12},
                                             {12, 13},
                                             {12, 14}});
    using enum ComponentShape;
    EXPECT_THAT(componentShapes(*graph, Components(*graph)),
                ElementsAre(path, path, polygon, branching, branching));
}

} // namespace
} // namespace mrpp

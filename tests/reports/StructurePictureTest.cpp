#include "reports/layouts/StructurePicture.h"
#include "tests/reports/Campaigns.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <map>
#include <pugixml.hpp>

namespace mrpp
{
namespace
{

using ::testing::HasSubstr;
using ::testing::Not;
using namespace mrpp::testing;

StructurePicture drawn(const Graph &graph)
{
    return drawStructure(graph, placeGraph(graph), "title");
}

/// The tooltips of the SVG's vertices and edges by their ids.
std::map<std::string, std::string> tooltips(const std::string &svg)
{
    struct Walker : pugi::xml_tree_walker
    {
        std::map<std::string, std::string> found;
        bool for_each(pugi::xml_node &node) override
        {
            const std::string id = node.attribute("id").value();
            if (id.starts_with("vertex") || id.starts_with("edge"))
                for (const pugi::xml_node &child : node.children())
                    if (const auto link = child.child("a"))
                        found[id] = link.attribute("xlink:title").value();
            return true;
        }
    } walker;
    pugi::xml_document document;
    EXPECT_TRUE(document.load_string(svg.c_str()));
    document.traverse(walker);
    return walker.found;
}

/// A square with a handle over vertex 4, an isthmus of two edges, a triangle.
const auto kMixed = Graph::fromEdges(
    9, {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {0, 4}, {4, 1}, {2, 5}, {5, 6}, {6, 7}, {7, 8}, {8, 6}});

TEST(StructurePicture, NamesWhatEveryEdgeIs)
{
    auto tips = tooltips(drawn(*kMixed).picture.svg);
    EXPECT_EQ(tips["edge2-5"], "isthmus");
    EXPECT_EQ(tips["edge5-6"], "isthmus");
    EXPECT_EQ(tips["edge0-1"], "first cycle of block 1"); // the triangle 0, 1, 4
    EXPECT_EQ(tips["edge0-4"], "first cycle of block 1");
    EXPECT_EQ(tips["edge0-3"], "handle 1 of block 1");
    EXPECT_EQ(tips["edge2-3"], "handle 1 of block 1");
    EXPECT_EQ(tips["edge7-8"], "first cycle of block 2");
    EXPECT_EQ(tips["vertex3"], "vertex 3, B1 h1");
    EXPECT_EQ(tips["vertex5"], "vertex 5, cut vertex");
    EXPECT_EQ(tips["vertex8"], "vertex 8, B2 c");
}

TEST(StructurePicture, CountsTheParts)
{
    EXPECT_EQ(describe(drawn(*kMixed).parts),
              "2 isthmuses, 2 blocks: a cycle each and 1 handle in all, 3 cut vertices");
    EXPECT_EQ(describe(drawn(*treeInstance().graph).parts), "6 isthmuses, no cycle, 3 cut vertices");
    const auto complete = Graph::fromEdges(4, {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}});
    EXPECT_EQ(describe(drawn(*complete).parts),
              "no isthmus, 1 block: a cycle and 1 handle, 1 edge beside them");
}

TEST(StructurePicture, ExplainsWhatThereIsAndNothingElse)
{
    const std::string mixed = drawn(*kMixed).picture.svg;
    EXPECT_THAT(mixed, HasSubstr(">isthmus: an edge on no cycle<"));
    EXPECT_THAT(mixed, HasSubstr(">block (B1, B2, …), a tint each<"));
    EXPECT_THAT(mixed, Not(HasSubstr(">every other handle, dashed<")));
    const std::string tree = drawn(*treeInstance().graph).picture.svg;
    EXPECT_THAT(tree, Not(HasSubstr("handle")));
}

TEST(StructurePicture, DrawsTheLargestGraphs)
{
    const StructurePicture grid = drawn(*gridInstance(70, 1).graph);
    EXPECT_EQ(grid.parts.blocks, 1U);
    EXPECT_EQ(grid.parts.isthmuses, 0U);
    EXPECT_THAT(grid.picture.svg, HasSubstr("vertex4899"));
    EXPECT_EQ(grid.picture.pdf, drawn(*gridInstance(70, 1).graph).picture.pdf);
}

} // namespace
} // namespace mrpp

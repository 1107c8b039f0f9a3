#include "tests/problems/Generated.h"

#include "framework/Catalog.h"
#include "framework/model/BglAdaptor.h"
#include "framework/support/Error.h"
#include "problems/Problems.h"

#include <boost/graph/biconnected_components.hpp>
#include <boost/graph/boyer_myrvold_planar_test.hpp>
#include <boost/graph/connected_components.hpp>

#include <algorithm>
#include <map>

namespace mrpp::test
{

namespace
{

struct Blocks
{
    std::size_t count = 0;
    std::vector<std::size_t> ofEdge; ///< by edge index
    std::map<std::size_t, std::size_t> edges;
};

Blocks blocksOf(const Graph &graph)
{
    Blocks blocks;
    blocks.ofEdge.resize(2 * graph.edgeCount());
    const auto map = boost::make_iterator_property_map(blocks.ofEdge.begin(), get(boost::edge_index, graph));
    blocks.count = boost::biconnected_components(graph, map);
    for (const Graph::Edge &edge : graph.edges())
        ++blocks.edges[blocks.ofEdge[*graph.arc(edge.a, edge.b)]];
    return blocks;
}

} // namespace

Config config(const Settings &settings)
{
    std::vector<Config::Entry> entries;
    for (const auto &[key, value] : settings)
    {
        Config::Entry &entry = entries.emplace_back();
        entry.key = key;
        entry.where = {"plan.yaml", 4, 7};
        entry.value = Config::scalar(value, {"plan.yaml", 4, 20});
    }
    return Config::map(std::move(entries), {"plan.yaml", 4, 5});
}

std::string complaint(const char *family, const Settings &settings)
{
    Catalog catalog;
    registerProblems(catalog);
    try
    {
        catalog.problems.create(family)->configure(config(settings), {.catalog = &catalog});
    }
    catch (const InputError &error)
    {
        return error.what();
    }
    return "nothing is wrong";
}

bool isConnected(const Graph &graph)
{
    std::vector<int> component(graph.vertexCount());
    return boost::connected_components(graph, boost::make_iterator_property_map(
                                                  component.begin(), get(boost::vertex_index, graph))) == 1;
}

bool isBiconnected(const Graph &graph)
{
    return isConnected(graph) && blocksOf(graph).count == 1;
}

bool isPlanar(const Graph &graph)
{
    return boost::boyer_myrvold_planarity_test(graph);
}

std::vector<bool> onCycle(const Graph &graph)
{
    const Blocks blocks = blocksOf(graph);
    std::vector<bool> result(graph.vertexCount(), false);
    for (const Graph::Edge &edge : graph.edges())
        if (blocks.edges.at(blocks.ofEdge[*graph.arc(edge.a, edge.b)]) > 1)
            result[edge.a] = result[edge.b] = true;
    return result;
}

std::size_t longestIsthmus(const Graph &graph)
{
    const Blocks blocks = blocksOf(graph);
    const std::vector<bool> inCycle = onCycle(graph);
    const auto isBridge = [&](Vertex a, Vertex b)
    { return blocks.edges.at(blocks.ofEdge[*graph.arc(a, b)]) == 1; };
    std::size_t longest = 0;
    for (Vertex end = 0; end < graph.vertexCount(); ++end)
    {
        if (!inCycle[end] && graph.degree(end) != 1)
            continue;
        for (Vertex v : graph.neighbors(end))
        {
            if (!isBridge(std::min(end, v), std::max(end, v)))
                continue;
            std::size_t length = 1;
            for (Vertex before = end; !inCycle[v] && graph.degree(v) == 2; ++length)
            {
                const Vertex next = graph.neighbors(v)[graph.neighbors(v)[0] == before ? 1 : 0];
                before = v;
                v = next;
            }
            longest = std::max(longest, length);
        }
    }
    return longest;
}

} // namespace mrpp::test

#include "tests/algorithms/Planning.h"

#include "framework/Catalog.h"
#include "problems/Problems.h"

namespace mrpp::test
{

std::shared_ptr<const Graph> graphOf(std::size_t vertices, const Edges &pairs)
{
    std::vector<Graph::Edge> edges;
    for (const auto &[a, b] : pairs)
        edges.push_back({a, b});
    return Graph::fromEdges(vertices, edges);
}

Instance smallProblem(const std::string &name)
{
    Catalog catalog;
    registerProblems(catalog);
    const auto problem = catalog.problems.create("small_benchmark");
    problem->configure(Config::scalar(name), {.catalog = &catalog});
    const auto graph = problem->makeGraph(1);
    return problem->makeInstance(graph, problem->robotCount(*graph), 1);
}

} // namespace mrpp::test

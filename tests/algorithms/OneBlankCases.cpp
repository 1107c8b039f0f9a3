#include "tests/algorithms/OneBlankCases.h"

#include "algorithms/pebble/BlockPuzzle.h"
#include "framework/Problem.h"
#include "tests/support/BiconnectedGraphs.h"

#include <algorithm>

namespace mrpp::test
{

bool isBiconnectedAndNoCycle(const Graph &graph)
{
    return isBiconnected(graph) && graph.edgeCount() > graph.vertexCount();
}

std::shared_ptr<const Graph> cycleWith(std::size_t size, std::vector<Graph::Edge> edges)
{
    for (Vertex v = 0; v < size; ++v)
        edges.push_back({v, static_cast<Vertex>((v + 1) % size)});
    Vertex top = 0;
    for (const auto &edge : edges)
        top = std::max({top, edge.a, edge.b});
    return Graph::fromEdges(top + 1, edges);
}

std::shared_ptr<const Graph> thetaGraph(const std::vector<std::size_t> &arms)
{
    std::vector<Graph::Edge> edges;
    Vertex next = 2;
    for (const std::size_t arm : arms)
    {
        Vertex last = 0;
        for (std::size_t i = 0; i < arm; ++i)
        {
            edges.push_back({last, next});
            last = next++;
        }
        edges.push_back({last, 1});
    }
    return Graph::fromEdges(next, edges);
}

std::shared_ptr<const Graph> wheel(std::size_t spokes)
{
    std::vector<Graph::Edge> edges;
    for (Vertex v = 0; v < spokes; ++v)
        edges.push_back({v, static_cast<Vertex>(spokes)});
    return cycleWith(spokes, edges);
}

std::shared_ptr<const Graph> prism(std::size_t sides)
{
    std::vector<Graph::Edge> edges;
    for (Vertex v = 0; v < sides; ++v)
    {
        edges.push_back({v, static_cast<Vertex>(v + sides)});
        edges.push_back({static_cast<Vertex>(v + sides), static_cast<Vertex>((v + 1) % sides + sides)});
    }
    return cycleWith(sides, edges);
}

std::shared_ptr<const Graph> completeBipartite(std::size_t a, std::size_t b)
{
    std::vector<Graph::Edge> edges;
    for (Vertex v = 0; v < a; ++v)
        for (Vertex w = 0; w < b; ++w)
            edges.push_back({v, static_cast<Vertex>(a + w)});
    return Graph::fromEdges(a + b, edges);
}

std::shared_ptr<const Graph> randomBiconnected(std::size_t vertices, Random &random)
{
    const auto cycle = static_cast<Vertex>(3 + random.below(7));
    std::vector<Graph::Edge> edges{{0, cycle / 2U}};
    Vertex next = cycle;
    const std::size_t longest = 1 + random.below(9);
    while (next < vertices)
    {
        const auto x = static_cast<Vertex>(random.below(next));
        const auto y = static_cast<Vertex>((x + 1 + random.below(next - 1)) % next);
        Vertex last = x;
        for (std::size_t inner = random.below(longest + 1); inner > 0; --inner)
        {
            edges.push_back({last, next});
            last = next++;
        }
        edges.push_back({last, y});
        if (random.below(60) == 0)
            break;
    }
    return cycleWith(cycle, edges);
}

Instance scrambled(const std::shared_ptr<const Graph> &graph, std::size_t steps, Seed seed)
{
    Instance instance = randomInstance(graph, graph->vertexCount() - 1, seed);
    std::vector<Robot> occupants(graph->vertexCount(), kNoRobot);
    for (Robot r = 0; r < instance.robotCount(); ++r)
        occupants[instance.starts[r]] = r;
    auto blank =
        static_cast<Vertex>(std::find(occupants.begin(), occupants.end(), kNoRobot) - occupants.begin());
    Random random(seed);
    for (std::size_t i = 0; i < steps; ++i)
    {
        const auto around = graph->neighbors(blank);
        const Vertex next = around[random.below(around.size())];
        std::swap(occupants[blank], occupants[next]);
        blank = next;
    }
    for (Vertex v = 0; v < occupants.size(); ++v)
        if (occupants[v] != kNoRobot)
            instance.goals[occupants[v]] = v;
    return instance;
}

std::optional<Instance> randomPuzzle(const std::shared_ptr<const Graph> &graph, Seed seed, bool isOdd)
{
    const Blocks blocks(*graph);
    const PreparedBlock block(blocks, 0); // its vertices keep their numbers
    Instance instance = randomInstance(graph, graph->vertexCount() - 1, seed);
    for (int tries = 0; tries < 2; ++tries)
    {
        BlockPuzzle puzzle{&block, std::vector<Vertex>(graph->vertexCount(), kNoVertex), 0};
        std::vector<char> isGoal(graph->vertexCount(), 0);
        for (Robot r = 0; r < instance.robotCount(); ++r)
        {
            puzzle.targets[instance.starts[r]] = instance.goals[r];
            isGoal[instance.goals[r]] = 1;
        }
        puzzle.blank = static_cast<Vertex>(
            std::find(puzzle.targets.begin(), puzzle.targets.end(), kNoVertex) - puzzle.targets.begin());
        puzzle.targets[puzzle.blank] =
            static_cast<Vertex>(std::find(isGoal.begin(), isGoal.end(), 0) - isGoal.begin());
        if (obstacle(puzzle) == (isOdd ? BlockObstacle::oddPermutation : BlockObstacle::none))
            return instance;
        std::swap(instance.goals[0], instance.goals[1]);
    }
    return std::nullopt;
}

} // namespace mrpp::test

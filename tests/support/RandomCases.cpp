#include "tests/support/RandomCases.h"

#include "framework/Problem.h"

#include <algorithm>
#include <cassert>
#include <numeric>
#include <set>
#include <utility>
#include <vector>

namespace mrpp::test
{

namespace
{

std::vector<Vertex> shuffledVertices(std::size_t count, Random &random)
{
    std::vector<Vertex> vertices(count);
    std::iota(vertices.begin(), vertices.end(), Vertex{0});
    random.shuffle(std::span(vertices));
    return vertices;
}

/// Robots that walk about.
class Walkers
{
public:
    Walkers(std::shared_ptr<const Graph> graph, std::size_t robots, Seed seed)
        : graph_(std::move(graph)), random_(deriveSeed(seed, "walkers")),
          positions_(shuffledVertices(graph_->vertexCount(), random_)),
          occupant_(graph_->vertexCount(), kNoRobot)
    {
        assert(robots <= graph_->vertexCount());
        positions_.resize(robots);
        starts_ = cameFrom_ = positions_;
        for (Robot robot = 0; robot < robots; ++robot)
            occupant_[positions_[robot]] = robot;
    }

    Random &random() { return random_; }
    [[nodiscard]] const std::vector<Vertex> &positions() const { return positions_; }
    [[nodiscard]] Robot occupant(Vertex v) const { return occupant_[v]; }
    [[nodiscard]] const Graph &graph() const { return *graph_; }
    [[nodiscard]] Instance instance() const { return {graph_, starts_, positions_}; }

    void move(std::span<const Move> moves)
    {
        for (const Move &move : moves)
            occupant_[move.from] = kNoRobot;
        for (const Move &move : moves)
        {
            occupant_[move.to] = move.robot;
            positions_[move.robot] = move.to;
            cameFrom_[move.robot] = move.from;
        }
    }

    /// Moves some robot into an empty vertex; false where none can.
    bool wander(Solution &solution)
    {
        std::vector<Move> possible;
        std::vector<Move> onwards;
        for (Robot robot = 0; robot < positions_.size(); ++robot)
        {
            for (const Vertex v : graph_->neighbors(positions_[robot]))
            {
                if (occupant_[v] != kNoRobot)
                    continue;
                possible.push_back({robot, positions_[robot], v});
                if (v != cameFrom_[robot])
                    onwards.push_back(possible.back());
            }
        }
        const std::vector<Move> &choice = onwards.empty() ? possible : onwards;
        if (choice.empty())
            return false;
        const Move chosen = choice[random_.below(choice.size())];
        solution.append(chosen);
        move(std::span(&chosen, 1));
        return true;
    }

    /// Turns a closed cycle of robots that a random walk over occupied vertices meets; false where it ends.
    bool turn(Solution &solution)
    {
        if (positions_.empty())
            return false;
        std::vector<Vertex> walk = {positions_[random_.below(positions_.size())]};
        for (;;)
        {
            std::vector<Vertex> onwards;
            for (const Vertex v : graph_->neighbors(walk.back()))
                if (occupant_[v] != kNoRobot && (walk.size() < 2 || v != walk[walk.size() - 2]))
                    onwards.push_back(v);
            if (onwards.empty())
                return false;
            const Vertex v = onwards[random_.below(onwards.size())];
            const auto met = std::find(walk.begin(), walk.end(), v);
            if (met != walk.end())
            {
                walk.erase(walk.begin(), met);
                break;
            }
            walk.push_back(v);
        }
        std::vector<Move> moves;
        for (std::size_t i = 0; i < walk.size(); ++i)
            moves.push_back({occupant_[walk[i]], walk[i], walk[(i + 1) % walk.size()]});
        solution.appendRotation(moves);
        move(moves);
        return true;
    }

private:
    std::shared_ptr<const Graph> graph_;
    Random random_;
    std::vector<Vertex> starts_;
    std::vector<Vertex> positions_;
    std::vector<Vertex> cameFrom_;
    std::vector<Robot> occupant_;
};

/// Takes wishes back until the step is legal.
void settle(std::vector<Vertex> &wish, const Walkers &walkers, MotionRule rule)
{
    const std::vector<Vertex> &position = walkers.positions();
    const auto mustStay = [&](Robot robot)
    {
        for (Robot other = 0; other < wish.size(); ++other)
            if (other != robot && wish[other] == wish[robot])
                return true;
        Robot ahead = walkers.occupant(wish[robot]);
        if (ahead == kNoRobot)
            return false;
        if (rule <= MotionRule::parallel || wish[ahead] == position[robot])
            return true;
        if (rule == MotionRule::rotation)
            return false;
        for (std::size_t i = 0; i < wish.size() && ahead != kNoRobot && ahead != robot; ++i)
            ahead = wish[ahead] == position[ahead] ? kNoRobot : walkers.occupant(wish[ahead]);
        return ahead == robot;
    };
    for (bool changed = true; changed;)
    {
        changed = false;
        for (Robot robot = 0; robot < wish.size(); ++robot)
        {
            if (wish[robot] != position[robot] && mustStay(robot))
            {
                wish[robot] = position[robot];
                changed = true;
            }
        }
    }
}

} // namespace

std::shared_ptr<const Graph> randomConnectedGraph(std::size_t vertices, std::size_t extraEdges, Seed seed)
{
    Random random(deriveSeed(seed, "graph"));
    const std::vector<Vertex> names = shuffledVertices(vertices, random);
    std::set<std::pair<Vertex, Vertex>> pairs;
    const auto join = [&](std::size_t a, std::size_t b) { pairs.insert(std::minmax(names[a], names[b])); };
    for (std::size_t v = 1; v < vertices; ++v)
        join(v, random.below(v));
    const std::size_t complete = vertices < 2 ? 0 : vertices * (vertices - 1) / 2;
    const std::size_t wanted = std::min(complete, pairs.size() + extraEdges);
    while (pairs.size() < wanted)
    {
        const std::size_t a = random.below(vertices);
        const std::size_t b = random.below(vertices);
        if (a != b)
            join(a, b);
    }
    std::vector<Graph::Edge> edges;
    for (const auto &[a, b] : pairs)
        edges.push_back({a, b});
    return Graph::fromEdges(vertices, edges);
}

std::shared_ptr<const Graph> gridGraph(std::size_t width, std::size_t height)
{
    std::vector<Graph::Edge> edges;
    for (std::size_t y = 0; y < height; ++y)
    {
        for (std::size_t x = 0; x < width; ++x)
        {
            const auto v = static_cast<Vertex>(y * width + x);
            if (x + 1 < width)
                edges.push_back({v, v + 1});
            if (y + 1 < height)
                edges.push_back({v, v + static_cast<Vertex>(width)});
        }
    }
    return Graph::fromEdges(width * height, edges);
}

SolvedCase randomSolvedCase(std::shared_ptr<const Graph> graph, std::size_t robots, std::size_t moves,
                            Seed seed)
{
    Walkers walkers(std::move(graph), robots, seed);
    Solution solution;
    while (solution.pathLength() < moves && walkers.wander(solution))
        continue;
    return {walkers.instance(), std::move(solution)};
}

SolvedCase randomWalks(std::shared_ptr<const Graph> graph, std::size_t robots, std::size_t moves, Seed seed)
{
    Random random(seed);
    Instance instance = randomInstance(std::move(graph), robots, seed);
    std::vector<Vertex> positions = instance.starts;
    std::vector<char> occupied(instance.graph->vertexCount(), 0);
    for (const Vertex v : positions)
        occupied[v] = 1;
    Solution solution;
    solution.reserve(moves);
    while (solution.pathLength() < moves)
    {
        const auto robot = static_cast<Robot>(random.below(robots));
        const Vertex from = positions[robot];
        const auto around = instance.graph->neighbors(from);
        const Vertex to = around[random.below(around.size())];
        if (occupied[to] != 0)
            continue;
        occupied[from] = 0;
        occupied[to] = 1;
        positions[robot] = to;
        solution.append({robot, from, to});
    }
    instance.goals = std::move(positions);
    return {std::move(instance), std::move(solution)};
}

SolvedCase randomSolvedCaseWithRotations(std::shared_ptr<const Graph> graph, std::size_t robots,
                                         std::size_t actions, Seed seed)
{
    Walkers walkers(std::move(graph), robots, seed);
    Solution solution;
    for (std::size_t i = 0; i < actions; ++i)
        if (walkers.random().below(3) != 0 || !walkers.turn(solution))
            walkers.wander(solution);
    return {walkers.instance(), std::move(solution)};
}

Instance randomSolvableInstance(std::shared_ptr<const Graph> graph, std::size_t robots, Seed seed)
{
    const std::size_t moves = 10 * graph->vertexCount() * (robots + 1);
    return randomSolvedCase(std::move(graph), robots, moves, seed).instance;
}

ScheduledCase randomScheduledCase(std::shared_ptr<const Graph> graph, std::size_t robots, std::size_t steps,
                                  MotionRule rule, Seed seed)
{
    Walkers walkers(std::move(graph), robots, seed);
    Schedule schedule;
    for (std::size_t step = 0; step < steps; ++step)
    {
        std::vector<Vertex> wish = walkers.positions();
        for (Vertex &v : wish)
        {
            const auto around = walkers.graph().neighbors(v);
            if (!around.empty() && walkers.random().below(4) != 0)
                v = around[walkers.random().below(around.size())];
        }
        settle(wish, walkers, rule);
        std::vector<Move> moves;
        for (Robot robot = 0; robot < wish.size(); ++robot)
            if (wish[robot] != walkers.positions()[robot])
                moves.push_back({robot, walkers.positions()[robot], wish[robot]});
        if (rule == MotionRule::pebble && moves.size() > 1)
            moves = {moves[walkers.random().below(moves.size())]};
        schedule.appendStep(moves);
        walkers.move(moves);
    }
    return {walkers.instance(), std::move(schedule)};
}

} // namespace mrpp::test

#include "tests/support/ReasonCheck.h"

#include "tests/support/SmallGraphs.h"

#include <algorithm>
#include <cstdio>

namespace mrpp::test
{

namespace
{

/// The set in braces.
std::vector<Vertex> setIn(const std::string &reason)
{
    std::vector<Vertex> set;
    const std::size_t end = reason.find('}');
    for (std::size_t i = reason.find('{') + 1; i < end; i = reason.find_first_of(" }", i) + 1)
        set.push_back(static_cast<Vertex>(std::stoul(reason.substr(i))));
    std::ranges::sort(set);
    return set;
}

bool contains(const std::vector<Vertex> &set, Vertex v)
{
    return std::ranges::find(set, v) != set.end();
}

} // namespace

ReasonCheck::ReasonCheck(std::shared_ptr<const Graph> graph, std::size_t robots, MotionRule rule,
                         const ConfigurationOrbits &orbits)
    : graph_(std::move(graph)), robots_(robots), rule_(rule), orbits_(orbits), cycles_(simpleCycles(*graph_)),
      positionOrbits_(positionOrbits(*graph_, rule))
{}

std::string ReasonCheck::complaint(const Instance &instance, const std::string &reason) const
{
    const auto says = [&](const char *words) { return reason.find(words) != std::string::npos; };
    if (says("it needs"))
        return checkCorridor(instance, reason);
    if (says("on the path"))
        return checkPath(instance, reason);
    if (says("cyclic order"))
        return checkCycle(instance, reason);
    if (says("cut vertex"))
        return checkCutVertex(instance, reason);
    if (says("the bridge"))
        return checkBridge(instance, reason);
    if (says("odd permutation"))
        return checkParity(instance, reason);
    if (says("theta_0"))
        return graph_->vertexCount() == 7 && graph_->edgeCount() == 8 ? "" : "not theta_0";
    if (says("cannot leave"))
        return robots_ == graph_->vertexCount() ? "" : "there is a free vertex";
    return "unknown kind";
}

std::string ReasonCheck::checkCorridor(const Instance &instance, const std::string &reason) const
{
    Robot a = 0;
    Robot b = 0;
    Vertex u = 0;
    Vertex v = 0;
    unsigned need = 0;
    unsigned free = 0;
    char verb[4] = {};
    const bool deadEnd = reason.find("dead end") != std::string::npos;
    if (std::sscanf(reason.c_str(),
                    deadEnd
                        ? "robots %u and %u cannot pass each other in the dead end %u–%u: it needs %u free "
                          "vertices, there %3s %u"
                        : "robots %u and %u cannot pass each other in the corridor %u–%u: it needs %u free "
                          "vertices, there %3s %u",
                    &a, &b, &u, &v, &need, verb, &free) != 7)
        return "not understood";
    const std::size_t n = graph_->vertexCount();
    if (free != n - robots_ || need <= free)
        return "wrong number of free vertices";
    // Some path from u to v over vertices of degree two.
    std::vector<Vertex> corridor;
    for (const Vertex first : graph_->neighbors(u))
    {
        corridor = {u, first};
        while (corridor.back() != v && graph_->degree(corridor.back()) == 2)
            for (const Vertex w : graph_->neighbors(corridor.back()))
                if (w != corridor[corridor.size() - 2])
                {
                    corridor.push_back(w);
                    break;
                }
        if (corridor.back() == v)
            break;
    }
    if (corridor.back() != v || graph_->degree(u) < 3 || deadEnd != (graph_->degree(v) == 1) ||
        (!deadEnd && graph_->degree(v) < 3))
        return "no such corridor";
    const auto extra = [&](Vertex end)
    { return graph_->degree(end) == 1 || (rule_ == MotionRule::rotation && onCycle(end)) ? 0U : 1U; };
    if (need != corridor.size() - 1 + extra(u) + extra(v))
        return "wrong need";
    // Neither can come to the other's goal, and every way between these goals meets the corridor.
    std::size_t set = 0;
    for (const Vertex goal : instance.goals)
        set |= std::size_t{1} << goal;
    if (positionOrbits_[set * n + instance.goals[a]] == positionOrbits_[set * n + instance.goals[b]])
        return "the robots can change places";
    if (!contains(corridor, instance.goals[a]) && !contains(corridor, instance.goals[b]) &&
        connected(instance.goals[a], instance.goals[b], u) &&
        connected(instance.goals[a], instance.goals[b], v))
        return "the corridor is not between the robots' goals";
    return "";
}

std::string ReasonCheck::checkPath(const Instance &instance, const std::string &reason) const
{
    Robot a = 0;
    Robot b = 0;
    Vertex u = 0;
    Vertex v = 0;
    if (std::sscanf(reason.c_str(), "robots %u and %u cannot pass each other on the path %u–%u", &a, &b, &u,
                    &v) != 4 ||
        graph_->degree(u) != 1 || graph_->degree(v) != 1)
        return "not understood";
    const auto firstIsNearer = [&](const std::vector<Vertex> &positions)
    { return positions[a] == u || (positions[b] != u && connected(u, positions[a], positions[b])); };
    return firstIsNearer(instance.starts) != firstIsNearer(instance.goals) ? "" : "they need not pass";
}

std::string ReasonCheck::checkCycle(const Instance &instance, const std::string &reason) const
{
    Robot a = 0;
    Robot b = 0;
    Robot c = 0;
    if (std::sscanf(reason.c_str(), "the cyclic order %u, %u, %u of", &a, &b, &c) != 3)
        return "not understood";
    const std::vector<Vertex> set = setIn(reason);
    const auto cycle = std::ranges::find_if(cycles_,
                                            [&](std::vector<Vertex> other)
                                            {
                                                std::ranges::sort(other);
                                                return other == set;
                                            });
    if (cycle == cycles_.end())
        return "no such cycle";
    const auto ordered = [&](const std::vector<Vertex> &positions)
    {
        const auto at = [&](Robot robot)
        { return std::ranges::find(*cycle, positions[robot]) - cycle->begin(); };
        const int descents = (at(a) > at(b) ? 1 : 0) + (at(b) > at(c) ? 1 : 0) + (at(c) > at(a) ? 1 : 0);
        return descents == 1;
    };
    for (const auto &configuration : places(instance))
    {
        for (const Robot robot : {a, b, c})
            if (!contains(set, configuration[robot]) || !contains(set, instance.goals[robot]))
                return "a robot is not on the cycle";
        if (ordered(configuration) == ordered(instance.goals))
            return "the order is not kept";
    }
    return "";
}

std::string ReasonCheck::checkCutVertex(const Instance &instance, const std::string &reason) const
{
    Robot robot = 0;
    Vertex cut = 0;
    const bool rests = reason.find("come to rest") != std::string::npos;
    if (std::sscanf(reason.c_str(),
                    rests ? "robot %u cannot come to rest on the cut vertex %u"
                          : "robot %u would have to cross the cut vertex %u",
                    &robot, &cut) != 2)
        return "not understood";
    const std::vector<Vertex> block = setIn(reason);
    const Vertex goal = instance.goals[robot];
    if (rests != (goal == cut) || (!rests && contains(block, goal)) || !contains(block, cut))
        return "wrong goal";
    for (const auto &configuration : places(instance))
    {
        const Vertex place = configuration[robot];
        if (!contains(block, place) || (rests && place == cut))
            return "the robot leaves the block";
        if (!rests && place != cut && connected(place, goal, cut))
            return "the cut vertex is not on the way";
    }
    return "";
}

std::string ReasonCheck::checkBridge(const Instance &instance, const std::string &reason) const
{
    Robot robot = 0;
    Vertex a = 0;
    Vertex b = 0;
    if (std::sscanf(reason.c_str(), "robot %u cannot cross the bridge %u–%u", &robot, &a, &b) != 3)
        return "not understood";
    const bool onCycles =
        std::ranges::any_of(cycles_,
                            [&](const std::vector<Vertex> &cycle)
                            {
                                for (std::size_t i = 0; i < cycle.size(); ++i)
                                    if ((cycle[i] == a && cycle[(i + 1) % cycle.size()] == b) ||
                                        (cycle[i] == b && cycle[(i + 1) % cycle.size()] == a))
                                        return true;
                                return false;
                            });
    const Vertex start = instance.starts[robot];
    const Vertex goal = instance.goals[robot];
    const bool between =
        (start == a || !connected(start, goal, a)) && (goal == b || !connected(start, goal, b));
    return !onCycles && graph_->hasEdge(a, b) && between && robots_ == graph_->vertexCount() ? ""
                                                                                             : "no bridge";
}

std::string ReasonCheck::checkParity(const Instance &instance, const std::string &reason) const
{
    const std::vector<Vertex> set = setIn(reason);
    const bool bipartite = reason.find("bipartite") != std::string::npos;
    for (const auto &cycle : cycles_)
        if (std::ranges::all_of(cycle, [&](Vertex v) { return contains(set, v); }) &&
            (cycle.size() % 2 == 0) != bipartite)
            return "wrong kind of cycles";
    for (const auto &configuration : places(instance))
    {
        bool odd = false;
        for (Robot a = 0; a < robots_; ++a)
            for (Robot b = 0; b < a; ++b)
                if (contains(set, configuration[a]) && contains(set, configuration[b]))
                    odd ^= (configuration[a] < configuration[b]) != (instance.goals[a] < instance.goals[b]);
        if (!odd)
            return "even permutation";
    }
    return "";
}

bool ReasonCheck::onCycle(Vertex v) const
{
    return std::ranges::any_of(cycles_, [&](const auto &cycle) { return contains(cycle, v); });
}

bool ReasonCheck::connected(Vertex a, Vertex b, Vertex withoutVertex) const
{
    if (a == withoutVertex || b == withoutVertex)
        return false;
    std::vector<Vertex> reached = {a};
    for (std::size_t i = 0; i < reached.size(); ++i)
        for (const Vertex v : graph_->neighbors(reached[i]))
            if (v != withoutVertex && !contains(reached, v))
                reached.push_back(v);
    return contains(reached, b);
}

std::vector<std::vector<Vertex>> ReasonCheck::places(const Instance &instance) const
{
    std::vector<std::vector<Vertex>> found;
    std::vector<Vertex> places = instance.goals;
    std::ranges::sort(places);
    do
    {
        if (orbits_.of(places) == orbits_.of(instance.starts))
            found.push_back(places);
    } while (std::ranges::next_permutation(places).found);
    return found;
}

} // namespace mrpp::test

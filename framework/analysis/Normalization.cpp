#include "framework/analysis/Normalization.h"

#include <cstdint>
#include <numeric>

namespace mrpp
{

namespace
{

/// Robots one behind another.
struct Stream
{
    Robot head = kNoRobot;
    Robot tail = kNoRobot;
};

class Flow
{
public:
    Flow(const Graph &graph, const Blocks &blocks, std::span<const Vertex> starts,
         std::span<const Vertex> support)
        : graph_(graph), blocks_(blocks), occupant_(graph.vertexCount(), kNoRobot),
          wanted_(graph.vertexCount(), 0), surplus_(graph.vertexCount() + 1, 0),
          streams_(graph.vertexCount()), next_(starts.size(), kNoRobot), previous_(starts.size(), kNoRobot),
          places_(starts.size(), kNoVertex)
    {
        for (Robot robot = 0; robot < starts.size(); ++robot)
        {
            occupant_[starts[robot]] = robot;
            ++surplus_[blocks.position(starts[robot]) + 1];
        }
        for (const Vertex v : support)
        {
            wanted_[v] = 1;
            --surplus_[blocks.position(v) + 1];
        }
        std::partial_sum(surplus_.begin(), surplus_.end(), surplus_.begin());
    }

    /// Each vertex after those whose robots come to it: from the leaves upwards, then downwards.
    std::vector<Vertex> run()
    {
        const auto order = blocks_.preorder();
        for (std::size_t i = order.size(); i-- > 0;)
            if (upwards(order[i]) >= 0)
                pass(order[i]);
        for (const Vertex v : order)
            if (upwards(v) < 0)
                pass(v);
        return std::move(places_);
    }

private:
    /// How many robots go from v to its parent; below zero, how many come from there.
    [[nodiscard]] std::int32_t upwards(Vertex v) const
    {
        return surplus_[blocks_.position(v) + blocks_.subtreeSize(v)] - surplus_[blocks_.position(v)];
    }

    /// Calls use(child).
    template <class Use>
    void forEachChild(Vertex v, Use &&use) const
    {
        for (const Vertex w : graph_.neighbors(v))
            if (blocks_.parent(w) == v)
                use(w);
    }

    void append(Stream &line, const Stream &more)
    {
        if (more.head == kNoRobot)
            return;
        if (line.head == kNoRobot)
            line.head = more.head;
        else
            next_[line.tail] = more.head;
        previous_[more.head] = line.tail;
        line.tail = more.tail;
    }

    /// Takes the first robots, one or more.
    Stream takeFront(Stream &line, std::int32_t count)
    {
        Stream taken = {line.head, line.head};
        while (--count > 0)
            taken.tail = next_[taken.tail];
        line.head = next_[taken.tail];
        if (line.head == kNoRobot)
            line.tail = kNoRobot;
        else
            previous_[line.head] = kNoRobot;
        next_[taken.tail] = kNoRobot;
        return taken;
    }

    Robot takeLast(Stream &line)
    {
        const Robot last = line.tail;
        line.tail = previous_[last];
        if (line.tail == kNoRobot)
            line.head = kNoRobot;
        else
            next_[line.tail] = kNoRobot;
        previous_[last] = kNoRobot;
        return last;
    }

    void pass(Vertex v)
    {
        Stream line;
        if (occupant_[v] != kNoRobot)
            append(line, {occupant_[v], occupant_[v]});
        Vertex largest = v; ///< the stream between it and its parent is the longest that goes out
        std::int32_t size = upwards(v);
        forEachChild(v,
                     [&](Vertex child)
                     {
                         const std::int32_t up = upwards(child);
                         if (up > 0)
                             append(line, streams_[child]);
                         if (-up > size)
                         {
                             size = -up;
                             largest = child;
                         }
                     });
        if (upwards(v) < 0)
            append(line, streams_[v]);
        if (wanted_[v] != 0)
            places_[takeLast(line)] = v;
        forEachChild(v,
                     [&](Vertex child)
                     {
                         if (child != largest && upwards(child) < 0)
                             streams_[child] = takeFront(line, -upwards(child));
                     });
        if (largest != v && upwards(v) > 0)
            streams_[v] = takeFront(line, upwards(v));
        if (size > 0)
            streams_[largest] = line;
    }

    const Graph &graph_;
    const Blocks &blocks_;
    std::vector<Robot> occupant_;
    std::vector<std::uint8_t> wanted_;
    std::vector<std::int32_t> surplus_; ///< robots less places among the first i of the preorder
    std::vector<Stream> streams_;       ///< between a vertex and its parent
    std::vector<Robot> next_;
    std::vector<Robot> previous_;
    std::vector<Vertex> places_;
};

} // namespace

std::vector<Vertex> normalize(const Graph &graph, const Blocks &blocks, std::span<const Vertex> starts,
                              std::span<const Vertex> support)
{
    return Flow(graph, blocks, starts, support).run();
}

} // namespace mrpp

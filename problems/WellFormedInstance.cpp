#include "problems/WellFormedInstance.h"

#include "framework/analysis/Components.h"
#include "framework/support/Error.h"

#include <algorithm>

namespace mrpp
{

namespace
{

/// Takes pairs of vertices as start and goal of one robot after another.
class WellFormedDraw
{
public:
    WellFormedDraw(const Graph &graph, std::vector<Vertex> vertices, Seed seed)
        : graph_(graph), vertices_(std::move(vertices)), random_(seed),
          checks_(
              std::clamp<std::size_t>(200'000'000 / (graph.vertexCount() + graph.edgeCount()), 100, 100'000)),
          isEnd_(graph.vertexCount(), false), region_(graph.vertexCount()), seenBy_(graph.vertexCount())
    {}

    /// Stops early where the checks are used up.
    void take(std::size_t robots)
    {
        while (starts.size() < robots && checks_ > 0)
        {
            drawPairs();
            takePairs(robots);
        }
    }

    std::vector<Vertex> starts;
    std::vector<Vertex> goals;

private:
    /// Another random order of the vertices that are no start or goal; each two in a row are a pair.
    void drawPairs()
    {
        pairs_.clear();
        for (const Vertex v : vertices_)
            if (!isEnd_[v])
                pairs_.push_back(v);
        random_.shuffle(std::span(pairs_));
    }

    void takePairs(std::size_t robots)
    {
        std::size_t next = 0;
        while (next < pairs_.size() / 2 && starts.size() < robots && checks_ > 0)
        {
            const std::size_t batch = std::min({batch_, pairs_.size() / 2 - next, robots - starts.size()});
            add(next, batch);
            if (isWellFormed())
            {
                next += batch;
                batch_ = 2 * batch;
                continue;
            }
            takeBack(batch);
            next += batch == 1 ? 1 : 0;
            batch_ = std::max<std::size_t>(batch / 2, 1);
        }
    }

    void add(std::size_t first, std::size_t count)
    {
        for (std::size_t i = first; i < first + count; ++i)
        {
            starts.push_back(pairs_[2 * i]);
            goals.push_back(pairs_[2 * i + 1]);
            isEnd_[starts.back()] = isEnd_[goals.back()] = true;
        }
    }

    void takeBack(std::size_t count)
    {
        for (; count > 0; --count)
        {
            isEnd_[starts.back()] = isEnd_[goals.back()] = false;
            starts.pop_back();
            goals.pop_back();
        }
    }

    bool isWellFormed()
    {
        --checks_;
        findRegions();
        std::fill(seenBy_.begin(), seenBy_.end(), kNoRobot);
        for (Robot r = 0; r < starts.size(); ++r)
            if (!canPass(r))
                return false;
        return true;
    }

    /// Regions are the components of the vertices that are no start or goal; numbered by one of theirs.
    void findRegions()
    {
        std::fill(region_.begin(), region_.end(), kNoVertex);
        for (const Vertex root : vertices_)
        {
            if (isEnd_[root] || region_[root] != kNoVertex)
                continue;
            region_[root] = root;
            stack_.assign(1, root);
            while (!stack_.empty())
            {
                const Vertex v = stack_.back();
                stack_.pop_back();
                for (const Vertex u : graph_.neighbors(v))
                    if (!isEnd_[u] && region_[u] == kNoVertex)
                    {
                        region_[u] = root;
                        stack_.push_back(u);
                    }
            }
        }
    }

    /// Whether start and goal are neighbours, or have neighbours in one region.
    bool canPass(Robot r)
    {
        for (const Vertex u : graph_.neighbors(starts[r]))
        {
            if (u == goals[r])
                return true;
            if (!isEnd_[u])
                seenBy_[region_[u]] = r;
        }
        const auto around = graph_.neighbors(goals[r]);
        return std::any_of(around.begin(), around.end(),
                           [this, r](Vertex u) { return !isEnd_[u] && seenBy_[region_[u]] == r; });
    }

    const Graph &graph_;
    std::vector<Vertex> vertices_; ///< of the component
    Random random_;
    std::size_t checks_; ///< that are left
    std::size_t batch_ = 1;
    std::vector<bool> isEnd_;    ///< start or goal, by vertex
    std::vector<Vertex> region_; ///< by vertex; kNoVertex for starts and goals
    std::vector<Robot> seenBy_;  ///< by region, the last robot that starts beside it
    std::vector<Vertex> pairs_;
    std::vector<Vertex> stack_;
};

} // namespace

Instance wellFormedInstance(std::shared_ptr<const Graph> graph, std::size_t robots, Seed seed)
{
    if (robots == 0)
        return {std::move(graph), {}, {}};
    const Components components(*graph);
    std::vector<Vertex> vertices = components.vertices(components.largest());
    const std::size_t room = vertices.size() / 2;
    if (robots > room)
        throw DoesNotFit("no well-formed instance has " + std::to_string(robots) +
                         " robots in a component of " + std::to_string(vertices.size()) +
                         " vertices: it needs two for each robot");
    WellFormedDraw draw(*graph, std::move(vertices), deriveSeed(seed, "well-formed"));
    draw.take(robots);
    if (draw.starts.size() < robots)
        throw DoesNotFit("no well-formed instance of " + std::to_string(robots) +
                         " robots was found, only of " + std::to_string(draw.starts.size()) +
                         " (there may be one; fewer robots are likelier)");
    return {std::move(graph), std::move(draw.starts), std::move(draw.goals)};
}

} // namespace mrpp

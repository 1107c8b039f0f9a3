#include "Star.h"

#include "framework/support/Error.h"

#include <algorithm>
#include <cmath>

using mrpp::Vertex;

Star::Star()
{
    declareParam("arms", arms_, "3:1000", "how many arms");
    declareParam("length", length_, "1:1000", "vertices of an arm");
}

std::string Star::name() const
{
    return "star " + std::to_string(arms_) + "-" + std::to_string(length_);
}

std::shared_ptr<const mrpp::Graph> Star::makeGraph(mrpp::Seed) const
{
    // The middle is vertex 0; each arm is numbered from there outwards.
    std::vector<mrpp::Graph::Edge> edges;
    std::vector<mrpp::Point> points(1);
    for (std::int64_t arm = 0; arm < arms_; ++arm)
    {
        const double angle = 6.283185307 * static_cast<double>(arm) / static_cast<double>(arms_);
        for (std::int64_t i = 1; i <= length_; ++i)
        {
            const auto v = static_cast<Vertex>(points.size());
            edges.push_back({i == 1 ? 0 : v - 1, v});
            points.push_back(
                {std::cos(angle) * static_cast<double>(i), std::sin(angle) * static_cast<double>(i), 0});
        }
    }
    const std::size_t vertices = points.size();
    return mrpp::Graph::fromEdges(vertices, edges, std::move(points));
}

mrpp::Instance Star::makeInstance(std::shared_ptr<const mrpp::Graph> graph, std::size_t robots,
                                  mrpp::Seed seed) const
{
    if (robots > static_cast<std::size_t>(arms_))
        throw mrpp::DoesNotFit(std::to_string(robots) + " robots do not fit " + std::to_string(arms_) +
                               " arms");
    std::vector<Vertex> ends;
    for (std::int64_t arm = 1; arm <= arms_; ++arm)
        ends.push_back(static_cast<Vertex>(arm * length_));
    mrpp::Random random(seed);
    random.shuffle(std::span(ends));
    mrpp::Instance instance{std::move(graph), ends, ends};
    std::rotate(instance.goals.begin(), instance.goals.begin() + 1, instance.goals.end());
    instance.starts.resize(robots);
    instance.goals.resize(robots);
    return instance;
}

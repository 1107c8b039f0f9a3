#include "framework/model/Graph.h"

#include "framework/support/Fingerprint.h"

#include <algorithm>
#include <cassert>

namespace mrpp
{

std::shared_ptr<const Graph> Graph::fromEdges(std::size_t vertexCount, std::span<const Edge> edges,
                                              std::vector<Point> coordinates, YAxis yAxis)
{
    assert(coordinates.empty() || coordinates.size() == vertexCount);
    struct Arc
    {
        Vertex target;
        double weight;
    };
    std::vector<std::uint32_t> offsets(vertexCount + 1, 0);
    for (const Edge &edge : edges)
    {
        assert(edge.a < vertexCount && edge.b < vertexCount);
        if (edge.a != edge.b)
        {
            ++offsets[edge.a + 1];
            ++offsets[edge.b + 1];
        }
    }
    for (std::size_t v = 0; v < vertexCount; ++v)
        offsets[v + 1] += offsets[v];

    std::vector<Arc> arcs(offsets.back());
    std::vector<std::uint32_t> next(offsets.begin(), offsets.end() - 1);
    for (const Edge &edge : edges)
    {
        if (edge.a != edge.b)
        {
            arcs[next[edge.a]++] = {edge.b, edge.weight};
            arcs[next[edge.b]++] = {edge.a, edge.weight};
        }
    }

    auto graph = std::make_shared<Graph>();
    graph->offsets_.assign(vertexCount + 1, 0);
    graph->neighbors_.reserve(arcs.size());
    std::vector<double> weights;
    bool weighted = false;
    for (std::size_t v = 0; v < vertexCount; ++v)
    {
        const auto first = arcs.begin() + offsets[v];
        const auto last = arcs.begin() + offsets[v + 1];
        std::stable_sort(first, last, [](const Arc &x, const Arc &y) { return x.target < y.target; });
        for (auto arc = first; arc != last; ++arc)
        {
            if (arc != first && arc->target == (arc - 1)->target)
                continue;
            graph->neighbors_.push_back(arc->target);
            weights.push_back(arc->weight);
            weighted = weighted || arc->weight != 1;
        }
        graph->offsets_[v + 1] = static_cast<std::uint32_t>(graph->neighbors_.size());
    }
    graph->neighbors_.shrink_to_fit();
    if (weighted)
        graph->weights_ = std::move(weights);
    graph->coordinates_ = std::move(coordinates);
    graph->yAxis_ = yAxis;
    return graph;
}

std::shared_ptr<const Graph> Graph::fromEdges(std::size_t vertexCount,
                                              std::initializer_list<std::pair<Vertex, Vertex>> edges)
{
    std::vector<Edge> list;
    for (const auto &[a, b] : edges)
        list.push_back({a, b});
    return fromEdges(vertexCount, list);
}

std::optional<std::size_t> Graph::arc(Vertex a, Vertex b) const
{
    if (a >= vertexCount())
        return std::nullopt;
    const auto around = neighbors(a);
    const auto found = std::lower_bound(around.begin(), around.end(), b);
    if (found == around.end() || *found != b)
        return std::nullopt;
    return static_cast<std::size_t>(&*found - neighbors_.data());
}

double Graph::weight(Vertex a, Vertex b) const
{
    const auto position = arc(a, b);
    assert(position);
    return weights_.empty() ? 1 : weights_[*position];
}

std::vector<Graph::Edge> Graph::edges() const
{
    std::vector<Edge> list;
    list.reserve(edgeCount());
    for (Vertex a = 0; a < vertexCount(); ++a)
        for (std::uint32_t i = offsets_[a]; i < offsets_[a + 1]; ++i)
            if (a < neighbors_[i])
                list.push_back({a, neighbors_[i], weights_.empty() ? 1 : weights_[i]});
    return list;
}

std::string Graph::fingerprint() const
{
    Fingerprint hash;
    hash.add(std::span(offsets_)).add(std::span(neighbors_));
    for (const double weight : weights_)
        hash.add(weight);
    return hash.hex();
}

} // namespace mrpp

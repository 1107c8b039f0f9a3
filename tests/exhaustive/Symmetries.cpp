#include "tests/exhaustive/Symmetries.h"

#include <algorithm>
#include <numeric>

namespace mrpp::test
{

namespace
{

std::vector<Vertex> imageOf(std::span<const Vertex> set, const Symmetries::Symmetry &symmetry)
{
    std::vector<Vertex> image;
    for (const Vertex v : set)
        image.push_back(symmetry[v]);
    std::ranges::sort(image);
    return image;
}

} // namespace

Symmetries::Symmetries(const Graph &graph)
{
    Symmetry image(graph.vertexCount());
    std::iota(image.begin(), image.end(), Vertex{0});
    const std::vector<Graph::Edge> edges = graph.edges();
    do
    {
        if (std::ranges::all_of(edges, [&](const Graph::Edge &edge)
                                { return graph.hasEdge(image[edge.a], image[edge.b]); }))
            all_.push_back(image);
    } while (std::next_permutation(image.begin(), image.end()));
}

bool Symmetries::isFirst(std::span<const Vertex> set) const
{
    return std::ranges::none_of(all_,
                                [&](const Symmetry &symmetry) {
                                    return std::ranges::lexicographical_compare(imageOf(set, symmetry), set);
                                });
}

std::vector<Symmetries::Symmetry> Symmetries::keeping(std::span<const Vertex> set) const
{
    std::vector<Symmetry> keeping;
    for (const Symmetry &symmetry : all_)
        if (!std::ranges::is_sorted(symmetry) && std::ranges::equal(imageOf(set, symmetry), set))
            keeping.push_back(symmetry);
    return keeping;
}

bool Symmetries::isFirst(std::span<const Vertex> starts, std::span<const Vertex> goals,
                         std::span<const Symmetry> keepingGoals)
{
    std::vector<Vertex> image(starts.size());
    for (const Symmetry &symmetry : keepingGoals)
    {
        for (std::size_t r = 0; r < starts.size(); ++r)
        {
            const auto renamed = std::ranges::lower_bound(goals, symmetry[goals[r]]) - goals.begin();
            image[static_cast<std::size_t>(renamed)] = symmetry[starts[r]];
        }
        if (std::ranges::lexicographical_compare(image, starts))
            return false;
    }
    return true;
}

} // namespace mrpp::test

#include "framework/analysis/Components.h"

#include <algorithm>

namespace mrpp
{

Components::Components(const Graph &graph)
{
    constexpr auto kUnseen = static_cast<std::uint32_t>(-1);
    component_.assign(graph.vertexCount(), kUnseen);
    std::vector<Vertex> stack;
    for (Vertex root = 0; root < graph.vertexCount(); ++root)
    {
        if (component_[root] != kUnseen)
            continue;
        const auto id = static_cast<std::uint32_t>(sizes_.size());
        sizes_.push_back(0);
        component_[root] = id;
        stack.push_back(root);
        while (!stack.empty())
        {
            const Vertex v = stack.back();
            stack.pop_back();
            ++sizes_[id];
            for (const Vertex w : graph.neighbors(v))
            {
                if (component_[w] == kUnseen)
                {
                    component_[w] = id;
                    stack.push_back(w);
                }
            }
        }
    }
}

std::uint32_t Components::largest() const
{
    return static_cast<std::uint32_t>(std::max_element(sizes_.begin(), sizes_.end()) - sizes_.begin());
}

std::vector<Vertex> Components::vertices(std::uint32_t component) const
{
    std::vector<Vertex> list;
    for (Vertex v = 0; v < component_.size(); ++v)
        if (component_[v] == component)
            list.push_back(v);
    return list;
}

std::vector<ComponentShape> componentShapes(const Graph &graph, const Components &components)
{
    std::vector<ComponentShape> shapes(components.count(), ComponentShape::polygon);
    for (Vertex v = 0; v < graph.vertexCount(); ++v)
    {
        ComponentShape &shape = shapes[components.of(v)];
        if (graph.degree(v) >= 3)
            shape = ComponentShape::branching;
        else if (graph.degree(v) <= 1 && shape == ComponentShape::polygon)
            shape = ComponentShape::path;
    }
    return shapes;
}

} // namespace mrpp

#include "reports/layouts/StructurePicture.h"

#include "framework/analysis/Blocks.h"
#include "framework/analysis/EarDecomposition.h"
#include "reports/layouts/GraphDrawing.h"
#include "reports/picture/Palette.h"
#include "reports/picture/Text.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace mrpp
{

namespace
{

constexpr const char *kInk = "#000000";
constexpr const char *kFaint = "#b4b4b4";
constexpr std::size_t kHandleColors = 6; // the palette's black is the cycle's, its grey the other edges'

/// The color between white (0) and itself (1).
std::string tint(const std::string &color, double share)
{
    const auto [red, green, blue] = rgb(color);
    const auto mixed = [share](double channel)
    { return static_cast<int>(std::lround(255 * (1 - share * (1 - channel)))); };
    return fmt::format("#{:02x}{:02x}{:02x}", mixed(red), mixed(green), mixed(blue));
}

class StructureDrawing
{
public:
    StructureDrawing(const Graph &graph, const Placement &placement)
        : graph_(graph), blocks_(graph), edges_(graph.edges()), drawing_(graph, placement),
          labels_(graph.vertexCount())
    {}

    StructurePicture draw(const std::string &title)
    {
        for (std::size_t i = 0; i < edges_.size(); ++i)
            if (blocks_.isBridge(edges_[i].a, edges_[i].b))
            {
                ++parts_.isthmuses;
                dress(i, isthmus(), "isthmus");
            }
        for (const std::uint32_t block : cyclicBlocks())
            addBlock(block);
        addVertices();
        addLegend();
        return {drawing_.render(title), parts_};
    }

private:
    const Graph &graph_;
    Blocks blocks_;
    std::vector<Graph::Edge> edges_;
    GraphDrawing drawing_;
    std::vector<std::string> labels_; ///< of vertices: block and handle
    GraphParts parts_;
    bool severalBlocks_ = false;

    [[nodiscard]] double width() const { return 1.6 * drawing_.scale().route; }

    [[nodiscard]] DotAttributes isthmus() const
    {
        return {{"color", fmt::format("{0}:{1}:{0}", kInk, "#ffffff")},
                {"penwidth", fmt::format("{}", 0.6 * width())}};
    }
    [[nodiscard]] DotAttributes cycle() const
    {
        return {{"color", kInk}, {"style", "solid"}, {"penwidth", fmt::format("{}", 1.6 * width())}};
    }
    [[nodiscard]] DotAttributes handle(std::size_t i) const
    {
        return {{"color", curveStyle(i % kHandleColors).color},
                {"style", i % 2 == 0 ? "solid" : "dashed"},
                {"penwidth", fmt::format("{}", width())}};
    }
    [[nodiscard]] DotAttributes other() const
    {
        return {{"color", kFaint}, {"style", "dotted"}, {"penwidth", fmt::format("{}", 0.7 * width())}};
    }

    void dress(std::size_t edge, const DotAttributes &look, const std::string &tooltip)
    {
        for (const auto &[name, value] : look)
            drawing_.setEdge(edge, name, value);
        drawing_.setEdge(edge, "tooltip", tooltip);
    }

    /// Blocks of three vertices and more, by their smallest vertex.
    std::vector<std::uint32_t> cyclicBlocks()
    {
        std::vector<std::uint32_t> cyclic;
        for (std::uint32_t block = 0; block < blocks_.count(); ++block)
            if (!blocks_.isEdge(block))
                cyclic.push_back(block);
        std::stable_sort(cyclic.begin(), cyclic.end(),
                         [this](std::uint32_t a, std::uint32_t b)
                         { return blocks_.vertices(a).front() < blocks_.vertices(b).front(); });
        severalBlocks_ = cyclic.size() > 1;
        return cyclic;
    }

    [[nodiscard]] std::size_t edgeIndex(Vertex a, Vertex b) const
    {
        const auto before = [](const Graph::Edge &left, const std::pair<Vertex, Vertex> &right)
        { return std::pair(left.a, left.b) < right; };
        return static_cast<std::size_t>(
            std::lower_bound(edges_.begin(), edges_.end(), std::minmax({a, b}), before) - edges_.begin());
    }

    void addBlock(std::uint32_t block)
    {
        const std::span<const Vertex> members = blocks_.vertices(block);
        const auto local = [&](Vertex v) {
            return static_cast<Vertex>(std::lower_bound(members.begin(), members.end(), v) - members.begin());
        };
        std::vector<Graph::Edge> inside;
        for (const Blocks::Edge &edge : blocks_.edges(block))
        {
            inside.push_back({local(edge.a), local(edge.b)});
            dress(edgeIndex(edge.a, edge.b), other(), "beside cycle and handles");
        }
        const auto graph = Graph::fromEdges(members.size(), inside);
        const EarDecomposition ears(*graph, shortCycle(*graph));

        const std::size_t number = ++parts_.blocks;
        const std::string name = severalBlocks_ ? fmt::format("B{}", number) : "";
        const std::string color = robotColor((number - 1) % kHandleColors);
        const auto mark = [&](Vertex v, const std::string &part, double share)
        {
            const Vertex member = members[v];
            labels_[member] = name + (name.empty() || part.empty() ? "" : " ") + part;
            drawing_.setVertex(member, "fillcolor", tint(color, share));
        };
        std::size_t used = 0;
        const auto follow =
            [&](std::span<const Vertex> path, const DotAttributes &look, const std::string &tooltip)
        {
            for (std::size_t i = 0; i + 1 < path.size(); ++i)
                dress(edgeIndex(members[path[i]], members[path[i + 1]]), look, tooltip);
            used += path.size() - 1;
        };

        const std::string inBlock = fmt::format(" of block {}", number);
        std::vector<Vertex> closed(ears.cycle().begin(), ears.cycle().end());
        closed.push_back(closed.front());
        follow(closed, cycle(), "first cycle" + inBlock);
        for (const Vertex v : ears.cycle())
            mark(v, "c", 0.55);
        for (std::size_t i = 0; i < ears.handleCount(); ++i)
        {
            follow(ears.handle(i), handle(i), fmt::format("handle {}", i + 1) + inBlock);
            for (const Vertex v : ears.interior(i))
                mark(v, fmt::format("h{}", i + 1), 0.2);
        }
        parts_.handles += ears.handleCount();
        parts_.otherEdges += inside.size() - used;
    }

    void addVertices()
    {
        for (Vertex v = 0; v < graph_.vertexCount(); ++v)
        {
            std::string tooltip = fmt::format("vertex {}", v);
            if (blocks_.isCutVertex(v))
            {
                ++parts_.cutVertices;
                tooltip += ", cut vertex";
                drawing_.setVertex(v, "shape", "square");
                drawing_.setVertex(v, "color", kInk);
                drawing_.setVertex(v, "penwidth", fmt::format("{}", 0.5 * drawing_.scale().ring));
            }
            if (!labels_[v].empty())
                tooltip += ", " + labels_[v];
            drawing_.setVertex(v, "tooltip", tooltip);
            if (!drawing_.scale().numbers)
                continue;
            drawing_.setVertex(v, "fontcolor", kInk);
            drawing_.setVertex(v, "label",
                               std::to_string(v) + (labels_[v].empty() ? "" : "\\n" + labels_[v]));
            if (severalBlocks_ && !labels_[v].empty())
                drawing_.setVertex(v, "fontsize", "7");
        }
    }

    void addLegend()
    {
        const bool numbers = drawing_.scale().numbers;
        if (parts_.isthmuses > 0)
            drawing_.explainEdge(isthmus(), "isthmus: an edge on no cycle");
        if (parts_.cutVertices > 0)
            drawing_.explainVertex({{"shape", "square"}, {"color", kInk}}, "cut vertex");
        if (parts_.blocks > 0)
            drawing_.explainEdge(cycle(), numbers ? "first cycle of a block (c)" : "first cycle of a block");
        if (parts_.handles > 0)
            drawing_.explainEdge(handle(0), numbers ? "handle, with its number (h1, h2, …)" : "handle");
        if (parts_.handles > 1)
            drawing_.explainEdge(handle(1), "every other handle, dashed");
        if (parts_.otherEdges > 0)
            drawing_.explainEdge(other(), "edge beside cycle and handles");
        if (severalBlocks_ && numbers)
            drawing_.explainVertex({{"fillcolor", tint(robotColor(0), 0.55)}},
                                   "block (B1, B2, …), a tint each");
    }
};

} // namespace

StructurePicture drawStructure(const Graph &graph, const Placement &placement, const std::string &title)
{
    return StructureDrawing(graph, placement).draw(title);
}

std::string describe(const GraphParts &parts)
{
    std::string text = parts.isthmuses == 0 ? "no isthmus" : counted(parts.isthmuses, "isthmus");
    if (parts.blocks == 0)
        text += ", no cycle";
    else if (parts.blocks == 1)
        text += ", 1 block: a cycle and " + counted(parts.handles, "handle");
    else
        text += fmt::format(", {} blocks: a cycle each and {} in all", parts.blocks,
                            counted(parts.handles, "handle"));
    if (parts.otherEdges > 0)
        text += ", " + counted(parts.otherEdges, "edge") + " beside them";
    if (parts.cutVertices > 0)
        text += ", " + counted(parts.cutVertices, "cut vertex");
    return text;
}

} // namespace mrpp

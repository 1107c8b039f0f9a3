#include "reports/layouts/GraphDrawing.h"

#include "reports/picture/Text.h"

#include <algorithm>
#include <fmt/format.h>

namespace mrpp
{

namespace
{

constexpr double kFont = 12;          // points
constexpr double kUnscaledUpTo = 700; // points: what is wider is made smaller to fit a page
constexpr double kLegendLine = 1.7;   // in sizes of the font, as all of these
constexpr double kSample = 2.4;
constexpr double kCharacter = 0.6;

std::string number(double value)
{
    return fmt::format("{:.2f}", value);
}

} // namespace

GraphDrawing::GraphDrawing(const Graph &graph, const Placement &placement)
    : scale_(drawingScale(graph.vertexCount())), extent_(extentOf(placement)),
      fontSize_(kFont * std::max(1.0, std::max(extent_.width, extent_.height) / kUnscaledUpTo)),
      legendBase_(-scale_.diameter / 2 - kLegendLine * fontSize_)
{
    using Kind = GraphvizGraph::Kind;
    const auto set = [this](Kind kind, const char *name, const std::string &value)
    { drawing_.setDefault(kind, name, value); };
    set(Kind::graph, "splines", "line");
    set(Kind::graph, "outputorder", "edgesfirst");
    set(Kind::graph, "bgcolor", "#ffffff");
    set(Kind::graph, "pad", "0.15");
    set(Kind::graph, "margin", "0");
    set(Kind::graph, "labelloc", "b");
    set(Kind::graph, "fontname", "DejaVu Sans");
    set(Kind::graph, "fontsize", number(fontSize_));
    set(Kind::graph, "fontcolor", "#202020");
    set(Kind::node, "shape", "circle");
    set(Kind::node, "fixedsize", "true");
    set(Kind::node, "style", "filled");
    set(Kind::node, "peripheries", "1");
    set(Kind::node, "fontname", "DejaVu Sans");
    set(Kind::node, "label", "");
    set(Kind::node, "width", inches(scale_.diameter));
    set(Kind::node, "height", inches(scale_.diameter));
    set(Kind::node, "fillcolor", "#ffffff");
    set(Kind::node, "color", "#9a9a9a");
    set(Kind::node, "penwidth", "1");
    set(Kind::node, "fontsize", "8");
    set(Kind::node, "fontcolor", "#8a8a8a");
    set(Kind::node, "pos", "0,0");
    set(Kind::node, "id", "");
    set(Kind::node, "tooltip", "");
    set(Kind::edge, "color", "#c4c4c4");
    set(Kind::edge, "style", "solid");
    set(Kind::edge, "penwidth", number(scale_.route));
    set(Kind::edge, "id", "");
    set(Kind::edge, "tooltip", "");

    for (Vertex v = 0; v < graph.vertexCount(); ++v)
    {
        drawing_.addNode();
        const Point &position = placement.positions[v];
        setVertex(v, "pos", number(position.x) + "," + number(position.y));
        setVertex(v, "id", fmt::format("vertex{}", v));
    }
    for (const Graph::Edge &edge : graph.edges())
    {
        const std::size_t added = drawing_.addEdge(edge.a, edge.b);
        setEdge(added, "id", fmt::format("edge{}-{}", edge.a, edge.b));
    }
}

void GraphDrawing::setVertex(Vertex v, const char *name, const std::string &value)
{
    drawing_.setNode(v, name, value);
}

void GraphDrawing::setEdge(std::size_t edge, const char *name, const std::string &value)
{
    drawing_.setEdge(edge, name, value);
}

void GraphDrawing::explainVertex(const DotAttributes &look, const std::string &meaning)
{
    const std::size_t node = legendNode(kSample / 2, {});
    drawing_.setNode(node, "width", inches(1.2 * fontSize_));
    drawing_.setNode(node, "height", inches(1.2 * fontSize_));
    for (const auto &[name, value] : look)
        drawing_.setNode(node, name, value);
    legendText(meaning);
}

void GraphDrawing::explainEdge(const DotAttributes &look, const std::string &meaning)
{
    const DotAttributes invisible = {{"style", "invis"}, {"width", "0"}, {"height", "0"}};
    const std::size_t left = legendNode(0, invisible);
    const std::size_t right = legendNode(kSample, invisible);
    const std::size_t edge = drawing_.addEdge(left, right);
    for (const auto &[name, value] : look)
        drawing_.setEdge(edge, name, value);
    legendText(meaning);
}

std::size_t GraphDrawing::legendNode(double x, const DotAttributes &look)
{
    const std::size_t node = drawing_.addNode();
    drawing_.setNode(node, "pos", number(x * fontSize_) + "," + number(legendBase_));
    for (const auto &[name, value] : look)
        drawing_.setNode(node, name, value);
    return node;
}

void GraphDrawing::legendText(const std::string &meaning)
{
    const double width = kCharacter * static_cast<double>(characterCount(meaning));
    const std::size_t node = legendNode(kSample + 1 + width / 2, {{"shape", "plaintext"},
                                                                  {"peripheries", "0"},
                                                                  {"width", inches(width * fontSize_)},
                                                                  {"fontsize", number(fontSize_)},
                                                                  {"fontcolor", "#202020"}});
    drawing_.setNode(node, "label", GraphvizGraph::escaped(meaning) + "\\l");
    legendBase_ -= kLegendLine * fontSize_;
}

Picture GraphDrawing::render(const std::string &title)
{
    constexpr double kPixels = 2400; // of large drawings; small ones have print's resolution
    const double inchesAcross = std::max({extent_.width, extent_.height, 72.0}) / 72;
    drawing_.setDefault(GraphvizGraph::Kind::graph, "label", GraphvizGraph::escaped("\n" + title));
    return drawing_.renderPinned(static_cast<int>(std::clamp(kPixels / inchesAcross, 72.0, 300.0)));
}

} // namespace mrpp

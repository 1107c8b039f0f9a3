#pragma once
/// \file
/// A graph that Graphviz draws at given places, with a legend and a title beneath. In the SVG every vertex
/// and edge is an element with an id and a tooltip.

#include "framework/model/Graph.h"
#include "reports/layouts/GraphvizGraph.h"
#include "reports/layouts/Placement.h"

#include <string>
#include <utility>
#include <vector>

namespace mrpp
{

using DotAttributes = std::vector<std::pair<const char *, std::string>>;

class GraphDrawing
{
public:
    /// \pre both outlive the drawing; at most kLargestGraph vertices
    GraphDrawing(const Graph &graph, const Placement &placement);

    [[nodiscard]] const DrawingScale &scale() const { return scale_; }

    /// An attribute of Graphviz. \param edge position in Graph::edges()
    void setVertex(Vertex v, const char *name, const std::string &value);
    void setEdge(std::size_t edge, const char *name, const std::string &value);

    /// A line of the legend, with a vertex or an edge that looks like this.
    void explainVertex(const DotAttributes &look, const std::string &meaning);
    void explainEdge(const DotAttributes &look, const std::string &meaning);

    /// Throws DrawingError where Graphviz fails.
    [[nodiscard]] Picture render(const std::string &title);

private:
    GraphvizGraph drawing_;
    DrawingScale scale_;
    Extent extent_;
    double fontSize_;       ///< points; more on large drawings, which are made smaller to fit a page
    double legendBase_ = 0; ///< height of the legend's next line

    std::size_t legendNode(double x, const DotAttributes &look);
    void legendText(const std::string &meaning);
};

} // namespace mrpp

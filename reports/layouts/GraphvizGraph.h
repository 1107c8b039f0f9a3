#pragma once
/// \file
/// Graphviz' programs, each run in a process of its own: where one crashes, hangs or eats memory, that costs
/// one picture. (Its libraries are not thread-safe, and take the whole program with them.) Drawings come back
/// as bytes.

#include "framework/model/Graph.h"
#include "reports/picture/Picture.h"

#include <chrono>
#include <memory>
#include <string>
#include <vector>

namespace mrpp
{

/// A length as most of Graphviz' attributes want it.
[[nodiscard]] std::string inches(double points);

/// An undirected graph to be drawn.
class GraphvizGraph
{
public:
    enum class Kind
    {
        graph,
        node,
        edge,
    };

    /// \param limit wall time of each of Graphviz' runs
    explicit GraphvizGraph(std::chrono::milliseconds limit = std::chrono::seconds(60));
    ~GraphvizGraph();
    GraphvizGraph(const GraphvizGraph &) = delete;
    GraphvizGraph &operator=(const GraphvizGraph &) = delete;

    /// An attribute of the graph, or of all nodes or edges to come. What nodes and edges set must have
    /// a default.
    void setDefault(Kind kind, const char *name, const std::string &value);

    /// Returns its index: 0, 1, ….
    std::size_t addNode();
    std::size_t addEdge(std::size_t a, std::size_t b);
    void setNode(std::size_t node, const char *name, const std::string &value);
    void setEdge(std::size_t edge, const char *name, const std::string &value);

    /// The nodes' positions (points, y upwards) that a layout engine chooses. Throws DrawingError.
    [[nodiscard]] std::vector<Point> arrange(const char *engine);

    /// Draws with the nodes where their attribute `pos` ("x,y" in points) says.
    /// \param resolution dots per inch of the PNG
    /// Throws DrawingError.
    [[nodiscard]] Picture renderPinned(int resolution);

    /// Text for a label in which neither backslashes (\\N, \\G, …) nor entities (&amp;) mean anything; line
    /// breaks stay line breaks.
    [[nodiscard]] static std::string escaped(const std::string &text);

private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace mrpp

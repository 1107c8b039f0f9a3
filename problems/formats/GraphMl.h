#pragma once
/// \file
/// Graphs as GraphML, the format of this program's own graphs and of many others' (`.graphml`, `.xml`, and,
/// after the MRPPSim paper's habit, `.gml`).
///
/// \code
/// <graphml xmlns="http://graphml.graphdrawing.org/xmlns">
///   <key id="key0" for="node" attr.name="Coordinate" attr.type="string"/>
///   <key id="key1" for="edge" attr.name="Weight" attr.type="double"/>
///   <graph id="G" edgedefault="undirected">
///     <node id="n0"><data key="key0">0 0 0</data></node>
///     <node id="n1"><data key="key0">1 0 0</data></node>
///     <edge id="e0" source="n0" target="n1"><data key="key1">1</data></edge>
///   </graph>
/// </graphml>
/// \endcode
///
/// A vertex's number is its position among the `<node>` elements, whatever its id. Coordinates come from a
/// node key named Coordinate, coords, pos or position (2 or 3 numbers), else from keys x, y and z, else from
/// yEd's geometry; weights from an edge key named Weight, length, distance or cost.

#include "framework/model/Graph.h"

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace mrpp
{

struct GraphMl
{
    std::shared_ptr<const Graph> graph;
    std::vector<std::string> warnings; ///< what was read but may not be what was meant, one sentence each
};

/// Reads a graph. Throws ParseError at the place of what is malformed: XML that is not well-formed, no
/// `<graphml>` or `<graph>`, several or nested graphs, hyperedges, ids that are missing or given twice, edges
/// to nodes that are not declared, coordinates and weights that are no numbers. Loops and parallel edges are
/// dropped, directed edges lose their direction, each with a warning. O(file).
[[nodiscard]] GraphMl readGraphMl(const std::filesystem::path &file);
/// \param file the name for messages
[[nodiscard]] GraphMl parseGraphMl(std::string_view text, const std::string &file);

/// The form of Fig. 1 of the MRPPSim paper; reading it gives the same graph again, numbers to the last bit.
[[nodiscard]] std::string formatGraphMl(const Graph &graph);

} // namespace mrpp

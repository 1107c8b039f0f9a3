#pragma once
/// \file
/// Graphs as plain text: DIMACS and lists of edges.
///
/// \code
/// c a triangle        # Nodes: 3 Edges: 3
/// p edge 3 3          0 1
/// e 1 2               1 2
/// e 2 3               0 2
/// e 1 3
/// \endcode
///
/// On the left DIMACS, whose vertices count from 1 (`p edge` or `p col` with `e` lines, of its second
/// challenge; `p sp` with `a from to weight` lines, of its ninth). On the right a list of edges, whose
/// vertices count from 0: two numbers and perhaps a weight a line, separated by blanks, tabs or commas,
/// comments behind `#` or `%`; NetworkX's `{'weight': 2.5}` is read, too. Neither has coordinates.

#include "framework/model/Graph.h"

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace mrpp
{

struct GraphText
{
    std::shared_ptr<const Graph> graph;
    std::vector<std::string> warnings;
};

/// Throws ParseError where a line breaks the grammar, the problem line is missing or comes twice, a vertex is
/// beyond those that it promises, or it promises more than fits the file. O(file + vertices).
[[nodiscard]] GraphText parseDimacs(std::string_view text, const std::string &file);

/// Edges of weight 1 as `p edge`, others as `p sp` with an arc each way.
[[nodiscard]] std::string formatDimacs(const Graph &graph);

/// The vertices are 0 to the largest number, or as many as a comment `# Nodes: 12` says (as in the files of
/// the Stanford Network Analysis Project). Throws ParseError where a line breaks the grammar or a vertex is
/// beyond what fits the file. O(file + vertices).
[[nodiscard]] GraphText parseEdgeList(std::string_view text, const std::string &file);

[[nodiscard]] std::string formatEdgeList(const Graph &graph);

} // namespace mrpp

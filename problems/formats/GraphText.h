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
/// comments behind `#` or `%`; NetworkX's `{'weight': 2.5}` is read, too. Matrix Market's sparse square
/// matrices are lists of edges with a header of their own. None has coordinates.

#include "framework/model/Graph.h"

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace mrpp
{

class TextReader;

struct GraphText
{
    std::shared_ptr<const Graph> graph;
    std::vector<std::string> warnings;
    std::vector<std::string> vertexNames; ///< where the file's numbers are not the vertices'; else empty
};

/// Throws ParseError where a line breaks the grammar, the problem line is missing or comes twice, a vertex is
/// beyond those that it promises, or it promises more than fits the file. O(file + vertices).
[[nodiscard]] GraphText parseDimacs(std::string_view text, const std::string &file);

/// Edges of weight 1 as `p edge`, others as `p sp` with an arc each way.
[[nodiscard]] std::string formatDimacs(const Graph &graph);

/// The vertices are 0 to the largest number, or as many as a comment `# Nodes: 12` says (as in the files of
/// the Stanford Network Analysis Project). Where the numbers have gaps, or do not begin with 0, they are kept
/// as names, with a warning. Throws ParseError where a line breaks the grammar, or what the lines say fits a
/// line of counts, METIS or a matrix as well. O(file + vertices).
[[nodiscard]] GraphText parseEdgeList(std::string_view text, const std::string &file);

/// \param vertexNames whole numbers that stand for the vertices; their own numbers where there are none
[[nodiscard]] std::string formatEdgeList(const Graph &graph,
                                         const std::vector<std::string> &vertexNames = {});

/// Whether formatEdgeList() can write these names so that they come back.
[[nodiscard]] bool fitsEdgeList(const Graph &graph, const std::vector<std::string> &vertexNames);

/// A square `coordinate` matrix, real, integer or pattern: row and column are joined where there is an entry,
/// whose value is the weight. Throws ParseError for other matrices, and as parseEdgeList() does. O(file +
/// rows).
[[nodiscard]] GraphText parseMatrixMarket(std::string_view text, const std::string &file);

// Internal to the readers of this folder.

/// A vertex without edges needs no bytes, so a number alone could ask for any memory.
[[nodiscard]] std::int64_t mostVertices(const TextReader &reader);

/// The graph, with warnings about what it leaves out. \param bothWays whether edges should be there in both
/// directions
[[nodiscard]] GraphText graphOfLines(std::size_t vertexCount, const std::vector<Graph::Edge> &edges,
                                     bool bothWays);

} // namespace mrpp

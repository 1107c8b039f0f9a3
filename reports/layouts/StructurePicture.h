#pragma once
/// \file
/// A picture of what a graph is put together from: isthmuses, and blocks, each a first cycle to which handles
/// are added one after another (framework/analysis/Blocks.h, EarDecomposition.h).

#include "framework/model/Graph.h"
#include "reports/layouts/Placement.h"
#include "reports/picture/Picture.h"

#include <cstddef>
#include <string>

namespace mrpp
{

/// What a graph consists of.
struct GraphParts
{
    std::size_t isthmuses = 0; ///< edges that lie on no cycle
    std::size_t blocks = 0;    ///< of three vertices and more
    std::size_t handles = 0;   ///< in all blocks
    std::size_t cutVertices = 0;
    std::size_t otherEdges = 0; ///< of blocks, between vertices that cycle and handles have brought in
};

struct StructurePicture
{
    Picture picture;
    GraphParts parts;
};

/// Nothing is told apart by colour alone: kinds of edges differ in their strokes, and blocks and handles have
/// numbers as long as vertices have. The same graph gives the same bytes. \pre at most kLargestGraph vertices
/// Throws DrawingError where Graphviz fails.
[[nodiscard]] StructurePicture drawStructure(const Graph &graph, const Placement &placement,
                                             const std::string &title);

/// "2 isthmuses, 1 block of a cycle and 3 handles, 2 cut vertices"
[[nodiscard]] std::string describe(const GraphParts &parts);

} // namespace mrpp

#pragma once
/// \file
/// Grids of cells, whole or with random obstacles (section III.B.4 of the MRPPSim paper, grid graph).
///
/// \code
/// - grid: {side: 10, free: 2}
/// - grid: {width: 32, height: 16, obstacles: 0.2, robots: 50}
/// \endcode
///
/// Promises: without obstacles exactly the W×H grid, numbered row by row (the paper's G((n−1)²−1, 4, 4) for
/// side n); with them ⌊obstacles · W · H⌋ blocked cells, and all free ones connected. Obstacles are taken one
/// after another from the leaves of a random spanning tree of the grid (SpanningTree.h), a random leaf at a
/// time, so that the rest of the tree always connects what is left. O(cells), nearly.

#include "problems/generators/Generator.h"

namespace mrpp
{

class Grid : public Generator
{
public:
    Grid();

    /// "grid 8×8", or "grid 8×8-0.2" with obstacles.
    [[nodiscard]] std::string name() const override;
    [[nodiscard]] std::shared_ptr<const Graph> makeGraph(Seed seed) const override;

protected:
    void checkParameters() const override;

private:
    [[nodiscard]] std::size_t width() const;
    [[nodiscard]] std::size_t height() const;

    std::int64_t side_ = 0; ///< 0: by width and height
    std::int64_t width_ = 0;
    std::int64_t height_ = 0;
    double obstacles_ = 0;
};

} // namespace mrpp

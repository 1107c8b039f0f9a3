#pragma once
/// \file
/// Lengths of shortest paths over the 8 neighbouring cells of a map: straight 1, diagonal √2, no corner cut
/// by a diagonal. What MovingAI's scenarios call the optimal length; never a bound for 4-connected moves.
///
/// Exact, by A* with the distance on an open map; where many are asked for and that visits much, with bounds
/// from eight landmarks, too (A. V. Goldberg, C. Harrelson, SODA 2005).

#include "framework/model/Instance.h"
#include "framework/system/Supervision.h"
#include "problems/formats/MovingAiMap.h"

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

namespace mrpp
{

/// Run many times on one map; a search costs what it visits. The map must outlive it.
class OctileDistances
{
public:
    /// O(cells).
    explicit OctileDistances(const GridMap &map);

    /// The length, or a negative number where there is no path. O(cells) at worst.
    [[nodiscard]] double distance(Vertex start, Vertex goal);

    /// Makes later searches in the largest component visit less. Eight searches of the map; 32 bytes a cell.
    void addLandmarks();

    /// Cells visited in all calls of distance() so far.
    [[nodiscard]] std::uint64_t visits() const { return visits_; }

private:
    using Cell = std::uint32_t;  ///< of the map with a frame of obstacles around it
    using Length = std::int64_t; ///< in billionths: sums compare as the true ones do up to 10^4 steps
    static constexpr Length kStraight = 1'000'000'000;
    static constexpr Length kDiagonal = 1'414'213'562;
    static constexpr Cell kNoCell = std::numeric_limits<Cell>::max();

    /// The best path to a cell so far.
    struct Label
    {
        std::uint32_t straight = 0;
        std::uint32_t diagonal = 0;
        std::uint32_t stamp = 0; ///< of the search that it belongs to

        [[nodiscard]] Length length() const { return straight * kStraight + diagonal * kDiagonal; }
    };
    struct Open
    {
        Cell cell;
        Length length; ///< of the path when it was put here
        Length total;  ///< with what is left at least
    };

    static constexpr std::size_t kLandmarks = 8;
    static constexpr Length kLandmarkUnit = 1'000'000;
    using Row = std::array<std::uint32_t, kLandmarks>; ///< lengths to the landmarks, rounded down to units

    [[nodiscard]] Cell cellOf(Vertex v) const;
    [[nodiscard]] Length estimate(Cell cell, Cell target) const;
    void search(Cell source, Cell target);
    void expand(Cell cell, Cell target);
    void reach(Cell cell, const Label &label, Cell target);

    const GridMap &map_;
    Cell width_; ///< of the framed map
    std::vector<char> free_;
    std::vector<Label> labels_;
    std::uint32_t stamp_ = 0;
    std::vector<Row> landmarks_; ///< by cell; empty without landmarks

    /// Cells by length + estimate, in a ring: a step adds less than three straight steps to that sum.
    static constexpr int kBucketBits = 26;
    static constexpr std::size_t kBuckets = 64;
    static_assert((std::size_t{kBuckets} << kBucketBits) > 3 * std::size_t{kStraight} + (1U << kBucketBits));
    std::array<std::vector<Open>, kBuckets> buckets_;
    std::size_t open_ = 0;
    Length best_ = 0;   ///< of the paths to the target so far
    Length bucket_ = 0; ///< the number of the one that is looked at
    std::uint64_t visits_ = 0;
};

/// The distances of all robots from start to goal, in their order; 0 where there is no path, and for those
/// that are left when the supervision says stop.
[[nodiscard]] std::vector<double> octileDistances(const GridMap &map, const Instance &instance,
                                                  const Supervision &supervision = {});

} // namespace mrpp

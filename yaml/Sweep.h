#pragma once
/// \file
/// Sweeps: a value of a plan that stands for many, and the problem points that follow from them.
///
/// A value may be one number, a list, `{from, to, step}` or `{from, to, factor}`, with `to` included where
/// the steps reach it. One swept number is the x axis of the figures; every other one, and every list of
/// texts or maps, makes a problem of its own.
///
/// \code
/// fg_vr: {graph: {grid: {side: [8, 16]}}, free: {from: 2, to: 10, step: 1}}   # two problems, nine points
/// each fr_vg: {graph: {biconnected: {handles: x, initial_cycle: x}}, occupancy: 0.9, x: [4, 8]} # one, two
/// points \endcode

#include "framework/Catalog.h"
#include "framework/plan/BenchmarkPlan.h"
#include "framework/support/Config.h"

#include <map>
#include <string>
#include <vector>

namespace mrpp
{

/// What one value, one sweep and one problem entry may grow to.
inline constexpr std::size_t kMaximalPoints = 1'000'000;

/// Whether the node is a map that means a range: it has `from` or `to`.
[[nodiscard]] bool isRange(const Config &node);

/// The values of `{from, to, step}` or `{from, to, factor}`, each standing at the range's place. Whole
/// numbers stay whole; others are exact to 12 digits, without drift. Throws PlanError where a key is missing
/// or unknown, a step is not positive, a factor is not above 1, `from` exceeds `to`, or there are more than
/// kMaximalPoints.
[[nodiscard]] std::vector<Config> rangeValues(const Config &range);

/// Where a plan says a problem point: the problem (under ""), and each of its settings by its key.
using PointPlaces = std::map<std::string, SourceLocation>;

/// All points of one entry of a plan's `problems`: a family's name and its settings.
///
/// Which sweep is the x axis: `x` or the first swept parameter of the graph where the family varies graphs,
/// else the number of robots where it is swept; else again `x` or the first one. A point's name is the
/// configured problem's, with what all names along the axis share, and with `key=value` of the other sweeps
/// where that alone tells two problems apart.
/// \param context its catalog must outlive the points
/// \param places where it is not null, it gets the places of each point
/// Throws PlanError.
[[nodiscard]] std::vector<ProblemPoint> expandProblem(const std::string &family, const SourceLocation &where,
                                                      const Config &settings, const ProblemContext &context,
                                                      std::vector<PointPlaces> *places = nullptr);

} // namespace mrpp

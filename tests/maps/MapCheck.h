#pragma once
/// \file
/// What the planners and their path search reach on any map: moves against the sum of the shortest
/// distances, time in breadth-first searches of the same map in the same run.

#include "framework/Planner.h"
#include "framework/model/Instance.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace mrpp::test
{

/// Every .map file below a folder, sorted by name.
[[nodiscard]] std::vector<std::filesystem::path> mapsBelow(const std::filesystem::path &folder);

/// Seconds of processor time that one breadth-first search from a vertex takes: the fastest of several.
[[nodiscard]] double searchSeconds(const Graph &graph, Vertex source);

struct PlanningFigures
{
    PlannerStatus status = PlannerStatus::unknown;
    std::string complaint;    ///< empty where the solution is valid
    std::size_t moves = 0;    ///< after redundancy removal
    double ratio = 0;         ///< moves by the sum of the shortest distances
    double searches = 0;      ///< time of solve() in breadth-first searches of the map
    double setupSearches = 0; ///< the same of setup()
};

/// \param limit wall seconds of solve()
[[nodiscard]] PlanningFigures measurePlanning(Planner &planner, std::shared_ptr<const Instance> instance,
                                              double limit);

struct PathFigures
{
    std::uint64_t length = 0;   ///< steps of all paths
    std::uint64_t distance = 0; ///< steps of shortest paths
    std::uint64_t visits = 0;   ///< vertices that the searches looked at
    double searches = 0;        ///< time in breadth-first searches of the map
    std::size_t broken = 0;     ///< paths that are longer than the weight promises, or no paths
};

/// One path after another from each robot's start to its goal, over an empty map.
/// \param weight of all searches; 0: what PathFinder learns
[[nodiscard]] PathFigures measurePaths(const Instance &instance, double weight);

} // namespace mrpp::test

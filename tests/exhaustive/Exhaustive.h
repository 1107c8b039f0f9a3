#pragma once
/// \file
/// Every instance there is on small graphs, and many random ones on larger graphs: the oracle against brute
/// force, and every registered planner against both.

#include "framework/Catalog.h"

#include <atomic>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace mrpp::test
{

struct ExhaustiveSettings
{
    std::size_t vertices = 7; ///< graphs of 1 … that many
    std::size_t threads = 2;
    std::uint64_t every = 1;                ///< planners get every so-manieth instance of each graph
    std::uint64_t reasons = 1;              ///< so do the reasons' checks on graphs of the largest size
    std::uint64_t random = 0;               ///< random instances of each rule
    std::uint64_t first = 0;                ///< of the instances that the planners get
    bool oracle = true;                     ///< else only planners are checked
    std::vector<std::string> planners = {}; ///< all that are complete where empty
    /// Called with graphs that are done, or batches of random instances, by one thread at a time.
    std::function<void(std::size_t done, std::size_t all)> progress = {};
};

struct PlannerTally
{
    std::uint64_t solved = 0;
    std::uint64_t infeasible = 0; ///< and it was
    std::uint64_t unsolved = 0;   ///< unsolvable instances that it ended on in another way
    std::uint64_t rejected = 0;   ///< not its class
    std::uint64_t failures = 0;
};

struct ExhaustiveResult
{
    std::uint64_t graphs = 0;
    std::uint64_t instances = 0; ///< of both rules
    std::uint64_t solvable = 0;
    std::uint64_t reasons = 0; ///< checked by brute force
    std::map<std::string, PlannerTally> planners;
    std::uint64_t failures = 0;            ///< of oracle, reasons and planners together
    std::vector<std::string> descriptions; ///< of the first failures
};

/// All connected graphs up to isomorphism, 0 to all vertices free, both flavours of motion; starts in every
/// order on every set of vertices, goals on every set of vertices (their robots' names are free), up to the
/// graph's symmetries.
///
/// The oracle has to agree with brute force and its reasons have to be true. A planner has to solve what is
/// solvable unless it rejects it, with a solution that the validator takes, and must not solve the rest;
/// where it proves infeasibility it has to say so.
[[nodiscard]] ExhaustiveResult checkSmallGraphs(const Catalog &catalog, const ExhaustiveSettings &settings);

/// Instances that moves of one robot at a time have scrambled, on trees, sparse graphs, dumbbells, trees with
/// cycle leaves, biconnected graphs and grids of up to 150 vertices with 1 to 6 free: each planner has to
/// solve each that it does not reject. For every fifth of them another one that rotations have scrambled,
/// too, and one with goals of chance, where planners and oracle have to agree.
[[nodiscard]] ExhaustiveResult checkRandomInstances(const Catalog &catalog,
                                                    const ExhaustiveSettings &settings);

/// Lines that a person can read.
[[nodiscard]] std::string describe(const ExhaustiveResult &result);

} // namespace mrpp::test

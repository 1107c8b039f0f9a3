#pragma once
/// \file
/// What Push and Rotate and Push and Spin have in common: one subgraph after another, with the trail, in an
/// order that may be left to chance; a local search among such orders where restarts are asked for; and a
/// certain way home where the main loop gets stuck. They differ in the motion rule and in their operations.
///
/// Complexity: setup O(V + E); then one path search a robot plus what pushes and swaps touch. Memory O(V + E
/// + moves).

#include "algorithms/RestartingPlanner.h"
#include "algorithms/pebble/PebbleBoard.h"
#include "algorithms/pebble/Priorities.h"
#include "algorithms/pebble/TrailLoop.h"
#include "algorithms/pebble/Transpositions.h"
#include "algorithms/search/PathFinder.h"
#include "framework/analysis/Blocks.h"
#include "framework/analysis/Components.h"
#include "framework/analysis/Landmarks.h"
#include "framework/analysis/Solvability.h"
#include "framework/analysis/Subgraphs.h"

#include <atomic>
#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace mrpp
{

class TrailPlanner : public RestartingPlanner
{
public:
    void setup() override;
    void clear() override;
    [[nodiscard]] bool usesChance() const override
    {
        return order_ == "random" || RestartingPlanner::usesChance();
    }

protected:
    /// Everything that does not depend on an attempt's choices; read by several threads.
    struct Preparation
    {
        /// The termination condition ends the question whether there is a solution; then nobody may solve.
        Preparation(const Instance &instance, MotionRule rule, Landmarks landmarksOfGraph,
                    Blocks blocksOfGraph, const TerminationCondition &ptc);
        [[nodiscard]] bool isObviouslySolvable(const Instance &instance, const Components &components) const;

        Landmarks landmarks;
        Blocks blocks;
        Subgraphs subgraphs;
        std::vector<std::uint32_t> assignment; ///< of robots to subgraphs
        SubgraphPriorities priorities;
        std::vector<char> unswappable; ///< nonzero for robots on a path or a polygon
        std::vector<Robot> farFirst;   ///< an order of all robots
        const Blocks *confining;       ///< the blocks where paths are looked for in them, else null
        std::size_t vertices = 0;      ///< of the components with robots
        Solvability verdict;
    };

    /// What the main loop leaves open.
    struct Choices
    {
        std::vector<Robot> order; ///< before the subgraphs' priorities
        TrailSettings settings;
    };

    /// What one run of the main loop, or of the certain way, is to do.
    struct Run
    {
        const Choices *choices; ///< null: the certain way
        Random *random;         ///< breaks ties; null: the vertices' numbers do
        const TerminationCondition &ptc;
    };

    explicit TrailPlanner(PlannerSpecs specs);

    /// Makes a board and the planner's operations, and hands them to runWith().
    [[nodiscard]] virtual Outcome start(const Run &run) const = 0;

    template <class Operations>
    [[nodiscard]] Outcome runWith(PebbleBoard &board, Operations &operations, const Run &run) const;

    [[nodiscard]] const Preparation &prepared() const { return *prepared_; }

private:
    Outcome attempt(std::uint64_t number, const TerminationCondition &ptc) const override;
    [[nodiscard]] TrailSettings settings() const;
    [[nodiscard]] Choices firstChoices(Random &random) const;
    [[nodiscard]] Choices randomChoices(Random &random) const;
    Outcome runMainLoop(const Choices &choices, Random *random, const TerminationCondition &ptc) const;
    Outcome fallBack(const TerminationCondition &ptc) const;
    Outcome searchNearby(Random &random, const TerminationCondition &ptc) const;
    [[nodiscard]] std::vector<Robot> unswappableRobots() const;
    [[nodiscard]] std::size_t lengthWithoutRedundancy(const Outcome &outcome,
                                                      const TerminationCondition &ptc) const;

    std::string order_ = "far_first";
    std::int64_t swapPrice_ = 10;
    std::unique_ptr<const Preparation> prepared_;
    /// Attempts after the first are given up when they are longer.
    mutable std::atomic<std::size_t> mostMoves_ = std::numeric_limits<std::size_t>::max();
    mutable std::atomic<std::uint64_t> fallbacks_ = 0;
};

template <class Operations>
RestartingPlanner::Outcome TrailPlanner::runWith(PebbleBoard &board, Operations &operations,
                                                 const Run &run) const
{
    operations.restrictSwaps(prepared_->subgraphs, prepared_->assignment);
    operations.setRandom(run.random);
    // On large graphs arranging the memory takes time.
    const auto stopped = [] { return Outcome{PlannerStatus::timeout, {}, {}}; };
    if (run.ptc())
        return stopped();
    PathFinder paths(graph(), prepared_->landmarks);
    using Loop = TrailLoop<Operations>;
    if (run.choices == nullptr)
    {
        // On paths and polygons nobody can be swapped, and the main loop always works.
        Loop loop(instance(), board, operations, paths, run.ptc,
                  {.blocks = prepared_->confining, .unswappable = &prepared_->unswappable});
        Transpositions transpositions(instance(), board, operations, prepared_->assignment, run.ptc);
        if (loop.run(unswappableRobots()) == Loop::End::solved && transpositions.run())
            return {PlannerStatus::solved, {}, board.takeSolution()};
        if (run.ptc())
            return stopped();
        return {PlannerStatus::gave_up, "a swap within a subgraph failed", {}};
    }
    if (run.ptc())
        return stopped();
    const std::vector<Robot> order = prepared_->priorities.arrange(run.choices->order);
    if (run.ptc())
        return stopped();
    Loop loop(instance(), board, operations, paths, run.ptc, run.choices->settings);
    switch (loop.run(order))
    {
    case Loop::End::solved:
        return {PlannerStatus::solved, {}, board.takeSolution()};
    case Loop::End::stopped:
        return stopped();
    case Loop::End::stuck:
        break;
    }
    return {PlannerStatus::gave_up, loop.reason(), {}};
}

} // namespace mrpp

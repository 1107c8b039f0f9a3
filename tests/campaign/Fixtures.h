#pragma once
/// \file
/// A tiny problem family, planners that behave and misbehave, and plans of them.

#include "framework/Catalog.h"
#include "framework/plan/BenchmarkPlan.h"
#include "framework/run/RunRecord.h"
#include "framework/store/ResultTable.h"

#include <filesystem>
#include <string>
#include <vector>

namespace mrpp::fixtures
{

/// A grid of `rows` × `length` in which robot i goes along row i, from one random column to another. Also
/// depends on the contents of `file`, if it is set.
class Lanes final : public Problem
{
public:
    Lanes();
    [[nodiscard]] std::string name() const override { return "lanes"; }
    void check() const override;
    [[nodiscard]] std::vector<std::filesystem::path> inputFiles() const override;
    [[nodiscard]] std::shared_ptr<const Graph> makeGraph(Seed seed) const override;
    [[nodiscard]] Instance makeInstance(std::shared_ptr<const Graph> graph, std::size_t robots,
                                        Seed seed) const override;

private:
    std::int64_t rows_ = 3;
    std::int64_t length_ = 8;
    std::filesystem::path file_;
};

/// Solves Lanes; each robot goes straight to its goal, the first one after `detours` steps to and fro, and
/// all of it after `pause` seconds.
class Walker : public Planner
{
public:
    Walker();
    PlannerStatus solve(const TerminationCondition &ptc) override;

private:
    std::int64_t detours_ = 0;
    double pause_ = 0;
};

/// walker; thrower, ball_thrower (no std::exception), setup_thrower, eater (std::bad_alloc), hanger (until it
/// is told to stop), sleeper (deaf for 0.3 s), quitter, liar (claims an empty solution), jumper (an illegal
/// move), half (partial), bad_half (partial and illegal), prover (infeasible), picky (rejects), turner (needs
/// rotations), shrugger (unknown). Optimizers: trimmer (drops moves to and fro), breaker, stretcher, failing.
[[nodiscard]] Catalog catalog();

/// A point of Lanes with that many robots.
[[nodiscard]] ProblemPoint lanes(std::int64_t robots, const std::filesystem::path &file = {});

/// A plan of Lanes with 1, 2 and 3 robots.
[[nodiscard]] BenchmarkPlan plan(const std::vector<std::string> &planners, std::int64_t repetitions = 2);

/// A row with everything but times, memory and attempts, for comparisons.
[[nodiscard]] std::string timeless(RunRecord record);

/// The table of the campaign in that folder, and the rows of it, timeless.
[[nodiscard]] ResultTable table(const BenchmarkPlan &plan, const std::filesystem::path &folder);
[[nodiscard]] std::vector<std::string> rows(const BenchmarkPlan &plan, const std::filesystem::path &folder);

/// An empty folder that is removed at the end.
class TemporaryFolder
{
public:
    TemporaryFolder();
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder &) = delete;
    TemporaryFolder &operator=(const TemporaryFolder &) = delete;

    [[nodiscard]] const std::filesystem::path &path() const { return path_; }

private:
    std::filesystem::path path_;
};

} // namespace mrpp::fixtures

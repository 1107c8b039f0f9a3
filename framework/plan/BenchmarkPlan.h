#pragma once
/// \file
/// A plan after reading: problems with their sweeps resolved, planners with their settings, and how to run
/// them; and the runs that follow from it.

#include "framework/Planner.h"
#include "framework/Problem.h"
#include "framework/model/MotionRule.h"
#include "framework/outside/OutsideCommand.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace mrpp
{

/// Per-run limits.
struct Limits
{
    double time = 60;     ///< seconds, wall, of solve()
    double memory = 4096; ///< MB (10^6 bytes)

    /// Seconds of all cores together that solve() and the processes that it starts may take; none by default.
    std::optional<double> cpu = {};
};

/// A name and its settings: a planner or an optimizer of a plan.
struct Configured
{
    std::string kind;                                          ///< registered name; "command"
    std::string name;                                          ///< in results and figures; unique in the plan
    std::vector<std::pair<std::string, std::string>> settings; ///< parameter, value

    /// Every parameter with its value, defaults included, and the algorithm's version under kVersionSetting:
    /// what the program would run. See resolve().
    std::vector<std::pair<std::string, std::string>> effective = {};

    std::shared_ptr<const OutsideCommand> command = {}; ///< of an outside planner; else null

    MotionRule motion = MotionRule::pebble; ///< that a planner's solutions need, see resolve()
};

/// No parameter has such a name.
inline constexpr const char *kVersionSetting = "(version)";

/// One point of a sweep (or a problem without one).
struct ProblemPoint
{
    std::string model;                      ///< registered family: "public_benchmark"
    std::shared_ptr<const Problem> problem; ///< configured
    std::string name;                       ///< problem column; the same for all points of one sweep
    std::string sweepVariable;              ///< "robots", "side", …; empty where nothing is swept
    std::optional<double> sweepValue;
    std::string settings; ///< canonical, with the number of robots
    std::string defaults; ///< the family's version and the defaults that the settings leave, see resolve()
};

/// How the runs are executed.
struct Execution
{
    std::int64_t jobs = 1;
    std::int64_t timingRepeats = 1;    ///< how often solve() is timed; 1 or more
    std::int64_t warmUp = 0;           ///< how often it runs before that
    std::string isolation = "process"; ///< "process": in workers; "none": in the campaign's own process
};

/// What a campaign's folder keeps beside its results.
struct Keep
{
    bool instances = false; ///< instances/CASE.graphml and .instance
    bool solutions = false; ///< solutions/CASE.PLANNER.csv
};

/// A figure that a plan asks for.
struct ChartRequest
{
    std::string kind = "curves"; ///< curves, cactus, profile, ecdf, boxes, scatter, ranks, scaling
    std::string x;               ///< of curves: a numeric column or a swept variable; of scaling: a column
    std::string y;               ///< a numeric column
    std::string per;     ///< of curves: a column; a curve for each of its values. Empty: one a planner
    std::string problem; ///< a problem's or a family's name; empty: all
    std::string title;   ///< empty: a title of its own
    std::pair<std::string, std::string> planners; ///< of scatter
    std::optional<bool> logX;                     ///< nothing: logarithmic where that serves
    std::optional<bool> logY;
};

/// Which solutions the explorer (report.html) can play.
struct ExplorerChoice
{
    std::string solutions = "first"; ///< of each point's first repetition; "all"; "none"
    double size = 10;                ///< MB of the page, at most, for solutions and their graphs
};

struct BenchmarkPlan
{
    std::string campaign;
    Seed seed = 1;
    std::int64_t repetitions = 1;
    Limits limits;
    std::vector<ProblemPoint> points;
    std::vector<Configured> planners;
    std::vector<Configured> optimizers;
    std::vector<std::string> reports;
    std::vector<ChartRequest> charts; ///< figures asked for
    bool automaticCharts = true;      ///< whether there are figures beside those
    MotionRule motion = MotionRule::rotation;
    Execution execution;
    Keep keep;
    ExplorerChoice explorer;
    std::string text;           ///< the plan file, verbatim
    std::filesystem::path file; ///< where it was read
    std::vector<std::filesystem::path>
        mapFolders; ///< where its relative files are looked for beside its folder
};

/// One run before it happens. Indices are into the plan.
struct RunSpec
{
    std::size_t point = 0;
    std::size_t planner = 0;
    std::int64_t repetition = 0;
    Seed graphSeed = 0;
    Seed instanceSeed = 0;
    Seed plannerSeed = 0;

    /// Unique among the plan's cases, each of its parts a safe file name: "small_benchmark/tree/0",
    /// "public_benchmark/room/robots=20/0". Of points that would read alike, the second gets "#2".
    std::string caseId;

    /// Changes with anything that the result may depend on: effective settings, versions of algorithms,
    /// seeds, input files' contents, limits, optimizers, motion rule, timing repeats; not with names, order,
    /// jobs or other runs. A question that the plan asks twice (two entries with the same settings) is
    /// measured twice: the second has a key of its own.
    std::string runKey;

    /// The same without what the program brings: defaults and versions. Tells which question of the plan an
    /// older program answered.
    std::string planKey;
};

/// Runs with the same key share one graph.
[[nodiscard]] std::string graphKey(const BenchmarkPlan &plan, const RunSpec &spec);

/// What expand() does about an input file that is gone.
enum class MissingInput
{
    refuse,   ///< throws FileError: nothing can run
    tolerate, ///< leaves the keys of its runs empty: old results can still be shown
};

/// What tells a problem point from the plan's others.
struct PointIdentity
{
    std::string id;                    ///< a case id without its repetition
    std::optional<std::string> inputs; ///< a hash of its input files; nothing where one is missing
};

/// One a point. Reads the problems' input files.
[[nodiscard]] std::vector<PointIdentity> identifyPoints(const BenchmarkPlan &plan, MissingInput missing);

/// Every run of the plan, in the plan's order: by problem point, repetition, planner. Seeds derive from the
/// campaign's seed, the problem and the repetition, never from the planner. Reads the problems' input files
/// (for the keys).
[[nodiscard]] std::vector<RunSpec> expand(const BenchmarkPlan &plan,
                                          MissingInput missing = MissingInput::refuse);

/// The problem's instance on that graph, with the number of robots that it says. Throws InputError where the
/// graph cannot hold them or what comes out is malformed.
[[nodiscard]] Instance makeInstance(const Problem &problem, std::shared_ptr<const Graph> graph, Seed seed);

} // namespace mrpp

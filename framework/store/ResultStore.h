#pragma once
/// \file
/// Where finished runs are kept: one SQLite file, durable run by run, in a schema that OMPL's Planner Arena
/// opens (tables experiments, plannerConfigs, enums, runs, progress; an experiment is one problem at one
/// sweep point).
///
/// While a campaign runs the file is in write-ahead mode (where the file system can do that): a report can
/// read it, and the helper files beside it
/// (-wal, -shm) belong to it. They are folded in when the campaign ends, and when one that was killed goes on
/// and ends. One computer at a time: on a network file system
/// give each shard a folder of its own.

#include "framework/model/Solution.h"
#include "framework/plan/BenchmarkPlan.h"
#include "framework/plan/RunKey.h"
#include "framework/plan/RunKeyMap.h"
#include "framework/run/ProgressSampler.h"
#include "framework/run/RunRecord.h"
#include "framework/store/Provenance.h"

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

namespace mrpp
{

/// What is kept of a run.
struct FinishedRun
{
    RunRecord record;
    Solution solution;
    Progress progress;
};

/// What the newest runs of each problem point and of each planner depended on.
struct AskedParts
{
    std::map<std::string, KeyParts> points;   ///< by case without its repetition: experimentParts()
    std::map<std::string, KeyParts> planners; ///< by name: plannerParts()
};

class ResultStore
{
public:
    enum class Access
    {
        read,  ///< also while another process writes
        write, ///< one process at a time: FileError where another holds the folder
    };

    /// Opens DIR/results.sqlite; with `write` makes it where missing. Throws FileError where it cannot be
    /// opened, is no store, or is of a newer version.
    ResultStore(const std::filesystem::path &folder, Access access);
    ~ResultStore();
    ResultStore(const ResultStore &) = delete;
    ResultStore &operator=(const ResultStore &) = delete;

    /// What the folder's file system lacks and what that means, in sentences; usually nothing.
    [[nodiscard]] std::vector<std::string> notes() const;

    /// What the runs to come belong to: limits and planners' settings, kept with them for other tools.
    void describe(const BenchmarkPlan &plan, const Provenance &provenance);

    /// Keys of the finished runs, and how each ended.
    [[nodiscard]] RunKeyMap<PlannerStatus> finishedRuns() const;
    /// The keys that begin so.
    [[nodiscard]] std::set<std::string> finishedKeys(const std::string &beginning = "") const;

    /// Notes that a run begins; returns how often it began, this time included. Survives the death of this
    /// process, but is not forced to the disk. Several threads may call it at once, and while another adds.
    std::int64_t begin(const std::string &runKey);

    /// Keeps a finished run (and its solution, where that is no more than 4 MiB packed). On return it is on
    /// disk. A run that is there already stays as it is. Throws InputError where an extra column has the name
    /// of another, and FileError where the disk is full or the folder is gone; then the store is as before.
    void add(const RunRecord &record, const Solution &solution, const Progress &progress = {});

    /// All of them, or after a failure none.
    void add(std::span<const FinishedRun> runs);

    /// All finished runs, in the order in which they were kept.
    [[nodiscard]] std::vector<RunRecord> records() const;

    /// One of them; nothing where there is no such run.
    [[nodiscard]] std::optional<RunRecord> record(const std::string &runKey) const;

    /// The plan that a finished run belongs to, verbatim; nothing where there is no such run.
    [[nodiscard]] std::optional<std::string> planText(const std::string &runKey) const;

    /// A run's solution, where it was kept. Throws FileError where it is damaged.
    [[nodiscard]] std::optional<Solution> solution(const std::string &runKey) const;

    /// What a run's progress properties were over time; those that it never had are left out.
    [[nodiscard]] Progress progress(const std::string &runKey) const;

    /// How often each unfinished run has begun.
    [[nodiscard]] std::unordered_map<std::string, std::int64_t> unfinishedAttempts() const;

    /// What the newest run of each question() depended on: see campaignParts(), pointParts(), plannerParts().
    [[nodiscard]] std::unordered_map<std::string, KeyParts> askedBefore() const;

    /// The same by problem point and by planner. Stores of older programs may know nothing of it.
    [[nodiscard]] AskedParts askedParts() const;

    /// A case and a planner's name as one text.
    [[nodiscard]] static std::string question(const std::string &caseId, const std::string &planner);

private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace mrpp

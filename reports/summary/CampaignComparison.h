#pragma once
/// \file
/// Two campaigns told apart: what became better or worse from the first to the second, run by run on the same
/// instances, and whether that may be chance.

#include "framework/statistics/PairedComparison.h"
#include "framework/store/Provenance.h"
#include "framework/store/ResultTable.h"

#include <optional>
#include <string>
#include <vector>

namespace mrpp
{

/// A measure of one planner on one problem (or on all of them) in both campaigns, over distinct instances.
struct ComparedMeasure
{
    std::string planner;
    std::string rule;          ///< the motion rule of its solutions
    std::string problem;       ///< empty: all
    std::string column;        ///< path_length, makespan, time; kAnswered, kAnsweredClearly
    PairedComparison costs;    ///< now over before; not of answers
    std::size_t onlyFirst = 0; ///< of answers: instances that only the first campaign solved or proved
    std::size_t onlySecond = 0;
    std::optional<double> p; ///< Holm's correction over all tests; nothing where there are too few pairs
    std::string refusal;     ///< why not

    enum class Verdict
    {
        same, ///< or not shown to differ
        better,
        worse,
        unclear, ///< it differs, but ranks and median ratio (or the instances won) say opposite things
    };
    Verdict verdict = Verdict::same;

    /// Instances that were solved, or proved to have no solution.
    static constexpr const char *kAnswered = "solved";
    /// The same without those that the time limit may have decided by chance
    /// (ComparisonOptions::flappingFrom).
    static constexpr const char *kAnsweredClearly = "solved, off the limit";
    [[nodiscard]] bool isCost() const { return column != kAnswered && column != kAnsweredClearly; }
    /// How many pairs differ: what a test is made of.
    [[nodiscard]] std::size_t differing() const;
    /// "push_and_swap on grid: time 1.32 times as long (…)".
    [[nodiscard]] std::string sentence() const;
};

/// One run that ended otherwise, or cost something else.
struct ComparedRun
{
    const RunRecord *first = nullptr;
    const RunRecord *second = nullptr;
    bool flaps = false; ///< one timed out, and the other nearly did
};

struct CampaignComparison
{
    std::size_t pairs = 0;     ///< runs of the same planner on the same instance in both
    std::size_t onlyFirst = 0; ///< runs without a partner
    std::size_t onlySecond = 0;
    std::size_t otherInstances = 0; ///< pairs left out: the same case, but another instance
    std::size_t instances = 0;      ///< of a planner, each: copies of an instance are one pair
    std::size_t flapping = 0;       ///< pairs where one timed out and the other nearly did
    std::vector<ComparedMeasure> measures;
    std::vector<ComparedRun> changedEnds;  ///< answered in one campaign alone
    std::vector<ComparedRun> newlyInvalid; ///< defects: a wrong answer or a crash where there was a solution

    /// Whether something became worse beyond chance, or there is a new defect.
    [[nodiscard]] bool hasRegression() const;
};

struct ComparisonOptions
{
    double timeTolerance =
        0.1; ///< by which median times may differ before that counts, however surely they do
    double flappingFrom = 0.5; ///< of the time limit: solved runs that took longer may as well have timed out
};

/// Pairs runs by case and planner, and tests answers to distinct instances. Flips near the time limit are
/// tested like all others (and the others once more without them): chance makes as many of them one way as
/// the other. A planner is tested on each problem, and on all of them where that is not the same test. \pre
/// the tables outlive the comparison. O(runs · log runs + tests).
[[nodiscard]] CampaignComparison compareCampaigns(const ResultTable &first, const ResultTable &second,
                                                  const ComparisonOptions &options = {});

/// comparison.csv: a row a measure.
[[nodiscard]] std::string comparisonCsv(const CampaignComparison &comparison);

/// comparison.pdf: where both come from, what differs between them (campaignDifferences()), what changed, all
/// tests.
[[nodiscard]] std::string comparisonPdf(const CampaignComparison &comparison,
                                        const std::vector<std::string> &differences, const Provenance &first,
                                        const Provenance &second);

} // namespace mrpp

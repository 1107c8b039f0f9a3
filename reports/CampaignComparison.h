#pragma once
/// \file
/// Two campaigns told apart: what became better or worse from the first to the second, run by run on the same
/// instances, and whether that may be chance.

#include "framework/campaign/Provenance.h"
#include "framework/campaign/ResultTable.h"
#include "framework/support/PairedComparison.h"

#include <optional>
#include <string>
#include <vector>

namespace mrpp
{

/// A measure of one planner on one problem (or on all of them) in both campaigns.
struct ComparedMeasure
{
    std::string planner;
    std::string problem;       ///< empty: all
    std::string column;        ///< path_length, makespan, time; "solved" for the share of solved runs
    PairedComparison costs;    ///< first over second: not of "solved"
    std::size_t onlyFirst = 0; ///< of "solved": runs that only the first campaign solved
    std::size_t onlySecond = 0;
    std::optional<double> p; ///< Holm's correction over all tests; nothing where there are too few pairs
    std::string refusal;     ///< why not

    enum class Verdict
    {
        same, ///< or not shown to differ
        better,
        worse,
    };
    Verdict verdict = Verdict::same;
    /// "push_and_swap on grid: time 1.32 times as long (…)".
    [[nodiscard]] std::string sentence() const;
};

/// One run that ended otherwise, or cost something else.
struct ComparedRun
{
    const RunRecord *first = nullptr;
    const RunRecord *second = nullptr;
};

struct CampaignComparison
{
    std::size_t pairs = 0;     ///< runs of the same planner on the same instance in both
    std::size_t onlyFirst = 0; ///< runs without a partner
    std::size_t onlySecond = 0;
    std::size_t otherInstances = 0; ///< pairs left out: the same case, but another instance
    std::size_t flapping = 0;       ///< pairs where one timed out and the other nearly did: no change
    std::vector<ComparedMeasure> measures;
    std::vector<ComparedRun> changedEnds;  ///< solved in one campaign alone, flapping ones left out
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

/// Pairs runs by case and planner. \pre the tables outlive the comparison. O(runs · log runs + tests).
[[nodiscard]] CampaignComparison compareCampaigns(const ResultTable &first, const ResultTable &second,
                                                  const ComparisonOptions &options = {});

/// comparison.csv: a row a measure.
[[nodiscard]] std::string comparisonCsv(const CampaignComparison &comparison);

/// comparison.pdf: where both come from, what changed, all tests.
[[nodiscard]] std::string comparisonPdf(const CampaignComparison &comparison, const Provenance &first,
                                        const Provenance &second);

} // namespace mrpp

#pragma once
/// \file
/// What a run is known by: a key over everything that its result may depend on. Each part of it has a name,
/// so that a changed key can be explained (`mrppsim run --why`).

#include "framework/plan/BenchmarkPlan.h"
#include "framework/plan/InputIdentity.h"

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace mrpp
{

/// Names and values: ("time limit", "60"), ("parameter order", "random"), ….
using KeyParts = std::vector<std::pair<std::string, std::string>>;

/// What all runs of a plan share: limits, motion rule, optimizers, how often solve() is timed.
[[nodiscard]] KeyParts campaignParts(const BenchmarkPlan &plan);

/// What all runs of a problem point share: the family with its settings, its version and defaults, and the
/// contents of its input files (`inputs`, a hash of them).
[[nodiscard]] KeyParts pointParts(const ProblemPoint &point, const std::string &inputs);

/// The kind of planner, the version of its algorithm, its effective parameters, and the files that an outside
/// program's answers depend on (identifyPlanners()).
[[nodiscard]] KeyParts plannerParts(const Configured &planner, const FileHashes &files);

/// pointParts() and campaignParts() of the plan's point number `point`, and the campaign's seed.
[[nodiscard]] KeyParts experimentParts(const BenchmarkPlan &plan, std::size_t point,
                                       const std::string &inputs);

/// One part a line, and back; line breaks in a value are written as `\\n`.
[[nodiscard]] std::string toText(const KeyParts &parts);
[[nodiscard]] KeyParts keyParts(const std::string &text);

/// What differs, in words: "time limit was 60, is 30; optimizers …". Empty where nothing does.
[[nodiscard]] std::string differences(const KeyParts &before, const KeyParts &now);

/// The keys of a plan's runs. Each part is hashed once.
class RunKeys
{
public:
    /// \param plan must outlive the object
    explicit RunKeys(const BenchmarkPlan &plan);

    /// The runs that follow are of this point. \param inputs a hash of its input files
    void enter(const ProblemPoint &point, const std::string &inputs);

    /// Sets runKey and planKey from the spec's seeds and planner. What the plan asks several times has a key
    /// of its own each time.
    void set(RunSpec &spec) const;

private:
    /// Hashes of one part: as the program runs it, and as the plan says it.
    struct Hashes
    {
        std::string run;
        std::string plan;
    };

    Hashes campaign_;
    Hashes point_;
    std::vector<Hashes> planners_;
    std::vector<std::uint64_t> earlierPlanners_;  ///< of each: how many before it are the same
    std::vector<std::uint64_t> samePlanners_;     ///< of each: how many are the same, itself included
    std::map<std::string, std::uint64_t> points_; ///< how often each was entered
    std::uint64_t earlierPoints_ = 0;             ///< how many before the present one are the same
};

} // namespace mrpp

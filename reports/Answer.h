#pragma once
/// \file
/// What a planner made of one instance, however often it was asked.
///
/// Repetitions of a problem without chance are copies of one instance, and so are two points of a sweep that
/// round to the same number of robots. Copies are one case: their answers are counted once.

#include "framework/run/RunRecord.h"

#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace mrpp
{

/// Where the cost of an instance without an answer stands: above all others.
inline constexpr double kNoAnswer = std::numeric_limits<double>::infinity();

/// What an end counts as.
enum class Outcome
{
    solved,
    proved,       ///< infeasible: the answer to an instance that has no solution
    doesNotApply, ///< unsupported
    failed,       ///< all others
};

[[nodiscard]] Outcome outcomeOf(PlannerStatus status);

/// One planner on one instance. The records must outlive it.
class Answer
{
public:
    /// Another run of the planner on the instance.
    void add(const RunRecord &run);

    [[nodiscard]] bool isFinished() const { return first_ != nullptr; }
    /// \pre isFinished()
    [[nodiscard]] const RunRecord &first() const { return *first_; }
    [[nodiscard]] std::size_t runs() const { return first_ == nullptr ? 0 : 1 + copies_.size(); }

    /// The end that more than half of the copies had; where there is none the most frequent of the failures,
    /// the first of equals. \pre isFinished()
    [[nodiscard]] PlannerStatus status() const;
    [[nodiscard]] Outcome outcome() const { return outcomeOf(status()); }
    [[nodiscard]] bool solved() const { return isFinished() && status() == PlannerStatus::solved; }

    /// Whether the instance is known to have no solution under the planner's motion rule.
    [[nodiscard]] bool unsolvable() const;
    /// Whether it counts for a success rate: the planner applies to an instance that is not unsolvable.
    [[nodiscard]] bool counts() const;

    /// A numeric column of a solved instance, the median over the copies, of which those that failed are
    /// above all others; nothing where it is not solved, or where the column is empty.
    [[nodiscard]] std::optional<double> cost(std::string_view column) const;

private:
    const RunRecord *first_ = nullptr;
    std::vector<const RunRecord *> copies_; // usually none

    template <class Visit>
    void forEach(Visit &&visit) const;
};

/// Tells instances apart: the same number for the same instance.
class InstanceNumbers
{
public:
    /// \param records in which runs are looked for whose fingerprints their cases' other runs have
    explicit InstanceNumbers(std::span<const RunRecord> records);

    [[nodiscard]] std::size_t of(const RunRecord &run);

private:
    std::unordered_map<std::string, const std::string *> fingerprints_; // of cases
    std::unordered_map<std::string, std::size_t> numbers_;
};

} // namespace mrpp

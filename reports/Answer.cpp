#include "reports/Answer.h"

#include "framework/statistics/Quantiles.h"

#include <algorithm>
#include <cmath>

namespace mrpp
{

Outcome outcomeOf(PlannerStatus status)
{
    switch (status)
    {
    case PlannerStatus::solved:
        return Outcome::solved;
    case PlannerStatus::infeasible:
        return Outcome::proved;
    case PlannerStatus::unsupported:
        return Outcome::doesNotApply;
    default:
        return Outcome::failed;
    }
}

template <class Visit>
void Answer::forEach(Visit &&visit) const
{
    if (first_ == nullptr)
        return;
    visit(*first_);
    for (const RunRecord *copy : copies_)
        visit(*copy);
}

void Answer::add(const RunRecord &run)
{
    if (first_ == nullptr)
        first_ = &run;
    else
        copies_.push_back(&run);
}

PlannerStatus Answer::status() const
{
    if (copies_.empty())
        return first_->status;
    std::vector<std::pair<PlannerStatus, std::size_t>> counts; // in the order in which they came
    forEach(
        [&](const RunRecord &run)
        {
            const auto known = std::find_if(counts.begin(), counts.end(),
                                            [&](const auto &entry) { return entry.first == run.status; });
            if (known == counts.end())
                counts.emplace_back(run.status, 1);
            else
                ++known->second;
        });
    for (const auto &[status, count] : counts)
        if (2 * count > runs())
            return status;
    const std::pair<PlannerStatus, std::size_t> *most = nullptr;
    for (const auto &entry : counts)
        if (outcomeOf(entry.first) == Outcome::failed && (most == nullptr || entry.second > most->second))
            most = &entry;
    return most == nullptr ? PlannerStatus::unknown : most->first; // half of the copies solved, half proved …
}

bool Answer::unsolvable() const
{
    if (!isFinished() || solved())
        return false;
    bool is = false;
    forEach([&is](const RunRecord &run)
            { is = is || run.unsolvable() || run.status == PlannerStatus::infeasible; });
    return is;
}

bool Answer::counts() const
{
    return isFinished() && outcome() != Outcome::doesNotApply && !unsolvable();
}

std::optional<double> Answer::cost(std::string_view column) const
{
    if (!solved())
        return std::nullopt;
    if (copies_.empty())
        return numericValue(*first_, column);
    std::vector<double> values;
    bool anything = false;
    forEach(
        [&](const RunRecord &run)
        {
            const auto value = run.solved() ? numericValue(run, column) : std::optional(kNoAnswer);
            anything = anything || (value && run.solved());
            if (value)
                values.push_back(*value);
        });
    if (!anything)
        return std::nullopt;
    const double middle = median(std::move(values));
    return std::isfinite(middle) ? std::optional(middle) : std::nullopt;
}

InstanceNumbers::InstanceNumbers(std::span<const RunRecord> records)
{
    for (const RunRecord &run : records)
        if (!run.instanceFingerprint.empty())
            fingerprints_.try_emplace(run.caseId, &run.instanceFingerprint);
}

std::size_t InstanceNumbers::of(const RunRecord &run)
{
    const auto known = fingerprints_.find(run.caseId);
    const std::string &fingerprint = known == fingerprints_.end() ? run.instanceFingerprint : *known->second;
    return numbers_.try_emplace(fingerprint.empty() ? "case " + run.caseId : fingerprint, numbers_.size())
        .first->second;
}

} // namespace mrpp

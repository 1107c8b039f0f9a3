#include "framework/campaign/RepeatedTiming.h"

#include <algorithm>
#include <cmath>
#include <fmt/core.h>

namespace mrpp
{

namespace
{

/// By linear interpolation between order statistics.
double quantile(std::vector<double> values, double share)
{
    std::sort(values.begin(), values.end());
    const double place = share * static_cast<double>(values.size() - 1);
    const auto below = static_cast<std::size_t>(place);
    const std::size_t above = std::min(below + 1, values.size() - 1);
    return std::lerp(values[below], values[above], place - std::floor(place));
}

void append(std::vector<double> &values, const std::optional<double> &value)
{
    if (value)
        values.push_back(*value);
}

} // namespace

RepeatedTiming::RepeatedTiming(const RunRecord &record, std::string fingerprint)
    : status_(record.status), fingerprint_(std::move(fingerprint))
{
    add(record, fingerprint_);
}

void RepeatedTiming::add(const RunRecord &record, const std::string &fingerprint)
{
    append(times_, record.time);
    append(setupTimes_, record.setupTime);
    append(cpuTimes_, record.cpuTime);
    if (!difference_.empty())
        return;
    if (record.status != status_)
        difference_ = fmt::format("solve() ended as {}, and then as {}{}{}", toString(status_),
                                  toString(record.status), record.reason.empty() ? "" : ": ", record.reason);
    else if (fingerprint != fingerprint_)
        difference_ = "the same question and seed had another solution when it was solved again";
}

void RepeatedTiming::note(RunRecord &record) const
{
    record.timed = static_cast<std::int64_t>(times_.size());
    if (times_.size() < 2)
        return;
    record.time = quantile(times_, 0.5);
    record.timeMin = quantile(times_, 0);
    record.timeMax = quantile(times_, 1);
    record.timeIqr = quantile(times_, 0.75) - quantile(times_, 0.25);
    record.setupTime = quantile(setupTimes_, 0.5);
    if (!cpuTimes_.empty())
        record.cpuTime = quantile(cpuTimes_, 0.5);
    record.repeatable = difference_.empty() ? "yes" : "no: " + difference_;
}

} // namespace mrpp

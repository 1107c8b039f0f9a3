#include "framework/run/RepeatedTiming.h"

#include "framework/statistics/Quantiles.h"

#include <algorithm>
#include <fmt/core.h>

namespace mrpp
{

namespace
{

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
    const auto times = quartiles(times_);
    record.time = times->median;
    record.timeMin = *std::min_element(times_.begin(), times_.end());
    record.timeMax = *std::max_element(times_.begin(), times_.end());
    record.timeIqr = times->q3 - times->q1;
    record.setupTime = median(setupTimes_);
    if (!cpuTimes_.empty())
        record.cpuTime = median(cpuTimes_);
    record.repeatable = difference_.empty() ? "yes" : "no: " + difference_;
}

} // namespace mrpp

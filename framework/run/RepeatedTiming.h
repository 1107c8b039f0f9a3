#pragma once
/// \file
/// What several timings of one and the same run say: the median, the spread, and whether the planner gave the
/// same answer each time.

#include "framework/run/RunRecord.h"

#include <string>
#include <vector>

namespace mrpp
{

class RepeatedTiming
{
public:
    /// \param record of the first solve(), which says how it ended \param fingerprint of its solution
    RepeatedTiming(const RunRecord &record, std::string fingerprint);

    /// Another solve() of the same question.
    void add(const RunRecord &record, const std::string &fingerprint);

    /// Writes medians, spread and `repeatable` into the first one's record.
    void note(RunRecord &record) const;

private:
    PlannerStatus status_;
    std::string fingerprint_;
    std::string difference_; ///< the first one, in words
    std::vector<double> times_;
    std::vector<double> setupTimes_;
    std::vector<double> cpuTimes_;
};

} // namespace mrpp

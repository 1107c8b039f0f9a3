#pragma once
/// \file
/// Watches a planner while it works: the values that it offers (Planner::addProgressProperty), sampled from
/// another thread at a fixed interval.

#include "framework/Planner.h"

#include <chrono>
#include <string>
#include <thread>
#include <vector>

namespace mrpp
{

/// What a run's progress properties were over time.
struct Progress
{
    struct Sample
    {
        double time = 0;            ///< seconds since the start of solve(), ascending
        std::vector<double> values; ///< size = names
    };
    std::vector<std::string> names;
    std::vector<Sample> samples;
};

class ProgressSampler
{
public:
    static constexpr std::chrono::milliseconds kInterval{50};

    /// Begins to sample; without properties there is no thread. The planner must outlive the sampler. Throws
    /// HarnessError where no thread can be had.
    explicit ProgressSampler(const Planner &planner);

    /// Ends and gives the samples, one of now included. Call once.
    [[nodiscard]] Progress finish();

private:
    void sample();
    void sampleUntil(const std::stop_token &stop);

    const Planner &planner_;
    std::chrono::steady_clock::time_point start_;
    Progress progress_;
    std::jthread thread_; ///< last: it ends before what it fills goes
};

} // namespace mrpp

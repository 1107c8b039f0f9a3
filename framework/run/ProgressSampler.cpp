#include "framework/run/ProgressSampler.h"

#include "framework/support/HarnessError.h"

#include <condition_variable>
#include <mutex>
#include <system_error>

namespace mrpp
{

ProgressSampler::ProgressSampler(const Planner &planner)
    : planner_(planner), start_(std::chrono::steady_clock::now())
{
    for (const auto &[name, value] : planner.progressProperties())
        progress_.names.push_back(name);
    if (progress_.names.empty())
        return;
    try
    {
        thread_ = std::jthread([this](const std::stop_token &stop) { sampleUntil(stop); });
    }
    catch (const std::system_error &error)
    {
        throw HarnessError(std::string("no thread can be started to follow a planner: ") + error.what());
    }
}

void ProgressSampler::sampleUntil(const std::stop_token &stop)
{
    std::mutex mutex;
    std::condition_variable_any wake;
    std::unique_lock lock(mutex);
    while (!wake.wait_for(lock, stop, kInterval, [&stop] { return stop.stop_requested(); }))
        sample();
}

Progress ProgressSampler::finish()
{
    if (thread_.joinable())
    {
        thread_.request_stop();
        thread_.join();
        sample();
    }
    return std::move(progress_);
}

void ProgressSampler::sample()
{
    Progress::Sample &now = progress_.samples.emplace_back();
    now.time = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    for (const auto &[name, value] : planner_.progressProperties())
        now.values.push_back(value());
}

} // namespace mrpp

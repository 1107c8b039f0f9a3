#include "framework/store/ResultWriter.h"

namespace mrpp
{

ResultWriter::ResultWriter(ResultStore &store, std::function<void(const RunRecord &)> onKept,
                           std::function<void()> onFailure)
    : store_(store), onKept_(std::move(onKept)), onFailure_(std::move(onFailure)), thread_([this] { work(); })
{}

ResultWriter::~ResultWriter()
{
    const std::lock_guard lock(mutex_);
    closed_ = true;
    changed_.notify_all();
}

void ResultWriter::put(FinishedRun run)
{
    constexpr std::size_t kMostWaiting = 256;
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return waiting_.size() < kMostWaiting || error_; });
    if (!error_)
        waiting_.push_back(std::move(run));
    changed_.notify_all();
}

void ResultWriter::finish()
{
    {
        const std::lock_guard lock(mutex_);
        closed_ = true;
        changed_.notify_all();
    }
    if (thread_.joinable())
        thread_.join();
    if (error_)
        std::rethrow_exception(error_);
}

void ResultWriter::work()
{
    std::vector<FinishedRun> batch;
    for (;;)
    {
        {
            std::unique_lock lock(mutex_);
            changed_.wait(lock, [this] { return !waiting_.empty() || closed_; });
            if (waiting_.empty())
                return;
            batch.clear();
            batch.swap(waiting_);
            changed_.notify_all();
        }
        try
        {
            keep(batch);
        }
        catch (...)
        {
            {
                const std::lock_guard lock(mutex_);
                error_ = std::current_exception();
                waiting_.clear();
                changed_.notify_all();
            }
            return onFailure_();
        }
    }
}

void ResultWriter::keep(std::vector<FinishedRun> &batch)
{
    try
    {
        store_.add(batch);
    }
    catch (const std::exception &)
    {
        // One of them may be at fault: those before it are kept.
        for (const FinishedRun &run : batch)
        {
            store_.add({&run, 1});
            onKept_(run.record);
        }
        return;
    }
    for (const FinishedRun &run : batch)
        onKept_(run.record);
}

} // namespace mrpp

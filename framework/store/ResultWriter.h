#pragma once
/// \file
/// Keeps finished runs from a thread of its own, so that those who run planners need not wait for the disk:
/// what has gathered while one transaction was forced to the disk goes into the next. A run counts as
/// finished when it is on the disk, not before.

#include "framework/store/ResultStore.h"

#include <condition_variable>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace mrpp
{

class ResultWriter
{
public:
    /// \param store must outlive the writer, which alone adds to it
    /// \param onKept told of each run when it is on the disk, in the order of put(), from the writer's thread
    /// \param onFailure told once when a run cannot be kept; finish() throws why
    ResultWriter(ResultStore &store, std::function<void(const RunRecord &)> onKept,
                 std::function<void()> onFailure);

    /// Keeps what is left, as finish() does.
    ~ResultWriter();
    ResultWriter(const ResultWriter &) = delete;
    ResultWriter &operator=(const ResultWriter &) = delete;

    /// Takes a run over; waits while many are on their way to the disk. After a failure it does nothing.
    void put(FinishedRun run);

    /// Waits until everything is kept. Throws what keeping threw: FileError, InputError, or what onKept
    /// threw; the runs that could be kept are.
    void finish();

private:
    void work();
    void keep(std::vector<FinishedRun> &batch);

    ResultStore &store_;
    std::function<void(const RunRecord &)> onKept_;
    std::function<void()> onFailure_;
    std::mutex mutex_; // guards what follows
    std::condition_variable changed_;
    std::vector<FinishedRun> waiting_;
    bool closed_ = false;
    std::exception_ptr error_;
    std::jthread thread_; // last: it uses all of it
};

} // namespace mrpp

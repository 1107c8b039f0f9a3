#pragma once
/// \file
/// A worker process seen from the campaign: started, spoken to, waited for with a deadline, killed with
/// everything that it started.

#include "framework/system/ControlGroup.h"
#include "framework/system/Cores.h"
#include "framework/system/Descriptor.h"
#include "framework/worker/WorkerMessages.h"

#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <sys/types.h>
#include <vector>

namespace mrpp
{

class WorkerProcess
{
public:
    using Clock = std::chrono::steady_clock;

    /// Starts the program in a process group and, where the system allows it, a control group of its own, its
    /// standard output going nowhere. No shell sees the command. Throws FileError where that fails.
    /// \param cores to which it is confined; to none where empty
    WorkerProcess(const std::vector<std::string> &command, const CoreSet &cores);

    /// Kills what is still there.
    ~WorkerProcess();

    WorkerProcess(const WorkerProcess &) = delete;
    WorkerProcess &operator=(const WorkerProcess &) = delete;

    /// False where the worker is gone.
    bool send(const Message &message) { return mrpp::send(socket_.number(), message); }

    /// The next message; nothing where the worker has ended, or `isOver` says so, which is asked every 50 ms
    /// and only when no message is waiting: whoever has answered is not judged as silent.
    [[nodiscard]] std::optional<Message> receive(const std::function<bool()> &isOver);

    /// Whether the worker stands still now, stopped by a signal or a debugger.
    [[nodiscard]] bool isStopped() const;

    /// What became of it.
    struct End
    {
        int exitCode = -1; ///< −1 where a signal ended it
        int signal = 0;    ///< 0 where it ended by itself
    };

    /// Kills it and all that it started, unless it has ended by itself, and waits for it. Call once.
    End end();

    /// CPU seconds of the worker and all that it started, so far.
    [[nodiscard]] double cpuTime() const;

    /// MB of memory of the processes that its planner has started and that live, sampled now.
    [[nodiscard]] double childrenMemory() const;

    /// Its control group; null where there is none.
    [[nodiscard]] ControlGroup *group() const { return group_.get(); }
    /// Those that it is confined to; empty where to none.
    [[nodiscard]] const CoreSet &cores() const { return cores_; }

    /// The last 2 KiB of its standard error since the last call.
    [[nodiscard]] std::string takeErrorOutput();

private:
    void readErrorOutput();
    /// −1 where it has not begun yet, or is gone.
    [[nodiscard]] pid_t worker() const;

    pid_t pid_ = -1;            ///< of its guardian, whose first child is the worker
    mutable pid_t worker_ = -1; ///< once it is known
    CoreSet cores_;
    std::unique_ptr<ControlGroup> group_;
    Descriptor socket_;
    Descriptor errors_; ///< its standard error
    MessageBuffer buffer_;
    std::string errorOutput_;
};

} // namespace mrpp

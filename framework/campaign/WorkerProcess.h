#pragma once
/// \file
/// A worker process seen from the campaign: started, spoken to, waited for with a deadline, killed with
/// everything that it started.

#include "framework/campaign/WorkerMessages.h"
#include "framework/support/Descriptor.h"

#include <chrono>
#include <functional>
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

    /// Starts the program in a process group of its own, its standard output going nowhere. No shell sees the
    /// command. Throws FileError where that fails.
    explicit WorkerProcess(const std::vector<std::string> &command);

    /// Kills what is still there.
    ~WorkerProcess();

    WorkerProcess(const WorkerProcess &) = delete;
    WorkerProcess &operator=(const WorkerProcess &) = delete;

    /// False where the worker is gone.
    bool send(const Message &message) { return mrpp::send(socket_.number(), message); }

    /// The next message; nothing where the worker has ended, `deadline` passed, or `stop` says so.
    [[nodiscard]] std::optional<Message> receive(const std::optional<Clock::time_point> &deadline,
                                                 const std::function<bool()> &stop);

    /// What became of it.
    struct End
    {
        int exitCode = -1; ///< −1 where a signal ended it
        int signal = 0;    ///< 0 where it ended by itself
    };

    /// Kills its group, unless it has ended by itself, and waits for it. Call once.
    End end();

    /// The last 2 KiB of its standard error since the last call.
    [[nodiscard]] std::string takeErrorOutput();

private:
    void readErrorOutput();

    pid_t pid_ = -1;
    Descriptor socket_;
    Descriptor errors_; ///< its standard error
    MessageBuffer buffer_;
    std::string errorOutput_;
};

} // namespace mrpp

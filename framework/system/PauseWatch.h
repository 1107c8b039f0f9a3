#pragma once
/// \file
/// Notices that this process stood still for a while: it was stopped and continued (Ctrl-Z and fg, a
/// suspended job), or the machine slept. Time that was measured meanwhile is nobody's.

#include <cstdint>
#include <mutex>

namespace mrpp
{

class PauseWatch
{
public:
    /// Blocks SIGCONT in this thread and in those that it starts later. A blocked one continues the process
    /// as ever, and stays pending, which tells of the pause, however short it was. In a process where another
    /// thread takes the signal only the machine's sleep is noticed.
    PauseWatch();

    /// How many pauses were noticed so far, those that have just ended included.
    [[nodiscard]] std::uint64_t count();

private:
    std::mutex mutex_; // guards what follows
    std::uint64_t count_ = 0;
    double slept_; ///< seconds, of the machine since it was started
};

} // namespace mrpp

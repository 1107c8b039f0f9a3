#pragma once
/// \file
/// Ctrl-C, SIGTERM and SIGHUP (the terminal is gone) as a stop token: the first asks for a clean end, the second
/// ends the process.

#include <stop_token>
#include <thread>

namespace mrpp
{

/// While it lives, these signals of this process go to a thread of its own. Make it before any other thread, so
/// that all inherit its mask, in which SIGCONT is blocked, too (see PauseWatch). What `nohup` ignores stays
/// ignored.
class Interruption
{
public:
    Interruption();
    ~Interruption();
    Interruption(const Interruption &) = delete;
    Interruption &operator=(const Interruption &) = delete;

    [[nodiscard]] std::stop_token token() const { return stop_.get_token(); }
    [[nodiscard]] bool happened() const { return stop_.stop_requested(); }

private:
    std::stop_source stop_;
    std::jthread listener_;
};

} // namespace mrpp

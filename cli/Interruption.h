#pragma once
/// \file
/// Ctrl-C, SIGTERM and SIGHUP (the terminal is gone) as a stop token: the first asks for a clean end, the
/// second ends the process.

#include <atomic>
#include <chrono>
#include <functional>
#include <optional>
#include <stop_token>
#include <thread>

namespace mrpp
{

/// While it lives, these signals of this process go to a thread of its own. Make it before any other thread,
/// so that all inherit its mask, in which SIGCONT is blocked, too (see PauseWatch). What `nohup` ignores
/// stays ignored.
class Interruption
{
public:
    using Milliseconds = std::chrono::milliseconds;

    /// Waits for a clean end however long it takes.
    Interruption() : Interruption(std::nullopt) {}

    /// Ends the process with exit code 130 where it has not ended so long after it was asked: some work
    /// cannot be interrupted. \param patience nothing: waits; see waitFromNowOn() \param abandon called
    /// before, from the other thread: removes what is half done
    explicit Interruption(std::optional<Milliseconds> patience, std::function<void()> abandon = {});
    ~Interruption();
    Interruption(const Interruption &) = delete;
    Interruption &operator=(const Interruption &) = delete;

    [[nodiscard]] std::stop_token token() const { return stop_.get_token(); }
    [[nodiscard]] bool happened() const { return stop_.stop_requested(); }

    /// From here on there is something to be kept, and a clean end is waited for.
    void waitFromNowOn() { waits_ = true; }

private:
    void listen(const std::stop_token &end);
    [[noreturn]] void endProcess() const;

    std::stop_source stop_;
    std::optional<Milliseconds> patience_;
    std::function<void()> abandon_;
    std::atomic<bool> waits_;
    std::jthread listener_;
};

} // namespace mrpp

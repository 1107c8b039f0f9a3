#include "cli/Interruption.h"

#include "cli/ExitCode.h"

#include <csignal>
#include <ctime>
#include <string_view>
#include <unistd.h>
#include <utility>

namespace mrpp
{

namespace
{

sigset_t interruptions()
{
    sigset_t signals;
    ::sigemptyset(&signals);
    ::sigaddset(&signals, SIGINT);
    ::sigaddset(&signals, SIGTERM);
    struct sigaction hangUp = {};
    if (::sigaction(SIGHUP, nullptr, &hangUp) == 0 && hangUp.sa_handler != SIG_IGN)
        ::sigaddset(&signals, SIGHUP);
    return signals;
}

/// Waits for a signal, and tells whether one came.
bool signalWithin(std::chrono::nanoseconds patience)
{
    constexpr std::chrono::nanoseconds kSecond = std::chrono::seconds(1);
    const sigset_t awaited = interruptions();
    const std::timespec time{patience / kSecond, (patience % kSecond).count()};
    return ::sigtimedwait(&awaited, nullptr, &time) > 0;
}

} // namespace

Interruption::Interruption(std::optional<Milliseconds> patience, std::function<void()> abandon)
    : patience_(patience), abandon_(std::move(abandon)), waits_(!patience)
{
    sigset_t signals = interruptions();
    ::sigaddset(&signals, SIGCONT);
    ::pthread_sigmask(SIG_BLOCK, &signals, nullptr);
    listener_ = std::jthread([this](const std::stop_token &end) { listen(end); });
}

Interruption::~Interruption()
{
    listener_.request_stop();
    ::pthread_kill(listener_.native_handle(), SIGINT); // it need not wait any longer
    listener_.join();
    const sigset_t signals = interruptions();
    ::pthread_sigmask(SIG_UNBLOCK, &signals, nullptr);
}

void Interruption::listen(const std::stop_token &end)
{
    using Clock = std::chrono::steady_clock;
    constexpr Milliseconds kLook{50}; // no signal is lost for good
    Clock::time_point last = Clock::time_point::max();
    while (!end.stop_requested())
    {
        const bool asked = signalWithin(kLook);
        if (end.stop_requested())
            return;
        if (asked && stop_.stop_requested())
            endProcess(); // asked twice
        if (asked)
        {
            stop_.request_stop();
            last = Clock::now() + patience_.value_or(Milliseconds(0));
        }
        if (!waits_ && Clock::now() >= last)
            endProcess();
    }
}

void Interruption::endProcess() const
{
    if (abandon_)
        abandon_();
    constexpr std::string_view kMessage = "interrupted; nothing was written\n";
    if (!waits_)
        (void)!::write(STDERR_FILENO, kMessage.data(), kMessage.size());
    ::_exit(static_cast<int>(ExitCode::interrupted)); // whatever is on disk stays
}

} // namespace mrpp

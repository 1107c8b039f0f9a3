#include "cli/Interruption.h"

#include "cli/ExitCode.h"

#include <csignal>
#include <ctime>
#include <unistd.h>

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
} // namespace

Interruption::Interruption()
{
    sigset_t signals = interruptions();
    ::sigaddset(&signals, SIGCONT);
    ::pthread_sigmask(SIG_BLOCK, &signals, nullptr);
    listener_ = std::jthread(
        [this](const std::stop_token &end)
        {
            const sigset_t awaited = interruptions();
            constexpr std::timespec kPatience{0, 50'000'000}; // how long the destructor may wait
            while (!end.stop_requested())
            {
                if (::sigtimedwait(&awaited, nullptr, &kPatience) < 0)
                    continue;
                if (stop_.stop_requested())
                    ::_exit(
                        static_cast<int>(ExitCode::interrupted)); // asked twice: whatever is on disk stays
                stop_.request_stop();
            }
        });
}

Interruption::~Interruption()
{
    listener_.request_stop();
    listener_.join();
    const sigset_t signals = interruptions();
    ::pthread_sigmask(SIG_UNBLOCK, &signals, nullptr);
}

} // namespace mrpp

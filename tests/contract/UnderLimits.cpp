#include "tests/contract/UnderLimits.h"

#include "framework/system/Memory.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <exception>
#include <iostream>
#include <new>
#include <optional>
#include <sys/resource.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace mrpp::test
{

namespace
{

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kSanitized = true;
#else
constexpr bool kSanitized = false;
#endif

/// How the process of a body ends.
enum ExitStatus : int
{
    passed = 0,
    failed = 1, ///< its messages have been printed
    skipped = 2,
    outOfMemory = 3,
    threw = 4,
};

void limitProcess(const BodyLimits &limits)
{
    const auto bytes = static_cast<rlim_t>(static_cast<double>(dataMemory()) + limits.memory * 1e6);
    const rlimit memory{bytes, bytes};
    ::setrlimit(RLIMIT_DATA, &memory);
    const auto seconds = static_cast<rlim_t>(limits.cpu);
    const rlimit cpu{seconds, seconds + 2};
    ::setrlimit(RLIMIT_CPU, &cpu);
    const rlimit none{0, 0};
    ::setrlimit(RLIMIT_CORE, &none);
}

ExitStatus statusOf(const std::function<void()> &body)
{
    try
    {
        body();
    }
    catch (const std::bad_alloc &)
    {
        return outOfMemory;
    }
    catch (const std::exception &error)
    {
        std::cout << "threw: " << error.what() << '\n';
        return threw;
    }
    return testing::Test::HasFailure() ? failed : testing::Test::IsSkipped() ? skipped : passed;
}

/// What waitpid() says of it; nothing where it had to be killed.
std::optional<int> endWithin(pid_t child, double seconds)
{
    using Clock = std::chrono::steady_clock;
    const auto end = Clock::now() + std::chrono::duration<double>(seconds);
    int status = 0;
    std::chrono::microseconds pause(100);
    while (::waitpid(child, &status, WNOHANG) == 0)
    {
        if (Clock::now() >= end)
        {
            ::kill(child, SIGKILL);
            ::waitpid(child, &status, 0);
            return std::nullopt;
        }
        std::this_thread::sleep_for(pause);
        pause = std::min<std::chrono::microseconds>(2 * pause, std::chrono::milliseconds(20));
    }
    return status;
}

void judge(const std::optional<int> &status, const BodyLimits &limits)
{
    if (!status)
        ADD_FAILURE() << "went on after " << limits.wall << " s, and was killed";
    else if (WIFSIGNALED(*status) && WTERMSIG(*status) == SIGXCPU)
        ADD_FAILURE() << "took more than " << limits.cpu << " s of processor time: something does not stop";
    else if (WIFSIGNALED(*status))
        ADD_FAILURE() << "killed by signal " << WTERMSIG(*status) << " (" << ::strsignal(WTERMSIG(*status))
                      << ")";
    else if (WEXITSTATUS(*status) == outOfMemory)
        ADD_FAILURE() << "needs more than " << limits.memory << " MB of memory";
    else if (WEXITSTATUS(*status) == skipped)
        GTEST_SKIP();
    else if (WEXITSTATUS(*status) != passed)
        ADD_FAILURE() << "failed in its own process, as said above";
}

} // namespace

void underLimits(const std::function<void()> &body, const BodyLimits &limits)
{
    if (kSanitized)
        return body();
    std::cout << std::flush;
    std::fflush(nullptr);
    const pid_t child = ::fork();
    if (child < 0)
        FAIL() << "fork: " << std::strerror(errno);
    if (child == 0)
    {
        limitProcess(limits);
        const ExitStatus status = statusOf(body);
        std::cout << std::flush;
        std::fflush(nullptr);
        ::_exit(status);
    }
    judge(endWithin(child, limits.wall), limits);
}

} // namespace mrpp::test

#include "framework/system/ProcessState.h"

#include "framework/system/PauseWatch.h"

#include <gtest/gtest.h>

#include <cfenv>
#include <clocale>
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <functional>
#include <sys/stat.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace mrpp
{
namespace
{

/// What the child process that does this exits with.
int inAChild(const std::function<int()> &act)
{
    const pid_t child = ::fork();
    if (child == 0)
        ::_exit(act());
    int status = 0;
    ::waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

TEST(ProcessState, TakesBackWhatCanBeTakenBack)
{
    const int complaint = inAChild(
        []
        {
            ::setenv("MRPP_TEST", "before", 1);
            ::umask(022);
            const std::string folder = std::filesystem::current_path();
            rlimit descriptors{};
            ::getrlimit(RLIMIT_NOFILE, &descriptors);
            const ProcessState before;

            if (::chdir("/") != 0)
                return 99;
            ::umask(077);
            for (const auto resource : {RLIMIT_FSIZE, RLIMIT_NOFILE, RLIMIT_CORE})
            {
                rlimit limit{};
                ::getrlimit(resource, &limit);
                limit.rlim_cur = 0;
                ::setrlimit(resource, &limit);
            }
            std::signal(SIGTERM, SIG_IGN);
            std::signal(SIGCHLD, SIG_IGN);
            sigset_t all;
            ::sigfillset(&all);
            ::pthread_sigmask(SIG_BLOCK, &all, nullptr);
            ::alarm(1000);
            ::setenv("MRPP_TEST", "after", 1);
            ::unsetenv("PATH");
            std::setlocale(LC_ALL, "C.UTF-8");
            std::fesetround(FE_UPWARD);

            if (!before.restore())
                return 1;
            rlimit now{};
            ::getrlimit(RLIMIT_NOFILE, &now);
            struct sigaction action = {};
            ::sigaction(SIGTERM, nullptr, &action);
            sigset_t blocked;
            ::pthread_sigmask(SIG_SETMASK, nullptr, &blocked);
            return std::filesystem::current_path() != folder             ? 2
                   : ::umask(0) != 022                                   ? 3
                   : now.rlim_cur != descriptors.rlim_cur                ? 4
                   : action.sa_handler != SIG_DFL                        ? 5
                   : ::sigismember(&blocked, SIGUSR1) != 0               ? 6
                   : ::alarm(0) != 0                                     ? 7
                   : std::string(std::getenv("MRPP_TEST")) != "before"   ? 8
                   : std::getenv("PATH") == nullptr                      ? 9
                   : std::string(std::setlocale(LC_ALL, nullptr)) != "C" ? 10
                   : std::fegetround() != FE_TONEAREST                   ? 11
                                                                         : 0;
        });
    EXPECT_EQ(complaint, 0);
}

TEST(ProcessState, SaysWhatCannotBeTakenBack)
{
    const auto restoredAfter = [](const std::function<void()> &act)
    {
        return inAChild(
                   [&act]
                   {
                       const ProcessState before;
                       act();
                       return before.restore() ? 1 : 0;
                   }) == 1;
    };
    EXPECT_TRUE(restoredAfter([] {}));
    EXPECT_FALSE(restoredAfter([] { ::close(STDIN_FILENO); }));
    EXPECT_FALSE(restoredAfter([] { ::dup2(::open("/dev/zero", O_RDONLY), STDIN_FILENO); }));
    EXPECT_FALSE(restoredAfter([] { (void)::open("/dev/null", O_RDONLY); }));
    EXPECT_FALSE(restoredAfter([] { std::thread([] { ::pause(); }).detach(); }));
    if (::geteuid() == 0)
    {
        EXPECT_FALSE(restoredAfter([] { (void)!::setuid(65534); }));
    }
}

TEST(PauseWatch, NoticesThatTheProcessWasStopped)
{
    const int noticed = inAChild(
        []
        {
            PauseWatch watch;
            const auto before = watch.count();
            const pid_t self = ::getpid();
            if (::fork() == 0)
            {
                ::kill(self, SIGSTOP);
                ::kill(self, SIGCONT);
                ::_exit(0);
            }
            ::waitpid(-1, nullptr, 0);
            const auto after = watch.count();
            return static_cast<int>(after - before) * 10 + static_cast<int>(watch.count() - after);
        });
    EXPECT_EQ(noticed, 10);
}

} // namespace
} // namespace mrpp

#include "tests/campaign/Hostile.h"

#include "tests/campaign/Fixtures.h"

#include <cfenv>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <stdexcept>
#include <sys/resource.h>
#include <sys/stat.h>
#include <thread>
#include <unistd.h>

namespace mrpp::fixtures
{

namespace
{

using Act = void (*)();

/// Acts, and then walks.
class Hostile final : public Walker
{
public:
    explicit Hostile(Act act) : act_(act) {}
    PlannerStatus solve(const TerminationCondition &ptc) override
    {
        act_();
        return Walker::solve(ptc);
    }

private:
    Act act_;
};

/// Counts until it is told to stop.
class Busy final : public Walker
{
public:
    PlannerStatus solve(const TerminationCondition &ptc) override
    {
        while (!ptc())
            continue;
        return PlannerStatus::timeout;
    }
};

class SetupSpinner final : public Walker
{
public:
    void setup() override
    {
        for (;;)
            ::pause();
    }
};

[[noreturn]] void spin()
{
    volatile bool forEver = true;
    while (forEver)
        continue;
    std::abort();
}

void touch(std::size_t bytes)
{
    std::vector<char> memory(bytes, 'x');
    volatile char last = memory.back();
    (void)last;
}

void eatWithoutEnd()
{
    constexpr std::size_t kPiece = std::size_t{16} << 20;
    std::vector<std::vector<char>> eaten;
    for (;;)
        eaten.emplace_back(kPiece, 'x');
}

void leaveChildren()
{
    for (const bool ownSession : {false, true})
    {
        if (::fork() != 0)
            continue;
        if (ownSession)
            ::setsid();
        for (;;)
            ::pause();
    }
}

/// A child in a session of its own, which nobody's group reaches.
void leaveDaemon()
{
    if (::fork() != 0)
        return;
    ::setsid();
    for (;;)
        ::pause();
}

/// Children that each keep to the memory limit, but not together.
void raiseFamily()
{
    constexpr int kChildren = 4;
    for (int i = 0; i < kChildren; ++i)
    {
        if (::fork() != 0)
            continue;
        touch(1);
        const std::vector<char> memory(100'000'000, 'x');
        for (;;)
            ::pause();
    }
    ::sleep(60);
}

/// Works in children while it waits itself.
void delegateSpinning()
{
    for (int i = 0; i < 2; ++i)
        if (::fork() == 0)
            spin();
    for (;;)
        ::pause();
}

void chatter(int megabytes)
{
    const std::string line(1023, 'a');
    for (int i = 0; i < megabytes * 1024; ++i)
    {
        std::fprintf(stderr, "%s\n", line.c_str());
        std::printf("%s\n", line.c_str());
    }
    std::fprintf(stderr, "last words");
    std::fflush(stdout);
}

/// Changes what belongs to the whole process, and what is in it.
void spoil()
{
    (void)!::chdir("/");
    ::umask(0777);
    for (const auto resource : {RLIMIT_NOFILE, RLIMIT_FSIZE, RLIMIT_STACK})
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
    ::setenv("PATH", "/nowhere", 1);
    ::setenv("TMPDIR", "/nowhere", 1);
    std::fesetround(FE_UPWARD);
}

/// And so that it cannot be taken back.
void spoilForGood()
{
    spoil();
    ::close(STDERR_FILENO);
    std::thread([] { ::pause(); }).detach();
}

/// Says how its process is.
class Inspector final : public Walker
{
public:
    PlannerStatus solve(const TerminationCondition &) override
    {
        std::string state = std::filesystem::current_path().string() + " " + std::getenv("PATH");
        const mode_t mask = ::umask(0);
        ::umask(mask);
        rlimit files{};
        ::getrlimit(RLIMIT_NOFILE, &files);
        struct sigaction action = {};
        ::sigaction(SIGTERM, nullptr, &action);
        for (const auto number :
             {std::uint64_t{mask}, std::uint64_t{files.rlim_cur}, std::uint64_t{action.sa_handler == SIG_DFL},
              std::uint64_t(std::fegetround()), std::uint64_t(::fcntl(STDERR_FILENO, F_GETFD) >= 0)})
            state += " " + std::to_string(number);
        return because(PlannerStatus::gave_up, state);
    }
};

unsigned overflow(unsigned depth, const volatile bool &further) // NOLINT(misc-no-recursion)
{
    volatile char frame[4096];
    frame[depth % sizeof frame] = static_cast<char>(depth);
    return further ? overflow(depth + 1, further) + static_cast<unsigned>(frame[0]) : depth;
}

void add(Catalog &catalog, const std::string &name, Act act)
{
    catalog.planners.add(name, "",
                         [act]() -> std::unique_ptr<Planner> { return std::make_unique<Hostile>(act); });
}

} // namespace

Catalog hostileCatalog()
{
    Catalog all = catalog();
    all.planners.add<SetupSpinner>("setup_spinner", "");
    add(all, "segfaulter", [] { std::raise(SIGSEGV); });
    add(all, "aborter",
        []
        {
            std::fprintf(stderr, "assertion failed\n");
            std::abort();
        });
    add(all, "exiter", [] { std::exit(0); });
    add(all, "spinner", [] { spin(); });
    add(all, "glutton", [] { eatWithoutEnd(); });
    add(all, "holder", [] { touch(300'000'000); });
    add(all, "forker", [] { leaveChildren(); });
    add(all, "double", [] { (void)!::fork(); });
    add(all, "chatter", [] { chatter(64); });
    add(all, "shouter", [] { chatter(512); });
    add(all, "daemon",
        []
        {
            leaveDaemon();
            spin();
        });
    add(all, "deserter",
        []
        {
            leaveDaemon();
            std::raise(SIGSEGV);
        });
    add(all, "family", [] { raiseFamily(); });
    add(all, "foreman", [] { delegateSpinning(); });
    all.planners.add<Busy>("busy", "");
    all.planners.add<Inspector>("inspector", "");
    add(all, "spoiler", [] { spoil(); });
    add(all, "wrecker", [] { spoilForGood(); });
    add(all, "overflower",
        []
        {
            volatile bool further = true;
            std::exit(static_cast<int>(overflow(0, further)));
        });
    return all;
}

BenchmarkPlan namedPlan(const std::string &name)
{
    BenchmarkPlan named;
    if (name == "hostile")
    {
        named = plan({"segfaulter", "aborter", "exiter",     "spinner",  "setup_spinner", "glutton", "forker",
                      "double",     "chatter", "overflower", "thrower",  "eater",         "liar",    "jumper",
                      "sleeper",    "walker",  "daemon",     "deserter", "family",        "prover"},
                     1);
        named.points.resize(1);
        named.limits = {.time = 0.3, .memory = 200};
    }
    else if (name == "holders")
    {
        named = plan({"holder", "walker", "glutton"}, 3);
        named.points.resize(1);
        named.limits.memory = 500;
    }
    else if (name == "shouters")
    {
        named = plan({"shouter", "walker"}, 1);
        named.points.resize(1);
    }
    else if (name == "busy")
    {
        named = plan({"busy", "spinner", "foreman", "walker"}, 1);
        named.points.resize(1);
        named.limits.time = 300;
        named.limits.cpu = 0.4;
    }
    else if (name == "spoilers" || name == "inspectors")
    {
        named = plan({"spoiler", "inspector", "wrecker", "walker"}, 4);
        if (name == "inspectors")
            std::erase_if(named.planners, [](const Configured &planner)
                          { return planner.kind == "spoiler" || planner.kind == "wrecker"; });
    }
    else if (name == "brief")
    {
        named = plan({"walker"}, 3);
        named.planners[0].settings = {{"pause", "0.2"}};
        named.limits.time = 0.6;
    }
    else if (name == "deaf")
    {
        named = plan({"spinner"}, 1);
        named.points.resize(1);
        named.limits.time = 0.3;
    }
    else if (name == "trivial")
    {
        named = plan({"walker", "half"}, 3334);
    }
    else if (name == "pausing")
    {
        named = plan({"walker"}, 1);
        named.planners[0].settings = {{"pause", "1"}};
    }
    else if (name == "many")
    {
        named = plan({"walker", "half"}, 334);
        named.planners[0].settings = {{"pause", "0.002"}};
    }
    else if (name == "walkers")
    {
        named = plan({"walker", "half"}, 20);
        named.planners[0].settings = {{"pause", "0.01"}};
    }
    else
    {
        throw std::invalid_argument("no plan '" + name + "'");
    }
    named.text = name;
    return named;
}

} // namespace mrpp::fixtures

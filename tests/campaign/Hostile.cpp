#include "tests/campaign/Hostile.h"

#include "tests/campaign/Fixtures.h"

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <stdexcept>
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

void chatter()
{
    const std::string line(1023, 'a');
    for (int i = 0; i < (1 << 16); ++i)
    {
        std::fprintf(stderr, "%s\n", line.c_str());
        std::printf("%s\n", line.c_str());
    }
    std::fprintf(stderr, "last words");
    std::fflush(stdout);
}

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
    add(all, "chatter", [] { chatter(); });
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
        named = plan({"segfaulter", "aborter", "exiter", "spinner", "setup_spinner", "glutton", "forker",
                      "double", "chatter", "overflower", "thrower", "eater", "liar", "jumper", "sleeper",
                      "walker"},
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

/// \file
/// `exhaustive_check`: the whole run, whose result stands in docs/completeness.md.

#include "framework/support/Config.h"
#include "tests/contract/EverythingRegistered.h"
#include "tests/exhaustive/Exhaustive.h"

#include <chrono>
#include <iostream>
#include <optional>

namespace
{

using Clock = std::chrono::steady_clock;

constexpr const char *kUsage =
    R"(exhaustive_check [--vertices 7] [--threads 2] [--every 1] [--reasons 20] [--random 100000]
                 [--first 0] [--oracle 1] [--planner NAME]...
Planners get every so-manieth instance, so do the reasons on the largest graphs. Without --planner, all
that call themselves complete. --first F with --every N takes the instances F, F + N, ...; --oracle 0 checks nothing but planners.
Ends with 1 where anything fails.
)";

/// A line a minute.
void showProgress(std::size_t done, std::size_t all)
{
    static Clock::time_point last = Clock::now();
    if (Clock::now() - last < std::chrono::minutes(1))
        return;
    last = Clock::now();
    std::cerr << done << " of " << all << std::endl;
}

std::optional<mrpp::test::ExhaustiveSettings> parse(int count, char **words)
{
    mrpp::test::ExhaustiveSettings settings{.reasons = 20, .random = 100'000, .progress = showProgress};
    for (int i = 1; i < count; i += 2)
    {
        const std::string option = words[i];
        if (i + 1 == count)
            return std::nullopt;
        const std::string text = words[i + 1];
        if (option == "--planner")
        {
            settings.planners.push_back(text);
            continue;
        }
        const auto number = mrpp::parseInteger(text);
        if (!number || *number < 0)
            return std::nullopt;
        const auto value = static_cast<std::uint64_t>(*number);
        if (option == "--vertices" && value <= 7)
            settings.vertices = value;
        else if (option == "--threads" && value > 0)
            settings.threads = value;
        else if (option == "--every" && value > 0)
            settings.every = value;
        else if (option == "--reasons" && value > 0)
            settings.reasons = value;
        else if (option == "--first")
            settings.first = value;
        else if (option == "--oracle" && value <= 1)
            settings.oracle = value == 1;
        else if (option == "--random")
            settings.random = value;
        else
            return std::nullopt;
    }
    return settings;
}

} // namespace

int main(int count, char **words)
{
    const auto settings = parse(count, words);
    if (!settings)
    {
        std::cerr << kUsage;
        return 2;
    }
    const mrpp::Catalog catalog = mrpp::test::everythingRegistered();
    const auto start = Clock::now();
    mrpp::test::ExhaustiveResult small;
    if (settings->vertices > 0)
        small = checkSmallGraphs(catalog, *settings);
    std::cout << "All connected graphs of up to " << settings->vertices << " vertices\n"
              << describe(small) << std::endl;
    const auto random = checkRandomInstances(catalog, *settings);
    std::cout << "Random instances\n"
              << describe(random)
              << std::chrono::duration_cast<std::chrono::seconds>(Clock::now() - start).count() << " s\n";
    return small.failures + random.failures == 0 ? 0 : 1;
}

// Runs a campaign of slow planners in the folder that it is given, until it is killed or done.

#include "tests/campaign/Victim.h"
#include "framework/Benchmark.h"

#include <cstdio>
#include <exception>
#include <string>

int main(int count, char **words)
{
    if (count != 3)
        return 2;
    try
    {
        const mrpp::Catalog catalog = mrpp::fixtures::catalog();
        mrpp::Benchmark benchmark(mrpp::fixtures::victimPlan(), catalog);
        (void)benchmark.benchmark({.folder = words[1], .jobs = std::stoll(words[2])}, {});
        return 0;
    }
    catch (const std::exception &error)
    {
        std::fprintf(stderr, "%s\n", error.what());
        return 3;
    }
}

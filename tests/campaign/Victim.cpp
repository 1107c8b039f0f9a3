// `campaign_victim FOLDER JOBS` runs a campaign of slow planners in that folder, until it is killed or done;
// `campaign_victim worker NAME` serves the runs of another campaign, whose tests look for that name.

#include "tests/campaign/Victim.h"
#include "framework/Benchmark.h"
#include "framework/campaign/Worker.h"
#include "tests/campaign/Hostile.h"

#include <cstdio>
#include <exception>
#include <string>

int main(int count, char **words)
{
    using namespace mrpp;
    if (count != 3)
        return 2;
    try
    {
        const Catalog catalog = fixtures::hostileCatalog();
        if (std::string(words[1]) == "worker")
            return serveRuns(catalog,
                             [](const PlanSource &source) { return fixtures::namedPlan(source.text); });
        Benchmark benchmark(fixtures::victimPlan(), catalog);
        (void)benchmark.benchmark({.folder = words[1], .jobs = std::stoll(words[2])}, {});
        return 0;
    }
    catch (const std::exception &error)
    {
        std::fprintf(stderr, "%s\n", error.what());
        return 3;
    }
}

// `campaign_victim FOLDER JOBS` runs a campaign of slow planners in that folder, until it is killed or done;
// `campaign_victim FOLDER JOBS PLAN` runs the plan of that name, in workers;
// `campaign_victim worker NAME` serves the runs of another campaign, whose tests look for that name.

#include "tests/campaign/Victim.h"
#include "framework/Benchmark.h"
#include "framework/worker/Worker.h"
#include "tests/campaign/Hostile.h"

#include <cstdio>
#include <exception>
#include <string>

int main(int count, char **words)
{
    using namespace mrpp;
    if (count != 3 && count != 4)
        return 2;
    try
    {
        const Catalog catalog = fixtures::hostileCatalog();
        if (std::string(words[1]) == "worker")
            return serveRuns(catalog,
                             [](const PlanSource &source) { return fixtures::namedPlan(source.text); });
        Benchmark::Request request = {.folder = words[1], .jobs = std::stoll(words[2])};
        if (count == 4)
            request.worker = {"/proc/self/exe", "worker", words[1]};
        Benchmark benchmark(count == 4 ? fixtures::namedPlan(words[3]) : fixtures::victimPlan(), catalog);
        (void)benchmark.benchmark(request, {});
        return 0;
    }
    catch (const std::exception &error)
    {
        std::fprintf(stderr, "%s\n", error.what());
        return 3;
    }
}

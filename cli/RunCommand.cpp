#include "cli/Commands.h"
#include "cli/Interruption.h"
#include "cli/KeptFiles.h"
#include "cli/MissingPrograms.h"
#include "cli/ProgressLine.h"
#include "cli/Reporting.h"
#include "framework/Benchmark.h"
#include "framework/plan/PlannerFactory.h"
#include "framework/plan/Shards.h"
#include "framework/run/InputWatch.h"
#include "framework/store/ResultStore.h"
#include "framework/store/WhyRun.h"
#include "framework/support/ReadableText.h"
#include "framework/system/Cores.h"
#include "yaml/PlanReader.h"

#include <fmt/format.h>

#include <algorithm>
#include <iostream>
#include <optional>
#include <set>

namespace mrpp
{

namespace
{

/// The first few and how many more.
std::string someOf(const std::vector<std::string> &names)
{
    constexpr std::size_t kNamed = 4;
    std::string text;
    for (std::size_t i = 0; i < std::min(kNamed, names.size()); ++i)
        text += (i == 0 ? "" : ", ") + names[i];
    return names.size() > kNamed ? fmt::format("{} and {} more", text, names.size() - kNamed) : text;
}

/// What repetitions cannot teach: those of a problem without chance are copies of one instance.
void sayWhatRepeatsInVain(const BenchmarkPlan &plan, const Catalog &catalog)
{
    std::vector<std::string> problems;
    for (const ProblemPoint &point : plan.points)
        if (!point.problem->drawsGraph() && !point.problem->drawsInstance())
            if (const std::string name = point.model + "/" + point.name;
                std::find(problems.begin(), problems.end(), name) == problems.end())
                problems.push_back(name);
    if (plan.repetitions < 2 || problems.empty())
        return;
    std::vector<std::string> planners;
    for (const Configured &planner : plan.planners)
        if (!createPlanner(catalog, planner)->usesChance())
            planners.push_back(planner.name);
    std::string text =
        fmt::format("note: there is no chance in {}: {} repetitions are copies of one instance, which "
                    "count once in reports",
                    someOf(problems), plan.repetitions);
    if (!planners.empty())
        text += fmt::format(
            "; {}, without chance too, will give the same answer to each of them (only times may differ)",
            someOf(planners));
    std::cout << oneLine(text) << '\n';
}

ExitCode dryRun(const BenchmarkPlan &plan, const std::filesystem::path &folder, const Catalog &catalog)
{
    const std::vector<RunSpec> specs = expand(plan, MissingInput::tolerate);
    std::set<std::filesystem::path> missing;
    std::error_code error;
    for (const std::filesystem::path &file : inputFilesOf(plan))
        if (!std::filesystem::exists(file, error))
            missing.insert(file);
    for (const std::filesystem::path &file : missing)
        std::cerr << "note: " << file.string() << " is not there yet; --maps says where to look for it\n";
    noteMissingPrograms(plan);
    std::set<std::string> cases;
    for (const RunSpec &spec : specs)
        cases.insert(spec.caseId);
    std::cout << "campaign " << plan.campaign << " would write to " << folder.string() << '\n'
              << counted(specs.size(), "run") << ": " << counted(cases.size(), "case") << " ("
              << counted(plan.points.size(), "problem point") << ", "
              << counted(plan.repetitions, "repetition") << ") by "
              << counted(plan.planners.size(), "planner") << '\n';
    for (const Configured &planner : plan.planners)
    {
        std::string line = planner.name;
        if (planner.name != planner.kind)
            line += ", " + planner.kind;
        for (const auto &[name, value] : planner.settings)
            line.append(", ").append(name).append("=").append(value);
        std::cout << "planner " << oneLine(line) << '\n';
    }
    sayWhatRepeatsInVain(plan, catalog);
    std::set<std::string> printed;
    for (const RunSpec &spec : specs)
        if (printed.insert(spec.caseId).second)
            std::cout << "case " << spec.caseId << '\n';
    return ExitCode::done;
}

/// missingRuns(), with the plan's places in what is wrong with its input.
std::vector<MissingRun> missingRunsOf(const BenchmarkPlan &plan, const ResultStore *store,
                                      const Catalog &catalog)
{
    try
    {
        return missingRuns(plan, store);
    }
    catch (const PointError &error)
    {
        throw placed(error, plan, catalog);
    }
}

/// The runs that are left, and why each is.
ExitCode sayWhy(const BenchmarkPlan &plan, const RunArguments &arguments, const std::filesystem::path &folder,
                const Catalog &catalog)
{
    std::error_code error;
    std::optional<ResultStore> store;
    if (std::filesystem::exists(folder / "results.sqlite", error))
        store.emplace(folder, ResultStore::Access::read);
    std::vector<MissingRun> missing = missingRunsOf(plan, store ? &*store : nullptr, catalog);
    std::erase_if(missing, [&](const MissingRun &run)
                  { return shardOf(plan, run.spec, arguments.shards) != arguments.shard; });
    for (const MissingRun &run : missing)
        std::cout << oneLine(run.spec.caseId + " by " + plan.planners[run.spec.planner].name + ": " + run.why)
                  << '\n';
    std::cout << counted(missing.size(), "run") << " would be made in " << folder.string() << '\n';
    return ExitCode::done;
}

/// What may make the campaign's times less than honest; a line each. Asked before the campaign adds its own
/// load.
std::string warnings(std::int64_t jobs)
{
    std::string text;
    const auto cores = static_cast<std::int64_t>(machineCores());
    const double load = machineLoad().value_or(0);
    if (jobs > cores)
        text += fmt::format("warning: {} jobs share {} cores; times will be too long\n", jobs, cores);
    else if (load > static_cast<double>(cores - jobs) + 1)
        text += fmt::format("warning: other programs keep this machine busy (load {:.1f} on {} cores); times "
                            "may be too long\n",
                            load, cores);
    return text;
}

/// What the finished runs say about it.
std::string warnings(const Benchmark::Summary &summary)
{
    std::string text;
    if (summary.underLoad > 0)
        text += fmt::format("warning: {} of {} began under a load above the number of cores (column load)\n",
                            summary.underLoad, counted(summary.finished, "run"));
    if (summary.notRepeatable > 0)
        text += fmt::format("warning: {} had another answer when solved again (column repeatable)\n",
                            counted(summary.notRepeatable, "run"));
    return text;
}

void sayHowToGoOn(const RunArguments &arguments, const Benchmark::Summary &summary,
                  const std::filesystem::path &folder)
{
    std::cerr << "interrupted: " << summary.kept + summary.finished << " of "
              << counted(summary.planned, "run") << " are kept in " << folder.string()
              << "; to go on: mrppsim run " << arguments.plan.string();
    if (arguments.folder)
        std::cerr << " -o " << arguments.folder->string();
    for (const std::filesystem::path &maps : arguments.maps)
        std::cerr << " --maps " << maps.string();
    if (arguments.jobs)
        std::cerr << " --jobs " << *arguments.jobs;
    if (arguments.shards > 1)
        std::cerr << " --shard " << arguments.shard << "/" << arguments.shards;
    std::cerr << '\n';
}

void sayResult(const Benchmark::Summary &summary)
{
    std::cout << counted(summary.planned, "run") << " (" << summary.finished << " now, " << summary.kept
              << " before):";
    const char *separator = " ";
    for (const auto &[status, count] : summary.statuses)
    {
        std::cout << separator << toString(status) << " " << count;
        separator = ", ";
    }
    std::cout << '\n';
}

/// Planners that do what none may do: those are defects.
ExitCode sayDefects(const Benchmark::Summary &summary)
{
    const auto count = [&summary](PlannerStatus status)
    {
        const auto found = summary.statuses.find(status);
        return found == summary.statuses.end() ? std::size_t{0} : found->second;
    };
    const std::size_t crashed = count(PlannerStatus::crash);
    const std::size_t wrong = count(PlannerStatus::invalid);
    if (crashed > 0)
        std::cerr << counted(crashed, "run")
                  << " crashed: see the column reason of the runs with status crash\n";
    if (wrong > 0)
        std::cerr << "a planner claimed solutions that are wrong: see the runs with status invalid\n";
    return crashed + wrong > 0 ? ExitCode::defect : ExitCode::done;
}

/// Runs what is left, until it is done or the user interrupts.
Benchmark::Summary runCampaign(Benchmark &benchmark, const RunArguments &arguments,
                               const std::filesystem::path &folder, const Catalog &catalog)
{
    Interruption interruption(std::chrono::milliseconds(0));
    ProgressLine line(std::cerr, arguments.quiet ? ProgressLine::Mode::quiet : ProgressLine::detect());
    KeptFiles kept(benchmark.plan(), folder);
    Benchmark::Request request;
    request.folder = folder;
    request.jobs = arguments.jobs;
    if (benchmark.plan().execution.isolation == "process")
        request.worker = workerCommand(catalog);
    request.shard = arguments.shard;
    request.shards = arguments.shards;
    request.onChecked = [&interruption] { interruption.waitFromNowOn(); };
    request.onFinished = [&kept](const RunSpec &spec, const RunResult &result) { kept.write(spec, result); };
    request.progress = [&line](const RunRecord &record, std::size_t done, std::size_t total,
                               double secondsLeft) { line.update(record.status, done, total, secondsLeft); };
    Benchmark::Summary summary;
    try
    {
        summary = benchmark.benchmark(request, interruption.token());
    }
    catch (const PointError &error)
    {
        throw placed(error, benchmark.plan(), catalog);
    }
    if (!summary.interrupted)
        kept.followNames();
    return summary;
}

} // namespace

ExitCode run(const RunArguments &arguments, Catalog &catalog)
{
    BenchmarkPlan plan = readPlan(arguments.plan, catalog, arguments.maps);
    const std::filesystem::path folder =
        arguments.folder.value_or(std::filesystem::path("results") / plan.campaign);
    if (arguments.dryRun)
        return dryRun(plan, folder, catalog);
    if (arguments.why)
        return sayWhy(plan, arguments, folder, catalog);

    const std::string caveats = warnings(arguments.jobs.value_or(plan.execution.jobs));
    Benchmark benchmark(std::move(plan), catalog);
    const Benchmark::Summary summary = runCampaign(benchmark, arguments, folder, catalog);
    for (const std::string &note : summary.notes)
        std::cerr << "note: " << note << '\n';
    if (summary.finished > 0)
        std::cerr << caveats << warnings(summary);
    if (summary.interrupted)
    {
        sayHowToGoOn(arguments, summary, folder);
        return ExitCode::interrupted;
    }
    sayResult(summary);
    if (!arguments.noReport)
        sayWhere(writeReports(benchmark.plan(), benchmark.plan().reports, folder, catalog), folder);
    return sayDefects(summary);
}

} // namespace mrpp

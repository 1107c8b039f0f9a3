#include "cli/Commands.h"
#include "cli/MissingPrograms.h"
#include "cli/SlurmScripts.h"
#include "framework/support/Error.h"
#include "framework/support/ReadableText.h"
#include "framework/system/File.h"
#include "framework/system/OutsideProgram.h"
#include "framework/system/TemporaryFolder.h"
#include "yaml/PlanReader.h"

#include <iostream>

namespace mrpp
{

namespace
{

void submit(const std::filesystem::path &script)
{
    const TemporaryFolder scratch;
    const ProgramEnd end = runProgram({.words = {"sh", script.string()}, .output = scratch.path() / "said"});
    if (end.exitCode != 0)
        throw InputError({script.string()}, "was refused by Slurm (see above); once that is mended, run it "
                                            "again: sh " +
                                                script.string());
    std::cout << readFile(scratch.path() / "said");
}

} // namespace

ExitCode slurm(const SlurmArguments &arguments, Catalog &catalog)
{
    const BenchmarkPlan plan = readPlan(arguments.plan, catalog, arguments.maps);
    noteMissingPrograms(plan);
    SlurmRequest request;
    request.folder = std::filesystem::absolute(arguments.folder).lexically_normal();
    request.plan = std::filesystem::absolute(arguments.plan).lexically_normal();
    request.program = {std::filesystem::canonical("/proc/self/exe").string()};
    for (const std::filesystem::path &plugin : catalog.plugins)
        request.program.insert(request.program.end(), {"--plugin", plugin.string()});
    for (const std::filesystem::path &maps : arguments.maps)
        request.options.insert(request.options.end(),
                               {"--maps", std::filesystem::absolute(maps).lexically_normal().string()});
    request.shards = arguments.shards;
    request.jobs = arguments.jobs.value_or(plan.execution.jobs);
    request.partition = arguments.partition;
    request.account = arguments.account;
    request.time = arguments.time;
    request.atOnce = arguments.atOnce;
    request.lines = arguments.lines;

    const SlurmScripts scripts = slurmScripts(plan, request);
    FileSet files;
    files.add(request.folder / "array.sh").write(scripts.array);
    files.add(request.folder / "merge.sh").write(scripts.merge);
    files.add(request.folder / "submit.sh").write(scripts.submit);
    files.commit();
    std::filesystem::create_directories(request.folder / "log");

    const ShardNeeds needs = shardNeeds(plan, request.shards, request.jobs);
    std::cout << counted(static_cast<std::size_t>(request.shards), "part") << " of at most "
              << request.time.value_or(std::to_string(needs.minutes) + " minutes") << ", "
              << counted(static_cast<std::size_t>(request.jobs), "core") << " and " << needs.memory
              << " MiB each; results will be in " << (request.folder / "results").string() << '\n';
    if (arguments.submit)
        submit(request.folder / "submit.sh");
    else
        std::cout << "to submit them: sh " << (request.folder / "submit.sh").string() << '\n';
    return ExitCode::done;
}

} // namespace mrpp

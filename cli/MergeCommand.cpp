#include "cli/Commands.h"
#include "cli/Reporting.h"
#include "framework/store/MergeCampaigns.h"
#include "framework/store/ResultStore.h"
#include "framework/support/Error.h"
#include "framework/support/ReadableText.h"

#include <iostream>

namespace mrpp
{

namespace
{

/// How many runs of the plan the folder does not hold; nothing where an input file is gone, so that nobody
/// knows.
std::optional<std::size_t> missingRuns(const BenchmarkPlan &plan, const std::filesystem::path &folder)
{
    const auto finished = ResultStore(folder, ResultStore::Access::read).finishedKeys();
    std::size_t missing = 0;
    for (const RunSpec &spec : expand(plan, MissingInput::tolerate))
    {
        if (spec.runKey.empty())
            return std::nullopt;
        missing += finished.contains(spec.runKey) ? 0 : 1;
    }
    return missing;
}

void sayWhatIsMissing(const std::filesystem::path &folder, Catalog &catalog)
{
    try
    {
        const BenchmarkPlan plan = campaignPlan(folder, catalog);
        const auto missing = missingRuns(plan, folder);
        if (missing && *missing > 0)
            std::cout << counted(*missing, "run") << " of the plan missing; to run them: mrppsim run "
                      << plan.file.string() << " -o " << folder.string() << '\n';
    }
    catch (const InputError &error) // the results are merged all the same
    {
        std::cerr << "note: the plan cannot be read here: " << error.what() << '\n';
    }
}

} // namespace

ExitCode merge(const MergeArguments &arguments, Catalog &catalog)
{
    const MergedCampaign merged = mergeCampaigns(arguments.out, arguments.folders);
    for (const std::string &note : merged.notes)
        std::cerr << "note: " << note << '\n';
    std::cout << counted(merged.runs, "run") << " in " << arguments.out.string() << ": " << merged.taken
              << " new, " << merged.twice << " found twice\n";
    sayWhatIsMissing(arguments.out, catalog);
    return ExitCode::done;
}

} // namespace mrpp

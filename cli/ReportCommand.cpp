#include "cli/Commands.h"
#include "cli/Reporting.h"
#include "framework/campaign/Provenance.h"
#include "framework/support/File.h"
#include "yaml/PlanReader.h"

namespace mrpp
{

namespace
{

/// The campaign's own copy of its plan, read as if it stood where it was run from: its relative paths, and
/// the campaign's name where the file gave it, start there.
BenchmarkPlan planOf(const std::filesystem::path &folder, const Catalog &catalog)
{
    const std::filesystem::path copy = folder / "plan.yaml";
    const std::filesystem::path provenanceFile = folder / "provenance.json";
    std::error_code error;
    if (!std::filesystem::exists(copy, error) || !std::filesystem::exists(provenanceFile, error))
        throw FileError({folder.string()},
                        "is no campaign's folder (plan.yaml and provenance.json are missing); "
                        "`mrppsim run` makes one");
    const Provenance provenance = Provenance::fromJson(readFile(provenanceFile), provenanceFile);
    return parsePlan(readFile(copy), std::filesystem::path(provenance.planFolder) / provenance.planFile,
                     catalog, {provenance.mapFolders.begin(), provenance.mapFolders.end()});
}

} // namespace

ExitCode report(const ReportArguments &arguments, const Catalog &catalog)
{
    const BenchmarkPlan plan = planOf(arguments.folder, catalog);
    const std::vector<std::string> &kinds = arguments.only.empty() ? plan.reports : arguments.only;
    sayWhere(writeReports(plan, kinds, arguments.folder, catalog), arguments.folder);
    return ExitCode::done;
}

} // namespace mrpp

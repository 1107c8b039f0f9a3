#include "cli/Reporting.h"

#include "framework/run/InProcessExecutor.h"
#include "framework/run/RunPlanner.h"
#include "framework/store/Provenance.h"
#include "framework/store/ResultStore.h"
#include "framework/store/ResultTable.h"
#include "framework/support/Error.h"
#include "framework/system/File.h"
#include "yaml/PlanReader.h"

#include <algorithm>
#include <iostream>

namespace mrpp
{

BenchmarkPlan campaignPlan(const std::filesystem::path &folder, Catalog &catalog,
                           const std::optional<std::string> &text)
{
    const std::filesystem::path copy = folder / "plan.yaml";
    const std::filesystem::path provenanceFile = folder / "provenance.json";
    std::error_code error;
    if (!std::filesystem::exists(copy, error) || !std::filesystem::exists(provenanceFile, error))
        throw FileError({folder.string()},
                        "is no campaign's folder (plan.yaml and provenance.json are missing); "
                        "`mrppsim run` makes one");
    const Provenance provenance = Provenance::fromJson(readFile(provenanceFile), provenanceFile);
    return parsePlan(text ? *text : readFile(copy),
                     std::filesystem::path(provenance.planFolder) / provenance.planFile, catalog,
                     {provenance.mapFolders.begin(), provenance.mapFolders.end()});
}

std::vector<std::filesystem::path> writeReports(const BenchmarkPlan &plan,
                                                const std::vector<std::string> &kinds,
                                                const std::filesystem::path &folder, const Catalog &catalog)
{
    std::vector<std::unique_ptr<Report>> reports;
    for (const std::string &kind : kinds)
        reports.push_back(catalog.reports.create(kind));

    const std::filesystem::path provenanceFile = folder / "provenance.json";
    const Provenance provenance = Provenance::fromJson(readFile(provenanceFile), provenanceFile);
    const ResultStore store(folder, ResultStore::Access::read);
    std::vector<NamedOptimizer> optimizers;
    for (const Configured &optimizer : plan.optimizers)
        optimizers.push_back({optimizer.name, create(catalog.optimizers, optimizer)});
    const ResultTable table(
        plan, store.records(), [&store](const std::string &runKey) { return store.solution(runKey); },
        [&store](const std::string &runKey) { return store.progress(runKey); },
        [&optimizers](const Instance &instance, Solution solution)
        { return improved(instance, std::move(solution), optimizers); });
    std::vector<std::filesystem::path> files;
    std::vector<std::string> complaints; // a report that cannot be written costs no other one
    for (std::size_t i = 0; i < reports.size(); ++i)
    {
        try
        {
            auto written = reports[i]->write(table, provenance, folder);
            files.insert(files.end(), written.begin(), written.end());
        }
        catch (const InputError &error)
        {
            const std::string complaint = error.what();
            if (std::find(complaints.begin(), complaints.end(), complaint) == complaints.end())
                complaints.push_back(complaint);
        }
    }
    if (complaints.empty())
        return files;
    std::string all;
    for (const std::string &complaint : complaints)
        all += (all.empty() ? "" : "; ") + complaint;
    throw InputError(all + "; all other reports are written");
}

namespace
{

/// What reports had to leave out, in a line on the standard error for each of them.
void sayWhatIsMissing(const std::vector<std::filesystem::path> &files)
{
    for (const std::filesystem::path &file : files)
    {
        if (file.filename() != "NOT_DRAWN.txt")
            continue;
        const std::string text = readFile(file);
        const auto lines = std::count(text.begin(), text.end(), '\n');
        std::cerr << "warning: " << text.substr(0, text.find('\n'));
        if (lines > 1)
            std::cerr << " (and " << lines - 1 << " more, see " << file.string() << ')';
        std::cerr << '\n';
    }
}

} // namespace

void sayWhere(const std::vector<std::filesystem::path> &files, const std::filesystem::path &folder)
{
    sayWhatIsMissing(files);
    for (const char *name : {"report.html", "report.pdf", "results.csv"})
    {
        const auto file = std::find_if(files.begin(), files.end(),
                                       [name](const auto &path) { return path.filename() == name; });
        if (file != files.end())
        {
            std::cout << "report: " << file->string() << '\n';
            return;
        }
    }
    std::cout << "results: " << folder.string() << '\n';
}

} // namespace mrpp

#include "reports/HtmlReport.h"

#include "framework/support/Config.h"
#include "framework/system/File.h"
#include "reports/explorer/ExplorerPage.h"
#include "reports/picture/Picture.h"
#include "reports/picture/Text.h"
#include "reports/summary/KeyFacts.h"

#include <algorithm>
#include <fmt/format.h>
#include <limits>
#include <numeric>

namespace mrpp
{

namespace
{

/// Takes in solutions, first repetitions first, as the plan chooses and as long as they fit; says for each
/// run why it cannot be played.
class SolutionChoice
{
public:
    SolutionChoice(const ResultTable &results, PlayableRuns &playable)
        : results_(results), choice_(results.plan().explorer), playable_(playable)
    {}

    std::vector<std::string> choose()
    {
        const std::vector<RunRecord> &records = results_.records();
        std::vector<std::size_t> order(records.size());
        std::iota(order.begin(), order.end(), std::size_t{0});
        std::stable_sort(order.begin(), order.end(),
                         [&](std::size_t a, std::size_t b)
                         { return records[a].repetition < records[b].repetition; });
        std::vector<std::string> absences(records.size());
        for (const std::size_t run : order)
            absences[run] = add(run, records[run]);
        return absences;
    }

private:
    const ResultTable &results_;
    const ExplorerChoice &choice_;
    PlayableRuns &playable_;
    std::optional<Instance> instance_; // of the last case
    std::string caseId_;
    std::int64_t tooLong_ = std::numeric_limits<std::int64_t>::max(); // moves that did not fit any more

    /// Empty where the run can be played.
    std::string add(std::size_t run, const RunRecord &record)
    {
        if (!record.pathLength)
            return "it has no solution";
        if (choice_.solutions == "none" || (choice_.solutions == "first" && record.repetition != 0))
            return fmt::format("the plan says explorer: {{solutions: {}}}", choice_.solutions);
        std::string tooLarge = fmt::format("the page would be too large; the plan says explorer: "
                                           "{{size: {} MB}}",
                                           formatNumber(choice_.size));
        if (*record.pathLength >= tooLong_)
            return tooLarge;
        const std::optional<Solution> solution = results_.solution(record);
        if (!solution)
            return "the solution was too long to be kept";
        if (!instance_ || caseId_ != record.caseId)
        {
            instance_ = results_.instance(record);
            caseId_ = record.caseId;
        }
        if (!instance_)
            return "its input files are gone, so the instance cannot be made again";
        const auto optimized = results_.optimizedSolution(record, *instance_, *solution);
        if (playable_.add(run, record.caseId, *instance_, *solution, optimized ? &*optimized : nullptr))
            return "";
        tooLong_ = *record.pathLength;
        return tooLarge;
    }
};

std::vector<std::string> plannerNames(const ResultTable &results)
{
    std::vector<std::string> names;
    const auto add = [&names](const std::string &name)
    {
        if (std::find(names.begin(), names.end(), name) == names.end())
            names.push_back(name);
    };
    for (const Configured &planner : results.plan().planners)
        add(planner.name);
    for (const RunRecord &record : results.records())
        add(record.planner);
    return names;
}

std::vector<std::pair<std::string, std::string>> lines(const Provenance &provenance,
                                                       const ResultTable &results)
{
    std::vector<std::pair<std::string, std::string>> lines = {
        {"campaign", provenance.campaign},
        {"runs", fmt::format("{} of {}", results.records().size(), results.plannedRuns())},
        {"started", provenance.started},
        {"finished", provenance.finished},
        {"program", "MRPPSim " + provenance.version},
        {"revision", provenance.revision},
        {"compiler", provenance.compiler + ", " + provenance.buildType},
        {"host", provenance.host},
        {"system", provenance.system},
        {"processor",
         fmt::format("{}, {}, {:.0f} MB", provenance.cpu,
                     counted(static_cast<std::size_t>(provenance.cores), "core"), provenance.memory)},
        {"seed", std::to_string(provenance.seed)},
        {"plan", provenance.planFile + ", " + provenance.planFingerprint},
        {"libraries", fmt::format("{}", fmt::join(provenance.libraries, ", "))},
    };
    std::erase_if(lines, [](const auto &line) { return line.second.empty(); });
    return lines;
}

} // namespace

std::vector<std::filesystem::path> HtmlReport::write(const ResultTable &results, const Provenance &provenance,
                                                     const std::filesystem::path &folder) const
{
    if (!hasExplorer())
        return writeComplaints(folder, {"report.html: this mrppsim was built without Node.js and npm, so it "
                                        "has no explorer"});
    constexpr double kBytesAMegabyte = 1e6;
    PlayableRuns playable(static_cast<std::size_t>(results.plan().explorer.size * kBytesAMegabyte));
    ExplorerContents contents;
    contents.title = results.plan().campaign;
    contents.facts = keyFacts(results);
    contents.provenance = lines(provenance, results);
    contents.plan = results.plan().text;
    contents.planners = plannerNames(results);
    contents.records = results.records();
    contents.absences = SolutionChoice(results, playable).choose();
    contents.playable = &playable;
    static_cast<void>(writeComplaints(folder, {})); // an earlier one may stand there
    writeFile(folder / "report.html", explorerPage(contents));
    return {folder / "report.html"};
}

} // namespace mrpp

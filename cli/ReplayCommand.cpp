#include "cli/Commands.h"
#include "cli/Interruption.h"
#include "cli/Reporting.h"
#include "framework/run/Answer.h"
#include "framework/run/InProcessExecutor.h"
#include "framework/run/RunRecordJson.h"
#include "framework/store/ResultStore.h"
#include "framework/support/ReadableText.h"
#include "framework/worker/WorkerExecutor.h"
#include "problems/formats/Formats.h"

#include <fmt/format.h>

#include <algorithm>
#include <iostream>
#include <set>

namespace mrpp
{

namespace
{

/// The only finished run whose key begins so.
RunRecord findRun(const ResultStore &store, const ReplayArguments &arguments)
{
    const std::set<std::string> found = store.finishedKeys(arguments.key);
    if (found.empty())
        throw InputError({arguments.folder.string()},
                         "holds no finished run '" + arguments.key +
                             "'; the keys stand in the column run_key of results.csv");
    if (found.size() == 1)
        return store.record(*found.begin()).value();
    constexpr std::size_t kShown = 3;
    std::string keys;
    std::size_t shown = 0;
    for (auto key = found.begin(); key != found.end() && shown < kShown; ++key, ++shown)
        keys += (shown == 0 ? "" : ", ") + *key;
    throw InputError({arguments.folder.string()},
                     counted(found.size(), "run") + " begin with '" + arguments.key + "': " + keys +
                         (found.size() > kShown ? ", …" : "") + "; give more of the key");
}

RunSpec specOf(const RunRecord &record, const BenchmarkPlan &plan)
{
    for (RunSpec &spec : expand(plan))
        if (spec.runKey == record.runKey)
            return std::move(spec);
    throw InputError({plan.file.string()},
                     "the plan does not lead to run " + record.runKey +
                         " any more: an input file has changed since then, or the run is "
                         "that of another version of this program");
}

RunResult runAgain(const ReplayArguments &arguments, const BenchmarkPlan &plan, const RunSpec &spec,
                   const Catalog &catalog, const std::stop_token &stop)
{
    if (!arguments.inProcess && plan.execution.isolation == "process")
        return WorkerExecutor(workerCommand(catalog), plan, catalog, 1, true).execute(spec, stop);
    return InProcessExecutor(plan, catalog, 1).execute(spec, stop);
}

/// The cells of both records, a column a line, where one has something to show.
void sayBeside(const RunRecord &recorded, const RunRecord &now)
{
    const auto different = answerDifferences(recorded, now);
    const auto line =
        [](const std::string &name, const std::string &a, const std::string &b, const char *sign)
    { std::cout << fmt::format("{:<26}{:<34}{:<2}{}\n", oneLine(name), oneLine(a), sign, oneLine(b)); };
    line("", "recorded", "now", "");
    for (const RunColumn &column : runColumns())
    {
        const std::string a = toText(column.get(recorded));
        const std::string b = toText(column.get(now));
        const bool differs = std::find(different.begin(), different.end(), column.name) != different.end();
        if (column.name != "attempt" && (!a.empty() || !b.empty()))
            line(std::string(column.name), a, b, differs ? "≠" : "");
    }
    std::map<std::string, Value> extra = recorded.extra;
    extra.insert(now.extra.begin(), now.extra.end());
    const auto cell = [](const RunRecord &record, const std::string &name)
    { return record.extra.contains(name) ? toText(record.extra.at(name)) : std::string(); };
    for (const auto &[name, value] : extra)
        line(name, cell(recorded, name), cell(now, name), "");
}

void writeFiles(const ReplayArguments &arguments, const RunResult &result)
{
    FileSet files;
    if (arguments.graph && result.instance)
        saveGraph(files, *arguments.graph, *result.instance->graph);
    if (arguments.instance && result.instance)
        saveInstance(files, *arguments.instance, *result.instance, *arguments.graph);
    if (arguments.solution && !result.record.solutionFingerprint.empty())
        saveSolution(files, *arguments.solution, result.solution);
    else if (arguments.solution)
        std::cerr << "no solution, so no file of moves was written\n";
    if (arguments.json)
        files.add(*arguments.json).write(toJson(result.record, JsonColumns::all));
    files.commit();
}

} // namespace

ExitCode replay(const ReplayArguments &arguments, Catalog &catalog)
{
    const ResultStore store(arguments.folder, ResultStore::Access::read);
    const RunRecord recorded = findRun(store, arguments);
    const BenchmarkPlan plan = campaignPlan(arguments.folder, catalog, store.planText(recorded.runKey));
    const RunSpec spec = specOf(recorded, plan);
    RunResult result;
    {
        const Interruption interruption;
        result = runAgain(arguments, plan, spec, catalog, interruption.token());
        if (interruption.happened())
        {
            std::cerr << "interrupted; nothing was written\n";
            return ExitCode::interrupted;
        }
    }
    sayBeside(recorded, result.record);
    writeFiles(arguments, result);
    const auto different = answerDifferences(recorded, result.record);
    if (different.empty())
    {
        std::cout << (result.record.solutionFingerprint.empty() ? "the same end\n" : "the same solution\n");
        return ExitCode::done;
    }
    std::cout << "another answer:";
    for (const std::string_view name : different)
        std::cout << ' ' << name;
    std::cout << '\n';
    return ExitCode::no;
}

} // namespace mrpp

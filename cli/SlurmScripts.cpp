#include "cli/SlurmScripts.h"

#include "framework/plan/Shards.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>

namespace mrpp
{

namespace
{

/// One word for a shell, whatever is in it.
std::string quoted(const std::string &word)
{
    std::string text = "'";
    for (const char c : word)
        text += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return text + "'";
}

std::string quoted(const std::vector<std::string> &words)
{
    std::string text;
    for (const std::string &word : words)
        text += (text.empty() ? "" : " ") + quoted(word);
    return text;
}

/// One value in a line of options, where a backslash takes the meaning of what follows.
std::string forSlurm(const std::string &value)
{
    std::string text;
    for (const char c : value)
        text += c == '"' || c == '\\' ? std::string("\\") + c : std::string(1, c == '\n' ? ' ' : c);
    return "\"" + text + "\"";
}

/// In names of files % begins a pattern.
std::string withoutPatterns(const std::string &name)
{
    std::string text;
    for (const char c : name)
        text += c == '%' ? std::string("%%") : std::string(1, c);
    return text;
}

std::string jobName(const std::string &campaign)
{
    const bool isPlain =
        std::all_of(campaign.begin(), campaign.end(),
                    [](unsigned char c) { return std::isalnum(c) != 0 || c == '-' || c == '_' || c == '.'; });
    return isPlain ? campaign : forSlurm(campaign);
}

/// What both jobs ask of Slurm.
std::string commonLines(const SlurmRequest &request, const std::string &log)
{
    std::string lines;
    const auto add = [&lines](const std::string &option) { lines += "#SBATCH " + option + "\n"; };
    add("--nodes=1");
    add("--ntasks=1");
    add("--requeue");
    add("--open-mode=append");
    add("--output=" + forSlurm(withoutPatterns((request.folder / "log").string()) + "/" + log));
    if (request.partition)
        add("--partition=" + *request.partition);
    if (request.account)
        add("--account=" + *request.account);
    for (const std::string &line : request.lines)
        add(line);
    return lines;
}

} // namespace

ShardNeeds shardNeeds(const BenchmarkPlan &plan, std::int64_t shards, std::int64_t jobs)
{
    std::vector<std::int64_t> runs(static_cast<std::size_t>(shards) + 1, 0);
    for (const RunSpec &spec : expand(plan, MissingInput::tolerate))
        ++runs[static_cast<std::size_t>(shardOf(plan, spec, shards))];
    constexpr double kOverhead = 5; // seconds a run: setup, checks
    constexpr double kMargin = 10;  // minutes
    constexpr double kProgram = 1000;
    const double phases = 1 + static_cast<double>(plan.optimizers.size());
    const double seconds = static_cast<double>(*std::max_element(runs.begin(), runs.end())) *
                           (plan.limits.time * phases + kOverhead) / static_cast<double>(jobs);
    constexpr double kMiB = 1.048576;
    return {static_cast<std::int64_t>(std::ceil(seconds / 60 + kMargin)),
            static_cast<std::int64_t>(
                std::ceil((static_cast<double>(jobs) * plan.limits.memory + kProgram) / kMiB))};
}

SlurmScripts slurmScripts(const BenchmarkPlan &plan, const SlurmRequest &request)
{
    const ShardNeeds needs = shardNeeds(plan, request.shards, request.jobs);
    const std::string program = quoted(request.program);
    const std::string folder = quoted(request.folder.string());
    SlurmScripts scripts;
    scripts.array = fmt::format(
        R"(#!/bin/bash
#SBATCH --job-name={campaign}
#SBATCH --array=1-{shards}{atOnce}
#SBATCH --cpus-per-task={jobs}
#SBATCH --time={time}
#SBATCH --mem={memory}M
#SBATCH --signal=B:TERM@60
{common}
# One part of the campaign. What it has finished is kept: a part that is begun again goes on.
cd {folder} || exit 1
part=$SLURM_ARRAY_TASK_ID
echo "part $part of {shards} on $(hostname), begun again ${{SLURM_RESTART_COUNT:-0}} times"
interrupted=130
unusable=2

# A node that was taken for dead may still be at work on the part. Then its folder is locked, and this go takes a
# folder of its own: merging counts each run once.
for go in $(seq 0 "${{SLURM_RESTART_COUNT:-0}}"); do
    {program} run {plan} -o "parts/$part.$go" --shard "$part/{shards}" --jobs {jobs} --no-report --quiet{options} &
    program=$!
    trap 'kill -TERM "$program"' TERM
    wait "$program"
    code=$?
    while kill -0 "$program" 2>/dev/null; do # the signal came first
        wait "$program"
        code=$?
    done
    [ "$code" -eq "$unusable" ] || break
done

# The time is up: the same part again, from where it stopped.
[ "$code" -ne "$interrupted" ] || scontrol requeue "${{SLURM_ARRAY_JOB_ID}}_$part"
exit "$code"
)",
        fmt::arg("campaign", jobName(plan.campaign)), fmt::arg("shards", request.shards),
        fmt::arg("atOnce", request.atOnce ? "%" + std::to_string(*request.atOnce) : ""),
        fmt::arg("jobs", request.jobs),
        fmt::arg("time", request.time.value_or(std::to_string(needs.minutes))),
        fmt::arg("memory", needs.memory), fmt::arg("common", commonLines(request, "part-%a.txt")),
        fmt::arg("folder", folder), fmt::arg("program", program),
        fmt::arg("plan", quoted(request.plan.string())),
        fmt::arg("options", request.options.empty() ? "" : " " + quoted(request.options)));
    scripts.merge = fmt::format(R"(#!/bin/bash
#SBATCH --job-name={campaign}
#SBATCH --cpus-per-task=1
#SBATCH --time=60
#SBATCH --mem=2048M
{common}
cd {folder} || exit 1
{program} merge results parts/* && {program} report results
)",
                                fmt::arg("campaign", jobName(plan.campaign + "-merge")),
                                fmt::arg("common", commonLines(request, "merge.txt")),
                                fmt::arg("folder", folder), fmt::arg("program", program));
    scripts.submit = fmt::format(R"(#!/bin/sh
# Submits the parts, and behind them, however they end, what merges them and writes the reports.
set -e
cd {folder}
parts=$(sbatch --parsable array.sh)
parts=${{parts%%;*}}
merge=$(sbatch --parsable --dependency="afterany:$parts" merge.sh)
echo "submitted: parts $parts, merge and report ${{merge%%;*}}"
)",
                                 fmt::arg("folder", folder));
    return scripts;
}

} // namespace mrpp

#include "framework/campaign/RunKey.h"

#include "framework/support/Config.h"
#include "framework/support/Fingerprint.h"

#include <algorithm>
#include <fmt/core.h>
#include <sstream>

namespace mrpp
{

namespace
{

using Settings = std::vector<std::pair<std::string, std::string>>;

/// Sorted, and numbers in one spelling, as neither their order nor their spelling matters.
Settings canonical(Settings settings)
{
    for (auto &[name, value] : settings)
        if (const auto number = parseNumber(value))
            value = formatNumber(*number);
    std::sort(settings.begin(), settings.end());
    return settings;
}

/// As the plan says it.
const Settings &written(const Configured &configured)
{
    return configured.settings;
}

/// As the program runs it, as far as that is known.
const Settings &effective(const Configured &configured)
{
    return configured.effective.empty() ? configured.settings : configured.effective;
}

std::string hash(const KeyParts &parts)
{
    Fingerprint hash;
    for (const auto &[name, value] : parts)
        hash.add(name).add(value);
    return hash.hex();
}

std::string hash(const Configured &configured, const Settings &settings)
{
    KeyParts parts = canonical(settings);
    parts.insert(parts.begin(), {"", configured.kind});
    return hash(parts);
}

/// "trimmer depth=2, other".
std::string inWords(const std::vector<Configured> &all, const Settings &(*settingsOf)(const Configured &))
{
    std::string text;
    for (const Configured &configured : all)
    {
        text += (text.empty() ? "" : ", ") + configured.kind;
        for (const auto &[name, value] : canonical(settingsOf(configured)))
            text.append(" ").append(name).append("=").append(value);
    }
    return text;
}

KeyParts partsOf(const BenchmarkPlan &plan, const Settings &(*settingsOf)(const Configured &))
{
    return {{"time limit", formatNumber(plan.limits.time)},
            {"CPU limit", plan.limits.cpu ? formatNumber(*plan.limits.cpu) : "none"},
            {"memory limit", formatNumber(plan.limits.memory)},
            {"motion rule", std::string(toString(plan.motion))},
            {"optimizers", inWords(plan.optimizers, settingsOf)},
            {"timing repeats", std::to_string(plan.execution.timingRepeats)},
            {"warm-up", std::to_string(plan.execution.warmUp)}};
}

} // namespace

KeyParts campaignParts(const BenchmarkPlan &plan)
{
    return partsOf(plan, effective);
}

KeyParts pointParts(const ProblemPoint &point, const std::string &inputs)
{
    return {{"problem", point.model + " " + point.settings},
            {"problem's defaults", point.defaults},
            {"input files", inputs}};
}

KeyParts plannerParts(const Configured &planner)
{
    KeyParts parts = {{"planner", planner.kind}};
    for (const auto &[name, value] : canonical(effective(planner)))
        parts.emplace_back(name == kVersionSetting ? "algorithm version" : "parameter " + name, value);
    return parts;
}

KeyParts experimentParts(const BenchmarkPlan &plan, std::size_t point, const std::string &inputs)
{
    KeyParts parts = pointParts(plan.points[point], inputs);
    const KeyParts campaign = campaignParts(plan);
    parts.insert(parts.end(), campaign.begin(), campaign.end());
    parts.emplace_back("campaign's seed", std::to_string(plan.seed));
    return parts;
}

std::string toText(const KeyParts &parts)
{
    std::string text;
    for (const auto &[name, value] : parts)
    {
        text += name + ": ";
        for (const char c : value)
            text += c == '\n' || c == '\r' ? ' ' : c;
        text += '\n';
    }
    return text;
}

KeyParts keyParts(const std::string &text)
{
    KeyParts parts;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);)
        if (const std::size_t colon = line.find(": "); colon != std::string::npos)
            parts.emplace_back(line.substr(0, colon), line.substr(colon + 2));
    return parts;
}

std::string differences(const KeyParts &before, const KeyParts &now)
{
    const auto find = [](const KeyParts &parts, const std::string &name) {
        return std::find_if(parts.begin(), parts.end(), [&](const auto &part) { return part.first == name; });
    };
    std::string text;
    const auto add = [&text](const std::string &words) { text += (text.empty() ? "" : "; ") + words; };
    for (const auto &[name, value] : now)
        if (const auto was = find(before, name); was == before.end())
            add(fmt::format("{} is new: {}", name, value));
        else if (was->second != value && name == "input files")
            add("input files changed");
        else if (was->second != value)
            add(fmt::format("{} was '{}', is '{}'", name, was->second, value));
    for (const auto &[name, value] : before)
        if (find(now, name) == now.end())
            add(fmt::format("{} is gone: '{}'", name, value));
    return text;
}

RunKeys::RunKeys(const BenchmarkPlan &plan)
{
    campaign_ = {hash(partsOf(plan, effective)), hash(partsOf(plan, written))};
    for (const Configured &planner : plan.planners)
        planners_.push_back({hash(planner, effective(planner)), hash(planner, written(planner))});
    for (std::size_t i = 0; i < planners_.size(); ++i)
    {
        const auto isSame = [this, i](const Hashes &other) { return other.run == planners_[i].run; };
        const auto here = planners_.begin() + static_cast<std::ptrdiff_t>(i);
        earlierPlanners_.push_back(
            static_cast<std::uint64_t>(std::count_if(planners_.begin(), here, isSame)));
        samePlanners_.push_back(
            static_cast<std::uint64_t>(std::count_if(planners_.begin(), planners_.end(), isSame)));
    }
}

void RunKeys::enter(const ProblemPoint &point, const std::string &inputs)
{
    ProblemPoint asWritten = point;
    asWritten.defaults.clear();
    point_ = {hash(pointParts(point, inputs)), hash(pointParts(asWritten, inputs))};
    earlierPoints_ = points_[point_.run]++;
}

void RunKeys::set(RunSpec &spec) const
{
    const std::uint64_t earlier =
        earlierPoints_ * samePlanners_[spec.planner] + earlierPlanners_[spec.planner];
    const auto key = [&spec, earlier](const char *kind, const std::string &campaign, const std::string &point,
                                      const std::string &planner)
    {
        return Fingerprint()
            .add(kind)
            .add(campaign)
            .add(point)
            .add(planner)
            .add(spec.graphSeed)
            .add(spec.instanceSeed)
            .add(spec.plannerSeed)
            .add(earlier)
            .hex();
    };
    spec.runKey = key("run 2", campaign_.run, point_.run, planners_[spec.planner].run);
    spec.planKey = key("plan 2", campaign_.plan, point_.plan, planners_[spec.planner].plan);
}

} // namespace mrpp

#include "framework/plan/RunKey.h"

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

constexpr const char *kFilePart = "file "; // and its name

Settings sorted(Settings settings)
{
    std::sort(settings.begin(), settings.end());
    return settings;
}

/// As the program runs it, as far as that is known: every parameter, as its type writes it. Texts stay what
/// they are; "5", "5.0" and "+5" are one number.
Settings effective(const Configured &configured)
{
    return sorted(configured.effective.empty() ? configured.settings : configured.effective);
}

/// What the plan says of it, written in the same way.
Settings written(const Configured &configured)
{
    Settings settings = configured.settings;
    for (auto &[name, value] : settings)
        for (const auto &[parameter, now] : configured.effective)
            if (parameter == name && parseNumber(now))
                value = now;
    return sorted(std::move(settings));
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
    KeyParts parts = settings;
    parts.insert(parts.begin(), {"", configured.kind});
    return hash(parts);
}

/// "trimmer depth=2, other".
std::string inWords(const std::vector<Configured> &all, Settings (*settingsOf)(const Configured &))
{
    std::string text;
    for (const Configured &configured : all)
    {
        text += (text.empty() ? "" : ", ") + configured.kind;
        for (const auto &[name, value] : settingsOf(configured))
            text.append(" ").append(name).append("=").append(value);
    }
    return text;
}

KeyParts partsOf(const BenchmarkPlan &plan, Settings (*settingsOf)(const Configured &))
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

KeyParts plannerParts(const Configured &planner, const FileHashes &files)
{
    KeyParts parts = {{"planner", planner.kind}};
    for (const auto &[name, value] : effective(planner))
        parts.emplace_back(name == kVersionSetting ? "algorithm version" : "parameter " + name, value);
    for (const auto &[name, hash] : files)
        parts.emplace_back(kFilePart + name, hash);
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
            text += c == '\n' ? "\\n" : c == '\r' ? "\\r" : c == '\\' ? "\\\\" : std::string(1, c);
        text += '\n';
    }
    return text;
}

KeyParts keyParts(const std::string &text)
{
    KeyParts parts;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);)
    {
        const std::size_t colon = line.find(": ");
        if (colon == std::string::npos)
            continue;
        std::string value;
        for (std::size_t i = colon + 2; i < line.size(); ++i)
        {
            const bool escaped = line[i] == '\\' && i + 1 < line.size();
            const char c = line[escaped ? ++i : i];
            value += !escaped ? c : c == 'n' ? '\n' : c == 'r' ? '\r' : c;
        }
        parts.emplace_back(line.substr(0, colon), std::move(value));
    }
    return parts;
}

std::string differences(const KeyParts &before, const KeyParts &now)
{
    const auto find = [](const KeyParts &parts, const std::string &name) {
        return std::find_if(parts.begin(), parts.end(), [&](const auto &part) { return part.first == name; });
    };
    const auto isHash = [](const std::string &name)
    { return name == "input files" || name.starts_with(kFilePart); };
    std::string text;
    const auto add = [&text](const std::string &words) { text += (text.empty() ? "" : "; ") + words; };
    for (const auto &[name, value] : now)
        if (const auto was = find(before, name); was == before.end())
            add(isHash(name) ? name + " is new" : fmt::format("{} is new: {}", name, value));
        else if (was->second != value)
            add(isHash(name) ? name + " changed"
                             : fmt::format("{} was '{}', is '{}'", name, was->second, value));
    for (const auto &[name, value] : before)
        if (find(now, name) == now.end())
            add(isHash(name) ? name + " is gone" : fmt::format("{} is gone: '{}'", name, value));
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

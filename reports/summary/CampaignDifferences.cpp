#include "reports/summary/CampaignDifferences.h"

#include "reports/picture/Text.h"

#include <algorithm>
#include <fmt/format.h>
#include <map>
#include <set>

namespace mrpp
{

namespace
{

constexpr const char *kUnknown = "not recorded";

/// "name: was before, is now", and of what that is said.
class Changes
{
public:
    void add(const std::string &name, const std::string &was, const std::string &is, const std::string &of)
    {
        if (was == is)
            return;
        const std::string text = name == "input files"
                                     ? "input files: others"
                                     : fmt::format("{}: {} before, {} now", name, shown(was), shown(is));
        if (of_.try_emplace(text).second)
            order_.push_back(text);
        of_[text].insert(of);
    }

    /// All parts of two descriptions of one thing.
    void add(const KeyParts &before, const KeyParts &now, const std::string &of)
    {
        std::map<std::string, std::string> were(before.begin(), before.end());
        for (const auto &[name, value] : now)
        {
            const auto was = were.find(name);
            add(name, was == were.end() ? kUnknown : was->second, value, of);
            were.erase(name);
        }
        for (const auto &[name, value] : were)
            add(name, value, kUnknown, of);
    }

    /// \param all of how many things is spoken: what holds for all of them needs no names
    void list(std::vector<std::string> &lines, std::size_t all) const
    {
        constexpr std::size_t kNamed = 4;
        for (const std::string &text : order_)
        {
            std::string line = text;
            const std::set<std::string> &of = of_.at(text);
            if (of.size() < all)
            {
                std::string names;
                std::size_t named = 0;
                for (const std::string &name : of)
                    if (named++ < kNamed)
                        names += (names.empty() ? "" : ", ") + name;
                if (of.size() > kNamed)
                    names += fmt::format(" and {} more", of.size() - kNamed);
                line += " (" + names + ")";
            }
            lines.push_back(oneLine(line));
        }
    }

private:
    std::vector<std::string> order_;
    std::map<std::string, std::set<std::string>> of_;

    static std::string shown(const std::string &value) { return value.empty() ? "none" : value; }
};

/// Compares what both have.
void compareShared(const std::map<std::string, KeyParts> &before, const std::map<std::string, KeyParts> &now,
                   std::vector<std::string> &lines)
{
    Changes changes;
    std::size_t shared = 0;
    for (const auto &[name, parts] : now)
        if (const auto was = before.find(name); was != before.end())
        {
            changes.add(was->second, parts, name);
            ++shared;
        }
    changes.list(lines, shared);
}

std::map<std::string, KeyParts> plannersOf(const BenchmarkPlan &plan)
{
    std::map<std::string, KeyParts> planners;
    for (const Configured &planner : plan.planners)
        planners[planner.name] = plannerParts(planner, {}); // the files of then are not known
    return planners;
}

bool shareAny(const std::map<std::string, KeyParts> &a, const std::map<std::string, KeyParts> &b)
{
    return std::any_of(a.begin(), a.end(), [&b](const auto &entry) { return b.contains(entry.first); });
}

} // namespace

std::vector<std::string> campaignDifferences(const ComparedCampaign &before, const ComparedCampaign &now)
{
    std::vector<std::string> lines;
    if (shareAny(before.asked.points, now.asked.points))
        compareShared(before.asked.points, now.asked.points, lines);
    else
        compareShared({{"", campaignParts(before.plan)}}, {{"", campaignParts(now.plan)}}, lines);
    if (shareAny(before.asked.planners, now.asked.planners))
        compareShared(before.asked.planners, now.asked.planners, lines);
    else
        compareShared(plannersOf(before.plan), plannersOf(now.plan), lines);

    Changes rules;
    std::size_t shared = 0;
    for (const Configured &planner : now.plan.planners)
        for (const Configured &was : before.plan.planners)
            if (was.name == planner.name)
            {
                rules.add("motion rule of its solutions", std::string(toString(was.motion)),
                          std::string(toString(planner.motion)), planner.name);
                ++shared;
            }
    rules.list(lines, shared + 1); // always with names

    Changes surroundings;
    const auto compare = [&surroundings](const char *name, const auto &was, const auto &is)
    { surroundings.add(name, fmt::format("{}", was), fmt::format("{}", is), ""); };
    compare("repetitions", before.plan.repetitions, now.plan.repetitions);
    compare("jobs", before.plan.execution.jobs, now.plan.execution.jobs);
    compare("isolation", before.plan.execution.isolation, now.plan.execution.isolation);
    compare("program", before.provenance.version, now.provenance.version);
    compare("revision", before.provenance.revision, now.provenance.revision);
    compare("compiler", before.provenance.compiler, now.provenance.compiler);
    compare("build type", before.provenance.buildType, now.provenance.buildType);
    compare("host", before.provenance.host, now.provenance.host);
    compare("processor", before.provenance.cpu, now.provenance.cpu);
    compare("cores", before.provenance.cores, now.provenance.cores);
    surroundings.list(lines, 1);
    return lines;
}

} // namespace mrpp

#include "yaml/ProblemList.h"

#include "framework/support/Suggestion.h"
#include "yaml/Sweep.h"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

namespace mrpp
{

namespace
{

/// What the figures show as one problem.
using Label = std::tuple<std::string, std::string, std::string>; ///< model, name, swept variable

Label labelOf(const ProblemPoint &point)
{
    return {point.model, point.name, point.sweepVariable};
}

std::string robotsOf(const ProblemPoint &point)
{
    const auto &robots = point.problem->robots();
    if (!robots)
        return {};
    static constexpr const char *kKeys[] = {"robots", "free", "occupancy"};
    return std::string(kKeys[static_cast<int>(robots->by)]) + "=" + formatNumber(robots->value);
}

/// Knows the problems of the plan so far and gives each its own name.
class Names
{
public:
    /// Renames points whose label is another problem's; `points` are one entry's.
    void settle(std::vector<ProblemPoint> &points, const SourceLocation &where)
    {
        std::map<Label, std::string> renamed;
        for (ProblemPoint &point : points)
        {
            if (!contents_.insert(point.model + point.settings).second)
                throw PlanError(where, "the problem '" + point.name + "'" +
                                           (robotsOf(point).empty() ? "" : " with " + robotsOf(point)) +
                                           " is in the plan already; leave it out once");
            const Label label = labelOf(point);
            auto known = renamed.find(label);
            if (known == renamed.end())
                known = renamed.emplace(label, freeName(point)).first;
            point.name = known->second;
        }
        for (const ProblemPoint &point : points)
            owners_.emplace(labelOf(point), ownerOf(point));
    }

private:
    /// Points of one owner may share a label: the same problem with another number of robots.
    static std::string ownerOf(const ProblemPoint &point)
    {
        return RobotCount::key(point.sweepVariable) ? point.problem->identity() : point.settings;
    }

    [[nodiscard]] bool isFree(const ProblemPoint &point) const
    {
        const auto owner = owners_.find(labelOf(point));
        return owner == owners_.end() ||
               (RobotCount::key(point.sweepVariable) && owner->second == ownerOf(point));
    }

    [[nodiscard]] std::string freeName(ProblemPoint point) const
    {
        if (isFree(point))
            return point.name;
        if (point.sweepVariable.empty() && point.problem->robots())
        {
            point.name += " " + robotsOf(point);
            if (isFree(point))
                return point.name;
        }
        const std::string stem = point.name;
        for (int i = 2; !isFree(point); ++i)
            point.name = stem + " (" + std::to_string(i) + ")";
        return point.name;
    }

    std::set<std::string> contents_;
    std::map<Label, std::string> owners_;
};

} // namespace

std::vector<ProblemPoint> readProblems(const std::vector<Config> &entries, const ProblemContext &context,
                                       std::vector<PointPlaces> *places)
{
    std::vector<ProblemPoint> all;
    Names names;
    for (const Config &entry : entries)
    {
        if (!entry.isScalar() && !(entry.isMap() && entry.entries().size() == 1))
            throw PlanError(entry.isMap() && entry.entries().size() > 1 ? entry.entries()[1].where
                                                                        : entry.where(),
                            "a problem is one family with its settings, as in '- small_benchmark: tree'");
        const std::string &family = entry.isScalar() ? entry.text() : entry.entries().front().key;
        const SourceLocation &where = entry.isScalar() ? entry.where() : entry.entries().front().where;
        if (context.catalog->problems.find(family) == nullptr)
            throw PlanError(where, "there is no problem '" + family + "'" +
                                       suggestion(family, context.catalog->problems.names()));
        auto points = expandProblem(
            family, where, entry.isScalar() ? Config() : entry.entries().front().value, context, places);
        names.settle(points, where);
        if (all.size() + points.size() > kMaximalPoints)
            throw PlanError(where,
                            "the plan has more than " + std::to_string(kMaximalPoints) + " problem points");
        std::move(points.begin(), points.end(), std::back_inserter(all));
    }
    return all;
}

} // namespace mrpp

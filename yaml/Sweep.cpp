#include "yaml/Sweep.h"

#include "framework/support/CanonicalSettings.h"
#include "framework/support/Suggestion.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <limits>
#include <map>
#include <set>
#include <utility>

namespace mrpp
{

namespace
{

/// Where a node stands in a tree: which child to take at each level.
using Path = std::vector<std::size_t>;

Config &at(Config &root, const Path &path)
{
    Config *node = &root;
    for (const std::size_t index : path)
        node = node->isMap() ? &node->entries()[index].value : &node->items()[index];
    return *node;
}

/// A number that is swept.
struct Axis
{
    std::string key;
    std::vector<Path> targets; ///< where its value is put; several for `x`
    std::vector<Config> values;
    bool countsRobots = false;
};

/// A tree without lists of texts or maps, and which of their texts it took.
struct Alternative
{
    Config tree;
    std::vector<std::pair<std::string, std::string>> choices; ///< key, text
};

/// One problem: a tree whose only sweep is the axis.
struct Group
{
    Config tree;
    std::vector<std::pair<std::string, std::string>> choices;
    const Axis *axis = nullptr; ///< null where nothing is swept
    std::string name;
    std::vector<ProblemPoint> points;
    std::vector<PointPlaces> places = {}; ///< of each point, where they are asked for
};

/// 0.1 + 2 · 0.1 is 0.3: the digits that the plan's numbers can mean, and no more.
std::string tidyNumber(double value)
{
    char buffer[40];
    std::snprintf(buffer, sizeof buffer, "%.12g", value); // the C locale: the program never sets another
    const auto tidy = parseNumber(buffer);
    return formatNumber(tidy ? *tidy : value);
}

[[noreturn]] void refuseTooMany(const SourceLocation &where)
{
    throw PlanError(where, "more than " + std::to_string(kMaximalPoints) + " points; sweep in larger steps");
}

std::vector<Config> integerSteps(std::int64_t from, std::int64_t to, std::int64_t step,
                                 const SourceLocation &where)
{
    const auto distance = static_cast<std::uint64_t>(to) - static_cast<std::uint64_t>(from);
    const std::uint64_t last = distance / static_cast<std::uint64_t>(step);
    if (last >= kMaximalPoints)
        refuseTooMany(where);
    std::vector<Config> values;
    for (std::uint64_t i = 0; i <= last; ++i)
        values.push_back(Config::scalar(std::to_string(from + static_cast<std::int64_t>(i) * step), where));
    return values;
}

std::vector<Config> realSteps(double from, double to, double step, const SourceLocation &where)
{
    constexpr double kSlack = 1e-9; // (0.3 − 0.1) / 0.1 is a hair below 2
    const double last = std::floor((to - from) / step + kSlack);
    if (!(last < static_cast<double>(kMaximalPoints)))
        refuseTooMany(where);
    std::vector<Config> values;
    for (std::size_t i = 0; i <= static_cast<std::size_t>(last); ++i)
        values.push_back(Config::scalar(tidyNumber(from + static_cast<double>(i) * step), where));
    return values;
}

std::vector<Config> factors(double from, double to, double factor, const SourceLocation &where)
{
    constexpr double kSlack = 1e-12;
    std::vector<Config> values;
    for (int i = 0;; ++i)
    {
        const double value = from * std::pow(factor, i);
        if (!(value <= to * (1 + kSlack)))
            return values;
        if (values.size() >= kMaximalPoints)
            refuseTooMany(where);
        values.push_back(Config::scalar(tidyNumber(value), where));
    }
}

bool isNumber(const Config &node)
{
    return node.isScalar() && parseNumber(node.text()).has_value();
}

/// Of a problem's settings: keys whose values are texts, also where they look like numbers.
using IsText = std::function<bool(const std::string &key)>;

bool isNumberList(const Config &node)
{
    return node.isList() && std::all_of(node.items().begin(), node.items().end(), isNumber);
}

/// A list's values; throws where it is empty or has one twice.
const std::vector<Config> &listValues(const Config &list, bool texts = false)
{
    if (list.items().empty())
        throw PlanError(list.where(), "an empty list sweeps nothing; give one value or more");
    std::set<std::string> seen;
    for (const Config &item : list.items())
    {
        if (item.kind() == Config::Kind::empty)
            throw PlanError(item.where(), "an empty value in a list; give a value or leave it out");
        if (item.isList())
            throw PlanError(item.where(), "a list inside a list; give its values in one list");
        if (!seen.insert(texts && item.isScalar() ? item.text() : item.canonical()).second)
            throw PlanError(item.where(), (item.isScalar() ? "'" + item.text() + "'" : std::string("this")) +
                                              " stands twice in the list");
    }
    return list.items();
}

/// The first list of texts or maps, depth first, if there is one; any list at the root.
std::optional<Path> findTextList(const Config &node, bool isRoot, const IsText &isText)
{
    if (node.isList() && (isRoot || !isNumberList(node)))
        return Path{};
    for (std::size_t i = 0; node.isMap() && i < node.entries().size(); ++i)
    {
        const Config::Entry &entry = node.entries()[i];
        if (entry.value.isList() && isText && isText(entry.key))
            return Path{i};
        if (auto path = findTextList(entry.value, false, {}))
        {
            path->insert(path->begin(), i);
            return path;
        }
    }
    return std::nullopt;
}

std::string keyAt(const Config &root, const Path &path)
{
    const Config *node = &root;
    std::string key;
    for (const std::size_t index : path)
    {
        key = node->entries()[index].key;
        node = &node->entries()[index].value;
    }
    return key;
}

/// Resolves every list of texts or maps.
void expandTexts(Alternative alternative, const IsText &isText, std::vector<Alternative> &result)
{
    const auto path = findTextList(alternative.tree, true, isText);
    if (!path)
    {
        if (result.size() >= kMaximalPoints)
            refuseTooMany(alternative.tree.where());
        result.push_back(std::move(alternative));
        return;
    }
    const Config list = at(alternative.tree, *path);
    const std::string key = keyAt(alternative.tree, *path);
    for (const Config &item : listValues(list, path->size() == 1 && isText(key)))
    {
        Alternative next = alternative;
        at(next.tree, *path) = item;
        if (item.isScalar() && !key.empty())
            next.choices.emplace_back(key, item.text());
        expandTexts(std::move(next), isText, result);
    }
}

void findAxes(const Config &node, const std::string &key, Path &path, std::vector<Axis> &axes)
{
    if (isNumberList(node))
        axes.push_back({key, {path}, listValues(node), false});
    else if (isRange(node) && !path.empty())
        axes.push_back({key, {path}, rangeValues(node), false});
    else
        for (std::size_t i = 0; node.isMap() && i < node.entries().size(); ++i)
        {
            path.push_back(i);
            findAxes(node.entries()[i].value, node.entries()[i].key, path, axes);
            path.pop_back();
        }
}

void findUsesOfX(const Config &node, Path &path, std::vector<Path> &uses)
{
    if (node.isScalar() && node.text() == "x")
        uses.push_back(path);
    for (std::size_t i = 0; node.isMap() && i < node.entries().size(); ++i)
    {
        path.push_back(i);
        findUsesOfX(node.entries()[i].value, path, uses);
        path.pop_back();
    }
}

/// Takes `x` out of the settings; its axis, where there is one.
std::optional<Axis> takeX(Config &tree)
{
    auto &entries = tree.entries();
    const auto entry =
        std::find_if(entries.begin(), entries.end(), [](const auto &e) { return e.key == "x"; });
    if (entry == entries.end())
        return std::nullopt;
    const Config value = entry->value;
    const SourceLocation where = entry->where;
    entries.erase(entry);

    Axis axis{"x", {}, {}, false};
    if (isNumber(value))
        axis.values = {value};
    else if (isNumberList(value))
        axis.values = listValues(value);
    else if (isRange(value))
        axis.values = rangeValues(value);
    else
        throw PlanError(value.kind() == Config::Kind::empty ? where : value.where(),
                        "'x' takes a number, a list of numbers, {from, to, step} or {from, to, factor}");
    Path path;
    findUsesOfX(tree, path, axis.targets);
    if (axis.targets.empty())
        throw PlanError(where, "nothing uses x; give it to a parameter, as in 'handles: x'");
    if (!value.isScalar())
        return axis;
    for (const Path &target : axis.targets)
        at(tree, target) = value;
    return std::nullopt;
}

/// The axes of a tree; the one of the figures first, where there is any.
std::vector<Axis> findAxes(Config &tree, const Problem &prototype)
{
    const auto x = takeX(tree);
    std::vector<Axis> axes;
    Path path;
    findAxes(tree, {}, path, axes);
    for (Axis &axis : axes)
        axis.countsRobots = axis.targets.front().size() == 1 && prototype.takesRobotCount() &&
                            RobotCount::key(axis.key).has_value();
    if (x)
        axes.insert(axes.begin(), *x);
    const auto variable =
        std::find_if(axes.begin(), axes.end(),
                     [&prototype](const Axis &axis) { return axis.countsRobots != prototype.variesGraph(); });
    if (variable != axes.end())
        std::rotate(axes.begin(), variable, variable + 1);
    return axes;
}

/// Every combination of the axes but the first: the problems of an alternative.
std::vector<Group> makeGroups(const Alternative &alternative, const Config &tree,
                              const std::vector<Axis> &axes)
{
    std::vector<Group> groups{{tree, alternative.choices, axes.empty() ? nullptr : &axes.front(), {}, {}}};
    for (std::size_t i = 1; i < axes.size(); ++i)
    {
        std::vector<Group> crossed;
        for (const Group &group : groups)
            for (const Config &value : axes[i].values)
            {
                if (crossed.size() >= kMaximalPoints)
                    refuseTooMany(value.where());
                Group next = group;
                for (const Path &target : axes[i].targets)
                    at(next.tree, target) = value;
                next.choices.emplace_back(axes[i].key, value.text());
                crossed.push_back(std::move(next));
            }
        groups = std::move(crossed);
    }
    return groups;
}

ProblemPoint makePoint(const std::string &family, const Config &settings, const ProblemContext &context)
{
    auto problem = context.catalog->problems.create(family);
    problem->configure(settings, context);
    if (problem->needsRobotCount() && !problem->robots())
        throw PlanError(settings.where(),
                        "'" + family +
                            "' needs to know how many robots there are; give one of robots, "
                            "free, occupancy");
    ProblemPoint point;
    point.model = family;
    point.name = problem->name();
    point.settings = canonicalSettings(settings, problem->parameters());
    point.problem = std::move(problem);
    return point;
}

PointPlaces placesOf(const Config &settings)
{
    PointPlaces places = {{"", settings.where()}};
    for (const Config::Entry &entry : settings.entries())
        places.emplace(entry.key, entry.value.where());
    return places;
}

void makePoints(Group &group, const std::string &family, const ProblemContext &context, bool withPlaces)
{
    if (group.axis == nullptr)
    {
        group.points.push_back(makePoint(family, group.tree, context));
        if (withPlaces)
            group.places.push_back(placesOf(group.tree));
        return;
    }
    for (const Config &value : group.axis->values)
    {
        for (const Path &target : group.axis->targets)
            at(group.tree, target) = value;
        ProblemPoint point = makePoint(family, group.tree, context);
        point.sweepVariable = group.axis->key;
        point.sweepValue = value.number();
        group.points.push_back(std::move(point));
        if (withPlaces)
            group.places.push_back(placesOf(group.tree));
    }
}

/// The words at the front that both have: "grid" of "grid 8×8" and "grid 16×16".
std::string commonWords(const std::string &a, const std::string &b)
{
    std::size_t end = 0;
    for (std::size_t i = 0;; ++i)
    {
        const bool aEnds = i >= a.size();
        const bool bEnds = i >= b.size();
        if ((aEnds || a[i] == ' ') && (bEnds || b[i] == ' '))
            end = i;
        if (aEnds || bEnds || a[i] != b[i])
            return a.substr(0, end);
    }
}

/// Gives all points of a group one name, and groups of an entry distinct ones.
void nameGroups(std::vector<Group> &groups)
{
    std::map<std::string, std::size_t> uses;
    for (Group &group : groups)
    {
        group.name = group.points.front().name;
        for (const ProblemPoint &point : group.points)
            group.name = commonWords(group.name, point.name);
        if (group.name.empty())
            group.name = group.points.front().model;
        ++uses[group.name];
    }
    for (Group &group : groups)
    {
        if (uses[group.name] > 1)
            for (const auto &[key, text] : group.choices)
                group.name.append(" ").append(key).append("=").append(text);
        for (ProblemPoint &point : group.points)
            point.name = group.name;
    }
}

} // namespace

bool isRange(const Config &node)
{
    return node.isMap() && (node.find("from") != nullptr || node.find("to") != nullptr);
}

std::vector<Config> rangeValues(const Config &range)
{
    const std::vector<std::string> keys = {"from", "to", "step", "factor"};
    for (const Config::Entry &entry : range.entries())
        if (std::find(keys.begin(), keys.end(), entry.key) == keys.end())
            throw PlanError(entry.where,
                            "unknown key '" + entry.key + "' in a range" + suggestion(entry.key, keys));
    const Config *from = range.find("from");
    const Config *to = range.find("to");
    const Config *step = range.find("step");
    const Config *factor = range.find("factor");
    if (from == nullptr || to == nullptr || (step == nullptr) == (factor == nullptr))
        throw PlanError(range.where(), "a range is {from, to, step} or {from, to, factor}");
    if (from->number() > to->number())
        throw PlanError(from->where(),
                        "the range is empty: from " + from->text() + " is above to " + to->text());

    if (factor != nullptr)
    {
        if (from->number() <= 0)
            throw PlanError(from->where(), "a range with a factor must begin above 0");
        if (factor->number() <= 1)
            throw PlanError(factor->where(), "a factor must be above 1, or the range never ends");
        return factors(from->number(), to->number(), factor->number(), range.where());
    }
    if (step->number() <= 0)
        throw PlanError(step->where(), "a step must be above 0, or the range never ends");
    const auto wholeFrom = parseInteger(from->text());
    const auto wholeTo = parseInteger(to->text());
    const auto wholeStep = parseInteger(step->text());
    if (wholeFrom && wholeTo && wholeStep)
        return integerSteps(*wholeFrom, *wholeTo, *wholeStep, range.where());
    return realSteps(from->number(), to->number(), step->number(), range.where());
}

std::vector<ProblemPoint> expandProblem(const std::string &family, const SourceLocation &where,
                                        const Config &settings, const ProblemContext &context,
                                        std::vector<PointPlaces> *places)
{
    const auto prototype = context.catalog->problems.create(family);
    Alternative whole{settings.kind() == Config::Kind::empty ? Config::map({}, where) : settings, {}};
    std::vector<Alternative> alternatives;
    expandTexts(
        std::move(whole),
        [&prototype](const std::string &key) { return takesText(prototype->parameters(), key); },
        alternatives);

    std::vector<std::vector<Axis>> axes(alternatives.size());
    std::vector<Group> groups;
    std::size_t points = 0;
    for (std::size_t i = 0; i < alternatives.size(); ++i)
    {
        axes[i] = findAxes(alternatives[i].tree, *prototype);
        for (Group &group : makeGroups(alternatives[i], alternatives[i].tree, axes[i]))
        {
            points += group.axis == nullptr ? 1 : group.axis->values.size();
            if (points > kMaximalPoints)
                refuseTooMany(where);
            groups.push_back(std::move(group));
        }
    }

    std::vector<ProblemPoint> result;
    for (Group &group : groups)
        makePoints(group, family, context, places != nullptr);
    nameGroups(groups);
    for (Group &group : groups)
    {
        std::move(group.points.begin(), group.points.end(), std::back_inserter(result));
        if (places != nullptr)
            places->insert(places->end(), group.places.begin(), group.places.end());
    }
    return result;
}

} // namespace mrpp

#include "yaml/PlannerList.h"

#include "framework/outside/CommandPlanner.h"
#include "framework/outside/OutsideCommand.h"
#include "framework/support/Suggestion.h"
#include "yaml/PlanNodes.h"
#include "yaml/Sweep.h"

#include <algorithm>

namespace mrpp
{

namespace
{

/// One value for each setting of an entry.
struct Choice
{
    std::vector<Config::Entry> settings;
    std::string label; ///< " order=random": those that are swept
};

/// What a setting may be: its value, or those of a list or range.
std::vector<Config> valuesOf(const Config::Entry &setting)
{
    if (isRange(setting.value))
        return rangeValues(setting.value);
    if (!setting.value.isList())
        return {setting.value};
    if (setting.value.items().empty())
        throw PlanError(setting.value.where(), "'" + setting.key + "' is an empty list; give its values");
    return setting.value.items();
}

/// Every combination of the settings' values, the last setting changing fastest.
std::vector<Choice> choicesOf(const Config::Entry &entry)
{
    constexpr std::size_t kMost = 1000;
    requireMap(entry.value, entry.where, "'set' takes a map of parameters and values");
    std::vector<Choice> choices = {{}};
    for (const Config::Entry &setting : entry.value.entries())
    {
        const std::vector<Config> values = valuesOf(setting);
        if (choices.size() * values.size() > kMost)
            throw PlanError(entry.where, "the sweeps of these settings make more than " +
                                             std::to_string(kMost) + " planners; sweep less");
        std::vector<Choice> longer;
        for (const Choice &choice : choices)
            for (const Config &value : values)
            {
                longer.push_back(choice);
                longer.back().settings.push_back({setting.key, setting.where, value});
                if (values.size() > 1)
                    longer.back().label += " " + setting.key + "=" + inOneLine(value.text());
            }
        choices = std::move(longer);
    }
    return choices;
}

/// Sets each parameter of a fresh object, so that nothing is wrong with them later.
void set(const Choice &choice, ParameterSet &parameters, Configured &configured)
{
    for (const Config::Entry &setting : choice.settings)
    {
        const bool known = parameters.find(setting.key) != nullptr;
        if (known && !setting.value.isScalar())
            throw PlanError(setting.value.isList() || setting.value.isMap() ? setting.value.where()
                                                                            : setting.where,
                            "parameter '" + setting.key + "' takes one value");
        try
        {
            parameters.set(setting.key, known ? setting.value.text() : "");
        }
        catch (const ParamError &error)
        {
            throw PlanError(known ? setting.value.where() : setting.where, error.complaint());
        }
        configured.settings.emplace_back(setting.key, setting.value.text());
    }
    configured.name += choice.label;
}

/// A registered planner or optimizer: a name, or {planner: name, name: …, set: {…}}.
template <class T>
std::vector<Configured> readRegistered(const Config &node, const std::string &role,
                                       const Registry<T> &registry)
{
    Configured configured;
    SourceLocation where = node.where();
    const Config::Entry *settings = nullptr;
    if (node.isMap())
    {
        checkKeys(node, "a " + role + " of the plan", {role, "name", "set"});
        for (const Config::Entry &entry : node.entries())
            if (entry.key == role)
            {
                configured.kind = textOf(entry);
                where = entry.value.where();
            }
            else if (entry.key == "name")
                configured.name = nameOf(entry);
            else
                settings = &entry;
        if (configured.kind.empty())
            throw PlanError(node.where(),
                            "this entry does not say which " + role + " it is; give '" + role + ": NAME'");
    }
    else if (node.isScalar())
        configured.kind = node.text();
    else
        throw PlanError(node.where(),
                        "a " + role + " is a name or {" + role + ": NAME, name: TITLE, set: {…}}");

    if (registry.find(configured.kind) == nullptr)
        throw PlanError(where, "there is no " + role + " '" + configured.kind + "'" +
                                   suggestion(configured.kind, registry.names()));
    if (configured.name.empty())
        configured.name = configured.kind;
    if (settings == nullptr)
        return {configured};
    std::vector<Configured> all;
    for (const Choice &choice : choicesOf(*settings))
        set(choice, registry.create(configured.kind)->parameters(), all.emplace_back(configured));
    return all;
}

/// What a command's format is for.
enum class Use
{
    answer,
    graph,
    instance,
};

bool serves(const FileFormat &format, Use use)
{
    switch (use)
    {
    case Use::answer:
        return format.reads && (format.holds == "solution" || format.holds == "animation");
    case Use::graph:
        return format.writes && format.holds == "graph";
    case Use::instance:
        return format.writes && format.holds.find("instance") != std::string::npos;
    }
    return false;
}

/// A format by its name; answers also by the part before '_' ("kei18").
std::string formatNamed(const Config::Entry &entry, const Catalog &catalog, Use use)
{
    const std::string &text = textOf(entry);
    std::vector<std::string> names;
    for (const FileFormat &format : catalog.formats)
    {
        if (!serves(format, use))
            continue;
        if (format.name == text || (use == Use::answer && format.name.starts_with(text + "_")))
            return format.name;
        names.push_back(format.name);
    }
    throw PlanError(entry.value.where(),
                    "there is no format '" + text + "' for this" + suggestion(text, names));
}

/// {1: gave_up, 2: infeasible}
std::map<int, PlannerStatus> readExitCodes(const Config::Entry &entry)
{
    using enum PlannerStatus;
    const std::vector<PlannerStatus> sensible = {solved,      gave_up,      infeasible,
                                                 unsupported, memory_limit, timeout};
    requireMap(entry.value, entry.where, "'exit_codes' takes a map: {1: gave_up, 2: infeasible}");
    std::map<int, PlannerStatus> codes;
    for (const Config::Entry &code : entry.value.entries())
    {
        constexpr std::int64_t kLargest = 255;
        const auto number = parseInteger(code.key);
        if (!number || *number < 1 || *number > kLargest)
            throw PlanError(code.where,
                            "an exit code is a number from 1 to 255 (0 is an answer), but this is '" +
                                code.key + "'");
        const auto status = plannerStatus(textOf(code));
        std::vector<std::string> words;
        for (const PlannerStatus one : sensible)
            words.emplace_back(toString(one));
        if (!status || std::find(sensible.begin(), sensible.end(), *status) == sensible.end())
            throw PlanError(code.value.where(), "an exit code cannot mean '" + code.value.text() + "'" +
                                                    suggestion(code.value.text(), words));
        if (!codes.emplace(static_cast<int>(*number), *status).second)
            throw PlanError(code.where, "the exit code " + std::to_string(*number) +
                                            " stands here a second time; keep one of the two");
    }
    return codes;
}

/// A file, or a list of files.
std::vector<std::string> readFiles(const Config::Entry &entry)
{
    if (!entry.value.isList())
        return {textOf(entry)};
    std::vector<std::string> files;
    for (const Config &item : itemsOf(entry, "files that the command depends on"))
    {
        if (!item.isScalar() || item.text().empty())
            throw PlanError(item.where(), "'files' takes paths of files");
        if (std::find(files.begin(), files.end(), item.text()) != files.end())
            throw PlanError(item.where(), "'" + item.text() + "' stands twice in the list");
        files.push_back(item.text());
    }
    return files;
}

/// What looks like a place and is none would reach the program as it stands.
void refuseDoubtfulPlaces(const OutsideCommand &command, const std::vector<std::string> &known)
{
    for (const std::string &braced : doubtfulPlacesIn(command.words))
        throw PlanError(command.where, std::string("there is no place {")
                                           .append(braced)
                                           .append("}")
                                           .append(suggestion(asPlaceName(braced), known))
                                           .append("; the text itself is written {{")
                                           .append(braced)
                                           .append("}}"));
}

/// Every place is known and filled, every setting has a place, and the program is told its instance.
void checkPlaces(const OutsideCommand &command, const Config::Entry *settings)
{
    const std::vector<std::string> places = placesIn(command.words);
    const auto isIn = [](const std::vector<std::string> &list, const std::string &name)
    { return std::find(list.begin(), list.end(), name) != list.end(); };
    std::vector<std::string> known = ownPlaces();
    if (settings != nullptr)
        for (const Config::Entry &setting : settings->value.entries())
        {
            if (isIn(ownPlaces(), setting.key) || isIn(commandProperties(), setting.key))
                throw PlanError(setting.where,
                                "'" + setting.key + "' is no parameter of a command; choose another name");
            if (!isIn(places, setting.key))
                throw PlanError(setting.where, "the command has no place {" + setting.key + "}" +
                                                   suggestion(setting.key, places));
            known.push_back(setting.key);
        }
    refuseDoubtfulPlaces(command, known);
    for (const std::string &place : places)
        if (!isIn(known, place))
            throw PlanError(command.where,
                            std::string("nothing fills the place {")
                                .append(place)
                                .append("}")
                                .append(suggestion(place, known))
                                .append(" (values of your own stand under 'set'; the text itself "
                                        "is written {{")
                                .append(place)
                                .append("}})"));
    if (!isIn(places, "instance") && !isIn(places, "scen"))
        throw PlanError(command.where,
                        "the command is not told its instance: it has neither {instance} nor {scen}");
}

/// {command: "solver {graph} {instance} -o {output}", format: …, name: …, set: {…}}
std::vector<Configured> readCommand(const Config &node, const Catalog &catalog,
                                    const std::filesystem::path &folder)
{
    std::vector<std::string> keys = commandProperties();
    keys.insert(keys.end(), {"name", "set"});
    checkKeys(node, "a command of the plan", keys);
    OutsideCommand command;
    command.folder = std::filesystem::absolute(folder.empty() ? "." : folder).lexically_normal();
    Configured configured{.kind = "command", .name = {}, .settings = {}};
    const Config::Entry *settings = nullptr;
    for (const Config::Entry &entry : node.entries())
    {
        std::string value;
        if (entry.key == "set")
        {
            settings = &entry;
            requireMap(entry.value, entry.where, "'set' takes a map of the command's places and values");
            continue;
        }
        if (entry.key == "exit_codes")
        {
            command.exitCodes = readExitCodes(entry);
            value = entry.value.canonical();
        }
        else if (entry.key == "command")
        {
            command.where = entry.value.where();
            value = textOf(entry);
            try
            {
                command.words = splitCommand(value);
            }
            catch (const InputError &error)
            {
                throw PlanError(command.where, "this is no command: " + error.complaint());
            }
        }
        else if (entry.key == "format")
            value = command.answerFormat = formatNamed(entry, catalog, Use::answer);
        else if (entry.key == "graph_format")
            value = command.graphFormat = formatNamed(entry, catalog, Use::graph);
        else if (entry.key == "instance_format")
            value = command.instanceFormat = formatNamed(entry, catalog, Use::instance);
        else if (entry.key == "files")
        {
            command.files = readFiles(entry);
            for (const std::string &file : command.files)
                value += (value.empty() ? "" : "\n") + file;
        }
        else if (entry.key == "margin")
        {
            command.margin = durationOf(entry, Zero::allowed);
            value = formatNumber(*command.margin);
        }
        else if (entry.key == "motion")
        {
            const std::vector<std::string> rules = {"pebble", "parallel", "following", "rotation"};
            value = textOf(entry);
            if (!motionRule(value))
                throw PlanError(entry.value.where(),
                                "there is no motion rule '" + value + "'" + suggestion(value, rules));
            command.motion = *motionRule(value);
        }
        else
        {
            configured.name = nameOf(entry);
            continue;
        }
        configured.settings.emplace_back(entry.key, value);
    }
    checkPlaces(command, settings);
    if (configured.name.empty())
        configured.name = std::filesystem::path(command.words.front()).filename().string();
    configured.command = std::make_shared<const OutsideCommand>(std::move(command));
    if (settings == nullptr)
        return {configured};
    std::vector<Configured> all;
    for (const Choice &choice : choicesOf(*settings))
    {
        CommandPlanner planner(*configured.command, catalog.files);
        set(choice, planner.parameters(), all.emplace_back(configured));
    }
    return all;
}

} // namespace

std::vector<Configured> readPlanners(const Config::Entry &entry, const Catalog &catalog,
                                     const std::filesystem::path &folder)
{
    std::vector<Configured> planners;
    for (const Config &node : itemsOf(entry, "planners' names"))
    {
        const bool isCommand = node.isMap() && node.find("command") != nullptr;
        for (Configured &planner : isCommand ? readCommand(node, catalog, folder)
                                             : readRegistered(node, "planner", catalog.planners))
        {
            for (const Configured &other : planners)
                if (other.name == planner.name)
                    throw PlanError(
                        node.where(),
                        "two planners are named '" + planner.name + "'; give one of them another name: {" +
                            (isCommand ? "command: …" : "planner: " + planner.kind) + ", name: TITLE}");
            planners.push_back(std::move(planner));
        }
    }
    return planners;
}

std::vector<Configured> readOptimizers(const Config::Entry &entry, const Catalog &catalog)
{
    std::vector<Configured> optimizers;
    for (const Config &node : itemsOf(entry, "optimizers' names, or leave the key out"))
    {
        std::vector<Configured> one = readRegistered(node, "optimizer", catalog.optimizers);
        if (one.size() > 1)
            throw PlanError(node.where(), "an optimizer has one value for each parameter: sweeps are for "
                                          "planners and problems");
        optimizers.push_back(std::move(one.front()));
    }
    return optimizers;
}

} // namespace mrpp

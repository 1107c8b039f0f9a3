#include "cli/Arguments.h"

#include "cli/CampaignArguments.h"
#include "cli/Options.h"
#include "framework/support/Config.h"
#include "framework/support/ReadableText.h"
#include "framework/support/Suggestion.h"
#include "problems/formats/MovingAiMap.h"
#include "problems/generators/Generator.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <memory>

namespace mrpp
{

namespace
{

const std::vector<std::string> kListable = {"planners", "optimizers", "problems",
                                            "reports",  "metrics",    "formats"};
const std::vector<std::string> kMotionRules = {"pebble", "parallel", "following", "rotation"};

void addRun(CLI::App &app, Arguments &result)
{
    CLI::App *command = app.add_subcommand("run", "Run a plan, or what is left of it, and write its reports");
    command->footer(
        R"(Every finished run is kept at once in DIR/results.sqlite. The same command again goes on
where the last one stopped; runs that the plan does not change are kept.

Examples:
  mrppsim run yaml/plans/quickstart.yaml
  mrppsim run plan.yaml -o results/monday --jobs 2
  mrppsim run plan.yaml --dry-run
  mrppsim run plan.yaml --why
  mrppsim run plan.yaml -o results/part3 --shard 3/10)");
    const auto arguments = std::make_shared<RunArguments>();
    const auto shard = std::make_shared<std::string>();
    command->add_option("PLAN", arguments->plan, "The plan, a YAML file")->required();
    optional(*command, "-o,--output", arguments->folder, "The campaign's folder [results/CAMPAIGN]")
        ->type_name("DIR");
    command
        ->add_option("--maps", arguments->maps, "Where the plan's maps and scenarios are looked for besides")
        ->type_name("DIR")
        ->allow_extra_args(false);
    optional(*command, "--jobs", arguments->jobs, "Runs at once [the plan's]")
        ->type_name("N")
        ->check(wholeNumberFrom(1));
    command->add_option("--shard", *shard, "Only the i-th of n parts")->type_name("i/n");
    command->add_flag("--dry-run", arguments->dryRun, "Say what would be run, and run nothing");
    command->add_flag("--why", arguments->why, "Say which runs would be made and why each, and run nothing");
    command->add_flag("--no-report", arguments->noReport, "Leave the reports to `mrppsim report`");
    command->add_flag("-q,--quiet", arguments->quiet, "No progress");
    command->callback(
        [arguments, shard, &result]
        {
            if (!shard->empty())
            {
                const std::size_t slash = shard->find('/');
                const auto part = parseInteger(shard->substr(0, slash));
                const auto parts =
                    slash == std::string::npos ? std::nullopt : parseInteger(shard->substr(slash + 1));
                if (!part || !parts || *part < 1 || *part > *parts)
                    throw CLI::ValidationError("--shard", "'" + *shard + "' is no part i/n with 1 <= i <= n");
                arguments->shard = *part;
                arguments->shards = *parts;
            }
            result = *arguments;
        });
}

void addReport(CLI::App &app, Arguments &result)
{
    CLI::App *command = app.add_subcommand("report", "Write a campaign's reports again");
    command->footer(R"(Works while the campaign is running, and without the maps that it ran on.

Examples:
  mrppsim report results/quickstart
  mrppsim report results/quickstart --only csv pdf)");
    const auto arguments = std::make_shared<ReportArguments>();
    command->add_option("DIR", arguments->folder, "The campaign's folder")->required();
    command->add_option("--only", arguments->only, "These reports instead of the plan's")
        ->type_name("KIND")
        ->expected(1, 100);
    command->callback([arguments, &result] { result = *arguments; });
}

/// How a MovingAI map is read.
void addPassability(CLI::App &command, std::string &passability)
{
    std::vector<std::string> names;
    for (const Passability &rule : passabilities())
        names.emplace_back(rule.name);
    command
        .add_option("--passability", passability,
                    "Which symbols of a .map robots may stand on, see docs/formats.md [movingai]")
        ->check(oneOf(names));
}

void addSolve(CLI::App &app, Arguments &result)
{
    CLI::App *command = app.add_subcommand("solve", "Solve one instance with one planner");
    command->footer(
        R"(Ends with 0 where the instance was solved, 1 where it was not, 3 where the planner's answer is wrong.

Examples:
  mrppsim solve --instance theta.instance --planner push_and_swap
  mrppsim solve --graph room.map --instance room.scen --robots 20 --planner push_and_swap --solution moves.csv
  mrppsim solve --graph g.graphml --instance g.instance --planner push_and_swap --set order=given --json out.json)");
    const auto arguments = std::make_shared<SolveArguments>();
    const auto settings = std::make_shared<std::vector<std::string>>();
    optional(*command, "--graph", arguments->graph,
             "The graph, in any format [the one that the instance names or holds]");
    command->add_option("--instance", arguments->instance, "The instance, in any format")
        ->required()
        ->type_name("FILE");
    optional(*command, "--robots", arguments->robots, "Only the first N robots of the instance")
        ->type_name("N")
        ->check(wholeNumberFrom(0));
    addPassability(*command, arguments->passability);
    command->add_option("--planner", arguments->planner, "See `mrppsim list planners`")
        ->required()
        ->type_name("NAME");
    command->add_option("--set", *settings, "A parameter of the planner; may stand several times")
        ->type_name("name=value")
        ->allow_extra_args(false);
    arguments->optimizers = {"redundancy_removal"};
    command
        ->add_option("--optimizer", arguments->optimizers,
                     "An optimizer, or none; may stand several times [redundancy_removal]")
        ->type_name("NAME")
        ->allow_extra_args(false);
    arguments->motion = "rotation";
    command
        ->add_option("--motion", arguments->motion, "The widest motion rule that planners may use [rotation]")
        ->check(oneOf(kMotionRules));
    command->add_option("--time-limit", arguments->timeLimit, "Seconds [60]")
        ->type_name("S")
        ->check(numberAbove0());
    command->add_option("--memory-limit", arguments->memoryLimit, "MB [4096]")
        ->type_name("MB")
        ->check(numberAbove0());
    command->add_option("--seed", arguments->seed, "Of the planner's random choices [1]")
        ->type_name("N")
        ->check(wholeNumberFrom(0));
    optional(*command, "--solution", arguments->solution, "Write the solution, one action a step (CSV)");
    optional(*command, "--optimized-solution", arguments->optimizedSolution,
             "Write the optimized solution (CSV)");
    optional(*command, "--schedule", arguments->schedule, "Write the condensed schedule (CSV)");
    optional(*command, "--animation", arguments->animation, "Write the schedule for GraphRec (text)");
    optional(*command, "--json", arguments->json, "Write status and measures (JSON)");
    command->callback(
        [arguments, settings, &result]
        {
            for (const std::string &setting : *settings)
            {
                const std::size_t sign = setting.find('=');
                if (sign == std::string::npos || sign == 0)
                    throw CLI::ValidationError("--set", "'" + setting + "' is not of the form name=value");
                arguments->settings.emplace_back(setting.substr(0, sign), setting.substr(sign + 1));
            }
            result = *arguments;
        });
}

/// Which instance a command is about.
template <class CommandArguments>
void addInstance(CLI::App &command, CommandArguments &arguments)
{
    optional(command, "--graph", arguments.graph,
             "The graph, in any format [the one that the instance names or holds]");
    command.add_option("--instance", arguments.instance, "The instance, in any format")
        ->required()
        ->type_name("FILE");
    optional(command, "--robots", arguments.robots, "Only the first N robots of the instance")
        ->type_name("N")
        ->check(wholeNumberFrom(0));
    addPassability(command, arguments.passability);
}

void addCheck(CLI::App &app, Arguments &result)
{
    CLI::App *command =
        app.add_subcommand("check", "Say whether an instance can be solved at all, and why not");
    command->footer(
        R"(Prints "solvable" and ends with 0, or "unsolvable: REASON" and ends with 1. Exact, and no planning: it
takes less time than reading the files.

Examples:
  mrppsim check --instance theta.instance
  mrppsim check --graph room.map --instance room.scen --robots 200 --motion rotation --json)");
    const auto arguments = std::make_shared<CheckArguments>();
    addInstance(*command, *arguments);
    arguments->motion = "pebble";
    command->add_option("--motion", arguments->motion, "What robots may do in one step [pebble]")
        ->check(oneOf(kMotionRules));
    command->add_flag("--json", arguments->json, "The answer as a JSON object");
    command->callback([arguments, &result] { result = *arguments; });
}

void addValidate(CLI::App &app, Arguments &result)
{
    CLI::App *command = app.add_subcommand("validate", "Replay a solution or schedule from any source");
    command->footer(
        R"(Ends with 0 where the solution is valid, and with 1 where it is not, naming the first bad move.

Examples:
  mrppsim validate --instance theta.instance --solution moves.csv
  mrppsim validate --graph room.map --instance room.scen --solution moves.csv --motion following)");
    const auto arguments = std::make_shared<ValidateArguments>();
    addInstance(*command, *arguments);
    command->add_option("--solution", arguments->solution, "The moves, in any format")
        ->required()
        ->type_name("FILE");
    arguments->motion = "rotation";
    command->add_option("--motion", arguments->motion, "The rule that the moves must obey [rotation]")
        ->check(oneOf(kMotionRules));
    command->callback([arguments, &result] { result = *arguments; });
}

void addView(CLI::App &app, Arguments &result)
{
    CLI::App *command = app.add_subcommand("view", "Make a page in which solutions or schedules play");
    command->footer(
        R"(One HTML file that needs no server and no network. Several solutions of one instance play side by side; moves that
break the rules are shown as conflicts. Without --instance the robots start and end as the first solution says.

Examples:
  mrppsim view --instance theta.instance --solution moves.csv -o theta.html
  mrppsim view --graph room.map --instance room.scen --solution ours.csv --solution theirs.txt -o both.html)");
    const auto arguments = std::make_shared<ViewArguments>();
    optional(*command, "--graph", arguments->graph,
             "The graph, in any format [the one that the instance names or holds]");
    optional(*command, "--instance", arguments->instance, "The instance, in any format");
    optional(*command, "--robots", arguments->robots, "Only the first N robots of the instance")
        ->type_name("N")
        ->check(wholeNumberFrom(0));
    addPassability(*command, arguments->passability);
    command
        ->add_option("--solution", arguments->solutions, "The moves, in any format; may stand several times")
        ->required()
        ->type_name("FILE")
        ->allow_extra_args(false);
    arguments->motion = "rotation";
    command->add_option("--motion", arguments->motion, "The rule that the moves should obey [rotation]")
        ->check(oneOf(kMotionRules));
    command->add_option("-o,--output", arguments->output, "The page to write")->required()->type_name("FILE");
    command->callback([arguments, &result] { result = *arguments; });
}

void addConvert(CLI::App &app, Arguments &result)
{
    CLI::App *command =
        app.add_subcommand("convert", "Change a graph's, instance's or solution's file format");
    command->footer(
        R"(What the new format cannot say is named on the standard error. See `mrppsim list formats`.

Examples:
  mrppsim convert board.cpf board.graphml
  mrppsim convert room.scen room.yaml --graph room.map
  mrppsim convert moves.csv moves.txt --instance room.scen --to graphrec)");
    const auto arguments = std::make_shared<ConvertArguments>();
    command->add_option("IN", arguments->in, "A file of any format that is read")->required();
    command->add_option("OUT", arguments->out, "The file to write")->required();
    optional(*command, "--graph", arguments->graph,
             "The graph of the instance [the one that it names or holds]");
    optional(*command, "--instance", arguments->instance, "The instance that a solution belongs to");
    addPassability(*command, arguments->passability);
    optional(*command, "--to", arguments->format, "The format of OUT [by its extension]")
        ->type_name("FORMAT");
    command->callback([arguments, &result] { result = *arguments; });
}

/// initial_cycle → --initial-cycle
std::string flagOf(std::string parameter)
{
    std::replace(parameter.begin(), parameter.end(), '_', '-');
    return "--" + parameter;
}

/// One generator's options: its parameters, and what all have.
void addFamily(CLI::App &generate, const std::string &family, const std::string &description,
               const Generator &generator, Arguments &result)
{
    CLI::App *command = generate.add_subcommand(family, description);
    command->allow_extras();
    const auto arguments = std::make_shared<GenerateArguments>();
    arguments->family = family;
    for (const ParameterSet::Parameter &parameter : generator.parameters().all())
        command
            ->add_option_function<std::string>(
                flagOf(parameter.name),
                [arguments, name = parameter.name](const std::string &value)
                { arguments->settings.emplace_back(name, value); },
                parameter.help + " [" + parameter.defaultValue + "]")
            ->type_name(parameter.range.empty() ? std::string(parameter.type()) : parameter.range)
            ->allow_extra_args(false);
    command->add_option("--seed", arguments->seed, "Of everything random [1]")
        ->type_name("N")
        ->check(wholeNumberFrom(0));
    optional(
        *command, "--graph", arguments->graph,
        "Where the graph is written: a MovingAI map if FILE ends with .map, else GraphML [standard output]");
    CLI::Option *robots =
        optional(*command, "--robots", arguments->robots, "How many robots the instance has")
            ->type_name("N")
            ->check(wholeNumberFrom(0));
    CLI::Option *instance =
        optional(*command, "--instance", arguments->instance,
                 "Where an instance is written: a MovingAI scenario if FILE ends with .scen, else text");
    command->add_flag("--solvable", arguments->solvable, "An instance that has a solution")->needs(instance);
    command->add_flag("--well-formed", arguments->wellFormed, "A well-formed instance")->needs(instance);
    instance->needs(robots)->needs(command->get_option("--graph"));
    robots->needs(instance);
    command->callback([arguments, &result] { result = *arguments; });
}

void addGenerate(CLI::App &app, Arguments &result, const Catalog &catalog)
{
    CLI::App *command =
        app.add_subcommand("generate", "Make a graph, and an instance on it, from parameters");
    command->footer(R"(Each FAMILY has options of its own: mrppsim generate grid --help

Examples:
  mrppsim generate biconnected --initial-cycle 5 --handles 4 --max-handle-length 3 --seed 7 --graph g.graphml
  mrppsim generate grid --side 10 --graph grid.map --robots 20 --instance grid.scen
  mrppsim generate tree --vertices 30 > tree.graphml)");
    command->require_subcommand(1);
    for (const auto &family : catalog.problems.entries())
        if (const auto generator = makeGenerator(catalog, family.name))
            addFamily(*command, family.name, family.description, *generator, result);
}

void addList(CLI::App &app, Arguments &result)
{
    CLI::App *command = app.add_subcommand("list", "Say what there is: planners, problems, reports, …");
    command->footer(R"(With parameters, their ranges and defaults, and citations.

Examples:
  mrppsim list planners
  mrppsim list problems --json)");
    const auto arguments = std::make_shared<ListArguments>();
    command->add_option("WHAT", arguments->what)->required()->check(oneOf(kListable));
    command->add_flag("--json", arguments->json, "As JSON");
    command->callback([arguments, &result] { result = *arguments; });
}

/// Not in the help: campaigns start it, not people.
void addWorker(CLI::App &app, Arguments &result)
{
    CLI::App *command =
        app.add_subcommand("worker", "Serve the runs of a campaign, which starts this itself");
    command->group("");
    command->callback([&result] { result = WorkerArguments(); });
}

std::vector<std::string> commandNames(const CLI::App &app)
{
    std::vector<std::string> names;
    for (const CLI::App *command : app.get_subcommands({}))
        names.push_back(command->get_name());
    return names;
}

std::vector<std::string> optionNames(const CLI::App &command)
{
    std::vector<std::string> names;
    for (const CLI::Option *option : command.get_options())
        for (const std::string &name : option->get_lnames())
            names.push_back("--" + name);
    return names;
}

Answered refuse(const std::string &complaint, const std::string &command)
{
    std::cerr << "mrppsim: " << oneLine(complaint) << " (see mrppsim " << command
              << (command.empty() ? "" : " ") << "--help)\n";
    return {ExitCode::wrongUse};
}

std::string noSuchSubcommand(const CLI::App &command, const std::string &word)
{
    return "there is no '" + word + "' to " + command.get_name() + suggestion(word, commandNames(command));
}

/// The first word that nobody asked for, in words; empty where there is none.
std::string unexpected(const CLI::App &command)
{
    for (const CLI::App *used : command.get_subcommands())
        if (std::string complaint = unexpected(*used); !complaint.empty())
            return complaint;
    const auto extras = command.remaining();
    if (extras.empty())
        return {};
    const std::string &word = extras.front();
    if (!word.starts_with('-') && command.get_subcommands().empty() && !commandNames(command).empty())
        return noSuchSubcommand(command, word);
    if (!word.starts_with('-'))
        return "'" + word + "' is one argument too many";
    return "there is no option '" + word + "'" +
           suggestion(word.substr(0, word.find('=')), optionNames(command));
}

} // namespace

Arguments parseArguments(int count, const char *const *words, const Catalog &catalog)
{
    Arguments result = Answered{};
    CLI::App app("MRPPSim evaluates multi-robot path planners on graphs: a plan in; checked results, figures "
                 "and reports out.",
                 "mrppsim");
    app.footer(R"(Examples:
  mrppsim run yaml/plans/quickstart.yaml      runs a plan and writes its report
  mrppsim solve --instance theta.instance --planner push_and_swap
  mrppsim list planners

Every command takes --plugin FILE.so, several times if need be: a library with planners, problems, optimizers,
metrics or reports of your own. A plan names its own: plugins: [libmine.so].

Exit codes: 0 yes or done; 1 a truthful no; 2 wrong use or malformed input; 3 a defect of the program;
130 interrupted.)");
    app.set_version_flag("--version", std::string("mrppsim ") + MRPP_VERSION);
    app.require_subcommand(1);
    addRun(app, result);
    addReport(app, result);
    addMerge(app, result);
    addCompare(app, result);
    addReplay(app, result);
    addSlurm(app, result);
    addSolve(app, result);
    addCheck(app, result);
    addValidate(app, result);
    addView(app, result);
    addConvert(app, result);
    addGenerate(app, result, catalog);
    addList(app, result);
    addWorker(app, result);
    for (CLI::App *command : app.get_subcommands({}))
        command->allow_extras();

    const std::vector<std::string> commands = commandNames(app);
    const std::string first = count > 1 ? words[1] : "";
    if (first.empty())
    {
        std::cerr << app.help();
        return Answered{ExitCode::wrongUse};
    }
    const bool isCommand = std::find(commands.begin(), commands.end(), first) != commands.end();
    if (!isCommand && !first.starts_with('-'))
        return refuse("there is no command '" + first + "'" + suggestion(first, commands), "");
    if (!isCommand && first != "-h" && first != "--help" && first != "--version")
        return refuse("there is no option '" + first + "'" + suggestion(first, optionNames(app)), "");

    const std::string command = isCommand ? first : "";
    const std::string second = isCommand && count > 2 ? words[2] : "";
    if (const auto below = isCommand ? commandNames(*app.get_subcommand(first)) : std::vector<std::string>();
        !below.empty() && !second.empty() && !second.starts_with('-') &&
        std::find(below.begin(), below.end(), second) == below.end())
        return refuse(noSuchSubcommand(*app.get_subcommand(first), second), command); // before any --help
    try
    {
        app.parse(count, words);
    }
    catch (const CLI::Success &answer)
    {
        app.exit(answer, std::cout, std::cerr);
        return Answered{ExitCode::done};
    }
    catch (const CLI::ParseError &error)
    {
        const std::string extra = isCommand ? unexpected(*app.get_subcommand(command)) : "";
        return refuse(extra.empty() ? error.what() : extra, command);
    }
    if (const std::string extra = unexpected(*app.get_subcommand(command)); !extra.empty())
        return refuse(extra, command);
    return result;
}

} // namespace mrpp

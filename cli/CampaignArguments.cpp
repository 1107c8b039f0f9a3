#include "cli/CampaignArguments.h"

#include "cli/Options.h"

#include <memory>

namespace mrpp
{

void addMerge(CLI::App &app, Arguments &result)
{
    CLI::App *command = app.add_subcommand("merge", "Join the parts of a campaign in one folder");
    command->footer(
        R"(A run that several folders hold counts once; merging a folder again changes nothing. OUT may
hold the campaign already, or be new: then it appears as a whole.

Examples:
  mrppsim merge results/all results/part1 results/part2 results/part3
  mrppsim report results/all)");
    const auto arguments = std::make_shared<MergeArguments>();
    command->add_option("OUT", arguments->out, "The folder of the whole campaign")->required();
    command->add_option("DIR", arguments->folders, "The folders of its parts")->required();
    command->callback([arguments, &result] { result = *arguments; });
}

void addReplay(CLI::App &app, Arguments &result)
{
    CLI::App *command = app.add_subcommand("replay", "Run one run of a campaign again, exactly");
    command->footer(
        R"(The same graph, instance, seeds, parameters and limits. Shows both results beside each other and
ends with 0 where the answer is the same, with 1 where it is not. Nothing in DIR changes.

Examples:
  mrppsim replay results/quickstart 3f9a
  mrppsim replay results/quickstart 3f9a --graph g.graphml --instance g.instance --solution moves.csv
  gdb --args mrppsim replay results/quickstart 3f9a --in-process)");
    const auto arguments = std::make_shared<ReplayArguments>();
    command->add_option("DIR", arguments->folder, "The campaign's folder")->required();
    command->add_option("KEY", arguments->key, "The run's run_key, or its first characters")->required();
    command->add_flag("--in-process", arguments->inProcess, "In this process and no worker, for debuggers");
    optional(*command, "--graph", arguments->graph,
             "Write the graph: a map if FILE ends with .map, else GraphML");
    optional(*command, "--instance", arguments->instance, "Write the instance; needs --graph")
        ->needs(command->get_option("--graph"));
    optional(*command, "--solution", arguments->solution, "Write the new solution (CSV)");
    optional(*command, "--json", arguments->json, "Write the new record (JSON)");
    command->callback([arguments, &result] { result = *arguments; });
}

} // namespace mrpp

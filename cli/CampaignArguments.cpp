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

void addCompare(CLI::App &app, Arguments &result)
{
    CLI::App *command = app.add_subcommand("compare", "Tell two campaigns of one plan apart, with tests");
    command->footer(
        R"(Pairs the runs of the same planner on the same instance: two versions of the program, two machines,
two settings under one name. Says first which settings and limits differ. Copies of an instance are one
pair. Costs are tested by Wilcoxon's signed-rank test, what was solved or proved by McNemar's, all with
Holm's correction. Ends with 1 where something became worse beyond chance, or where a wrong answer or a
crash is new. Timeouts that the other campaign only just avoided are counted, and tested like all others.

Examples:
  mrppsim compare results/before results/now
  mrppsim compare results/before results/now -o results/comparison)");
    const auto arguments = std::make_shared<CompareArguments>();
    command->add_option("BEFORE", arguments->first, "A campaign's folder")->required();
    command->add_option("NOW", arguments->second, "The folder of the other")->required();
    optional(*command, "-o,--output", arguments->out,
             "Write comparison.pdf and comparison.csv into this folder");
    command
        ->add_option("--time-tolerance", arguments->timeTolerance,
                     "By which median times may differ before it counts [0.1]")
        ->check(numberAbove0());
    command
        ->add_option("--flapping-from", arguments->flappingFrom,
                     "Solved runs that took this share of the time limit may as well have timed out [0.5]")
        ->check(numberAbove0());
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

void addSlurm(CLI::App &app, Arguments &result)
{
    CLI::App *command = app.add_subcommand("slurm", "Write the jobs by which a Slurm cluster runs a plan");
    command->footer(
        R"(Writes DIR/array.sh (the parts), DIR/merge.sh (merges them in DIR/results and writes the reports) and
DIR/submit.sh. Plan, maps, program and DIR must be in folders that all nodes see.

Examples:
  mrppsim slurm plan.yaml -o big --shards 100
  mrppsim slurm plan.yaml -o big --shards 100 --partition long --account me --line=--qos=high --submit)");
    const auto arguments = std::make_shared<SlurmArguments>();
    command->add_option("PLAN", arguments->plan, "The plan, a YAML file")->required();
    command->add_option("-o,--output", arguments->folder, "Where everything goes")
        ->required()
        ->type_name("DIR");
    command->add_option("--shards", arguments->shards, "How many parts the campaign has")
        ->required()
        ->type_name("N")
        ->check(wholeNumberFrom(1));
    command
        ->add_option("--maps", arguments->maps, "Where the plan's maps and scenarios are looked for besides")
        ->type_name("DIR")
        ->allow_extra_args(false);
    optional(*command, "--jobs", arguments->jobs, "Runs at once in a part, a core each [the plan's]")
        ->type_name("N")
        ->check(wholeNumberFrom(1));
    optional(*command, "--at-once", arguments->atOnce, "Parts at once [as many as Slurm gives]")
        ->type_name("N")
        ->check(wholeNumberFrom(1));
    optional(*command, "--time", arguments->time, "Of a part, as Slurm writes it [from the plan's limits]")
        ->type_name("TIME");
    optional(*command, "--partition", arguments->partition, "Slurm's partition")->type_name("NAME");
    optional(*command, "--account", arguments->account, "Slurm's account")->type_name("NAME");
    command->add_option("--line", arguments->lines, "A further option of sbatch; may stand several times")
        ->type_name("OPTION")
        ->allow_extra_args(false);
    command->add_flag("--submit", arguments->submit, "Submit the jobs, too");
    command->callback([arguments, &result] { result = *arguments; });
}

} // namespace mrpp

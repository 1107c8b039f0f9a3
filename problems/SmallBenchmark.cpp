#include "problems/SmallBenchmark.h"

#include "framework/support/Error.h"
#include "framework/support/Suggestion.h"
#include "problems/data/SmallProblems.h"
#include "problems/formats/GraphMl.h"
#include "problems/formats/InstanceText.h"

namespace mrpp
{

namespace
{
std::string commaSeparated(const std::vector<std::string> &words)
{
    std::string text;
    for (const std::string &word : words)
        text += (text.empty() ? "" : ",") + word;
    return text;
}
} // namespace

SmallBenchmark::SmallBenchmark()
{
    declareParam("problem", problem_, commaSeparated(smallProblemNames()), "which of the small problems");
}

void SmallBenchmark::configure(const Config &settings, const ProblemContext &context)
{
    Problem::configure(settings, context);
    if (problem_.empty())
        throw PlanError(settings.where(),
                        "small_benchmark needs a 'problem'; known: " + parameters().find("problem")->range);
}

std::shared_ptr<const Graph> SmallBenchmark::makeGraph(Seed) const
{
    return smallProblem(problem_).graph;
}

std::size_t SmallBenchmark::robotCount(const Graph &) const
{
    return smallProblem(problem_).robotCount();
}

Instance SmallBenchmark::makeInstance(std::shared_ptr<const Graph> graph, std::size_t robots, Seed) const
{
    Instance instance = smallProblem(problem_);
    if (robots > instance.robotCount())
        throw InputError("the problem '" + problem_ + "' has " + std::to_string(instance.robotCount()) +
                         " robots, fewer than the " + std::to_string(robots) + " asked for");
    instance.graph = std::move(graph);
    instance.starts.resize(robots);
    instance.goals.resize(robots);
    return instance;
}

std::vector<std::string> smallProblemNames()
{
    std::vector<std::string> names;
    for (const SmallProblemData &problem : smallProblems())
        names.emplace_back(problem.name);
    return names;
}

Instance smallProblem(std::string_view name)
{
    for (const SmallProblemData &problem : smallProblems())
        if (problem.name == name)
        {
            const std::string file(name);
            return textInstance(parseInstanceText(problem.instance, file + ".instance"),
                                parseGraphMl(problem.graph, file + ".graphml").graph);
        }
    throw InputError("there is no small problem '" + std::string(name) + "'" +
                     suggestion(name, smallProblemNames()));
}

} // namespace mrpp

#include "framework/run/InProcessExecutor.h"

#include "framework/outside/CommandPlanner.h"
#include "framework/plan/PlannerFactory.h"
#include "framework/run/RunIdentity.h"
#include "framework/run/RunNotes.h"
#include "framework/support/Error.h"

namespace mrpp
{

namespace
{

constexpr std::size_t kGraphBudget = std::size_t{128} << 20; // bytes of graphs that are kept for later cases

/// Bytes, about.
std::size_t graphSize(const std::shared_ptr<const Graph> &graph)
{
    constexpr std::size_t kOfAVertex = 28; // its place in the lists, and its coordinates
    constexpr std::size_t kOfAnEdge = 16;
    constexpr std::size_t kLeast = 1024;
    return kLeast + graph->vertexCount() * kOfAVertex + graph->edgeCount() * kOfAnEdge;
}

/// What an outside program said: to its standard error, and where it did not solve, to its standard output.
void keepWords(const Planner &planner, RunRecord &record)
{
    const auto *program = dynamic_cast<const CommandPlanner *>(&planner);
    if (program == nullptr)
        return;
    if (!program->errorTail().empty())
        record.extra["error_output"] = program->errorTail();
    if (!record.solved() && !program->outputTail().empty())
        record.extra["standard_output"] = program->outputTail();
}

} // namespace

InProcessExecutor::InProcessExecutor(const BenchmarkPlan &plan, const Catalog &catalog, std::int64_t jobs,
                                     PreRunEvent preRun)
    : plan_(plan), catalog_(catalog), jobs_(jobs), preRun_(std::move(preRun)),
      graphs_(static_cast<std::size_t>(jobs) + 1, graphSize, kGraphBudget),
      instances_(static_cast<std::size_t>(jobs) + 1)
{}

RunResult InProcessExecutor::execute(const RunSpec &spec, const std::stop_token &stop)
{
    const std::uint64_t pauses = pauses_.count();
    checkCommand(spec);
    RunResult result = executeOnce(spec, stop);
    checkCommand(spec);
    result.paused = pauses_.count() != pauses;
    return result;
}

void InProcessExecutor::checkCommand(const RunSpec &spec) const
{
    if (inputs_)
        inputs_->check(inputFilesOf(plan_.planners[spec.planner]));
}

void InProcessExecutor::checkInputs(const Problem &problem) const
{
    if (inputs_)
        inputs_->check(problem.inputFiles());
}

RunResult InProcessExecutor::executeOnce(const RunSpec &spec, const std::stop_token &stop)
{
    std::shared_ptr<const PreparedInstance> prepared;
    try
    {
        prepared = instance(spec, stop);
    }
    catch (const DoesNotFit &error)
    {
        RunResult none;
        none.record.status = PlannerStatus::unsupported;
        none.record.reason = std::string("there is no such instance: ") + error.what();
        fillIdentity(none.record, plan_, spec);
        return none;
    }
    std::vector<NamedOptimizer> optimizers;
    for (const Configured &optimizer : plan_.optimizers)
        optimizers.push_back({optimizer.name, create(catalog_.optimizers, optimizer)});

    const auto makePlanner = [&]
    {
        auto planner = createPlanner(catalog_, plan_.planners[spec.planner]);
        planner->setSeed(spec.plannerSeed);
        if (preRun_)
            preRun_(*planner, spec);
        return planner;
    };
    const auto planner = makePlanner();

    RunSettings settings;
    settings.limits = plan_.limits;
    settings.motion = plan_.motion;
    settings.ownProcess = jobs_ == 1;
    settings.timingRepeats = plan_.execution.timingRepeats;
    settings.warmUp = plan_.execution.warmUp;
    settings.again = makePlanner;
    settings.onPhase = onPhase_;
    RunResult result = runPlanner(*planner, *prepared, optimizers, settings, stop);
    keepWords(*planner, result.record);
    fillIdentity(result.record, plan_, spec);
    result.record.limitMeans =
        settings.ownProcess ? "time asked, cpu asked, memory afterwards" : "time asked";
    if (!result.record.solutionFingerprint.empty() && addsMetrics_)
        addMetrics(result);
    return result;
}

void InProcessExecutor::addMetrics(RunResult &result) const
{
    if (onPhase_ && !catalog_.metrics.empty())
        onPhase_(RunPhase::measure, result.record);
    for (const AddedMetric &metric : catalog_.metrics)
    {
        const std::string who = "metric '" + metric.name + "'";
        try
        {
            if (const auto value = metric.measure(*result.instance, result.solution))
                result.record.extra[metric.name] = *value;
        }
        catch (const std::exception &error)
        {
            addNote(result.record, who + " threw: " + error.what());
        }
        catch (...)
        {
            addNote(result.record, who + " threw something that is no std::exception");
        }
    }
}

std::shared_ptr<const Graph> InProcessExecutor::graph(const RunSpec &spec)
{
    const Problem &problem = *plan_.points[spec.point].problem;
    const auto make = [&]
    {
        checkInputs(problem);
        auto made = problem.makeGraph(spec.graphSeed);
        checkInputs(problem);
        return made;
    };
    return graphs_.get(graphKey(plan_, spec), make);
}

std::shared_ptr<const PreparedInstance> InProcessExecutor::instance(const RunSpec &spec,
                                                                    const std::stop_token &stop)
{
    const auto make = [&]
    {
        const Problem &problem = *plan_.points[spec.point].problem;
        checkInputs(problem);
        auto made = mrpp::makeInstance(problem, graph(spec), spec.instanceSeed);
        checkInputs(problem);
        return std::make_shared<const PreparedInstance>(
            prepare(std::make_shared<const Instance>(std::move(made)), preparationTime(plan_.limits.time),
                    {.stop = TerminationCondition::when(stop)}));
    };
    return instances_.get(spec.caseId, make);
}

} // namespace mrpp

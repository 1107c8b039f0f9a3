#include "reports/explorer/PlayableRuns.h"

#include "framework/store/SolutionCodec.h"
#include "framework/support/Bytes.h"
#include "reports/explorer/GraphBlock.h"
#include "reports/explorer/Packing.h"

#include <utility>

namespace mrpp
{

namespace
{

std::string robotsText(const Instance &instance)
{
    ByteWriter writer;
    writer.number(instance.robotCount());
    for (const auto *places : {&instance.starts, &instance.goals})
    {
        Vertex previous = 0;
        for (const Vertex v : *places)
            writer.difference(v, std::exchange(previous, v));
    }
    return packedText(writer.take());
}

/// The steps as actions, whatever happens in them.
Solution stepsAsActions(const Schedule &schedule)
{
    Solution solution;
    for (std::size_t step = 0; step < schedule.makespan(); ++step)
    {
        const auto moves = schedule.step(step);
        if (moves.size() == 1)
            solution.append(moves.front());
        else
            solution.appendRotation(moves);
    }
    return solution;
}

} // namespace

bool PlayableRuns::add(std::size_t run, const std::string &caseName, const Instance &instance,
                       const Solution &solution, const Solution *optimized)
{
    PlayableRun playable;
    playable.run = run;
    playable.solution = packedText(packSolution(solution));
    if (optimized != nullptr)
        playable.optimized = packedText(packSolution(*optimized));
    return add(std::move(playable), caseName, instance);
}

bool PlayableRuns::add(std::size_t run, const std::string &caseName, const Instance &instance,
                       const Schedule &schedule)
{
    PlayableRun playable;
    playable.run = run;
    playable.isSequential = false;
    playable.solution = packedText(packSolution(stepsAsActions(schedule)));
    return add(std::move(playable), caseName, instance);
}

bool PlayableRuns::add(PlayableRun run, const std::string &caseName, const Instance &instance)
{
    std::size_t size = size_ + run.solution.size() + run.optimized.size();
    const auto knownCase = caseNumbers_.find(caseName);
    if (knownCase != caseNumbers_.end())
    {
        if (size > limit_)
            return false;
        run.inCase = knownCase->second;
        size_ = size;
        runs_.push_back(std::move(run));
        return true;
    }

    PlayableCase newCase{caseName, graphs_.size(), instance.robotCount(), robotsText(instance)};
    std::string graph = packedText(graphBlock(*instance.graph));
    const auto knownGraph = graphNumbers_.find(graph);
    size += newCase.robotsText.size() + (knownGraph == graphNumbers_.end() ? graph.size() : 0);
    if (size > limit_)
        return false;
    if (knownGraph != graphNumbers_.end())
        newCase.graph = knownGraph->second;
    else
    {
        graphNumbers_.emplace(graph, graphs_.size());
        graphs_.push_back(std::move(graph));
    }
    run.inCase = cases_.size();
    caseNumbers_.emplace(caseName, cases_.size());
    cases_.push_back(std::move(newCase));
    size_ = size;
    runs_.push_back(std::move(run));
    return true;
}

} // namespace mrpp

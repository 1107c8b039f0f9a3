#pragma once
/// \file
/// A unit of time that compares across machines, idle or busy: the processor time of one breadth-first search
/// over the whole graph.
///
/// \code
/// const BfsUnit unit(*graph);
/// for (auto _ : state)
///     work();
/// unit.report(state); // adds the column "BFS": the time of an iteration in searches
/// \endcode

#include "framework/analysis/BreadthFirstSearch.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <ctime>
#include <limits>

namespace mrpp::test
{

class BfsUnit
{
public:
    /// Times a few searches and takes the fastest.
    explicit BfsUnit(const Graph &graph)
    {
        BreadthFirstSearch search(graph);
        for (int i = 0; i < 20; ++i)
        {
            const std::clock_t begin = std::clock();
            search.run(0);
            benchmark::DoNotOptimize(search.order().size());
            search_ = std::min(search_, static_cast<double>(std::clock() - begin));
        }
        begin_ = std::clock();
    }

    /// Call right behind the loop: everything since construction counts as the loop's.
    void report(benchmark::State &state) const
    {
        const auto loop = static_cast<double>(std::clock() - begin_);
        state.counters["BFS"] = loop / static_cast<double>(state.iterations()) / search_;
    }

private:
    double search_ = std::numeric_limits<double>::infinity(); ///< clock ticks
    std::clock_t begin_ = 0;
};

} // namespace mrpp::test

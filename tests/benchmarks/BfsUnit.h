#pragma once
/// \file
/// A unit of time that compares across machines: one breadth-first search over the whole graph.
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
#include <chrono>
#include <limits>

namespace mrpp::test
{

class BfsUnit
{
public:
    /// Times a few searches and takes the fastest.
    explicit BfsUnit(const Graph &graph) : begin_(std::chrono::steady_clock::now())
    {
        BreadthFirstSearch search(graph);
        for (int i = 0; i < 20; ++i)
        {
            const auto begin = std::chrono::steady_clock::now();
            search.run(0);
            benchmark::DoNotOptimize(search.order().size());
            seconds_ = std::min(seconds_, secondsSince(begin));
        }
        begin_ = std::chrono::steady_clock::now();
    }

    /// Call right behind the loop: everything since construction counts as the loop's.
    void report(benchmark::State &state) const
    {
        state.counters["BFS"] = secondsSince(begin_) / static_cast<double>(state.iterations()) / seconds_;
        state.counters["BFS_us"] = seconds_ * 1e6;
    }

private:
    using Time = std::chrono::steady_clock::time_point;
    static double secondsSince(Time begin)
    {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    }

    double seconds_ = std::numeric_limits<double>::infinity();
    Time begin_;
};

} // namespace mrpp::test

#pragma once
/// \file
/// The catalog with everything in it, and GoogleTest parameters made of its names: what is registered is
/// tested, without being named in the tests.

#include "algorithms/Algorithms.h"
#include "framework/Catalog.h"
#include "problems/Problems.h"
#include "reports/Reports.h"

#include <gtest/gtest.h>
#include <string>
#include <vector>

namespace mrpp::test
{

inline Catalog everythingRegistered()
{
    Catalog catalog;
    registerAlgorithms(catalog);
    registerProblems(catalog);
    registerReports(catalog);
    return catalog;
}

/// A problem of the small benchmark, as an instance.
inline Instance smallProblem(const Catalog &catalog, const std::string &name)
{
    const auto problem = catalog.problems.create("small_benchmark");
    problem->configure(Config::scalar(name), {.catalog = &catalog});
    auto graph = problem->makeGraph(1);
    const std::size_t robots = problem->robotCount(*graph);
    return problem->makeInstance(std::move(graph), robots, 1);
}

inline std::string nameOf(const testing::TestParamInfo<std::string> &test)
{
    return test.param;
}

} // namespace mrpp::test

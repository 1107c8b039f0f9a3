#include "OneAtATime.h"
#include "Star.h"

#include "algorithms/Algorithms.h"
#include "framework/Benchmark.h"
#include "framework/store/ResultStore.h"
#include "problems/Problems.h"
#include "reports/Reports.h"
#include "yaml/PlanReader.h"

#include <iostream>

int main(int, char **arguments)
{
    mrpp::Catalog catalog;
    mrpp::registerAlgorithms(catalog);
    mrpp::registerProblems(catalog);
    mrpp::registerReports(catalog);
    catalog.planners.add<OneAtATime>("one_at_a_time", "shortest paths around everybody else");
    catalog.problems.add<Star>("star", "arms around one vertex, from whose ends robots change places");

    mrpp::Benchmark benchmark(mrpp::readPlan(arguments[1], catalog), catalog);
    const auto summary = benchmark.benchmark({.folder = arguments[2]}, {});
    for (const auto &[status, runs] : summary.statuses)
        std::cout << mrpp::toString(status) << ": " << runs << '\n';

    const mrpp::ResultStore store(arguments[2], mrpp::ResultStore::Access::read);
    const mrpp::ResultTable table(benchmark.plan(), store.records(),
                                  [&store](const std::string &key) { return store.solution(key); });
    for (const auto &file :
         catalog.reports.create("csv")->write(table, mrpp::Provenance::here(), arguments[2]))
        std::cout << "wrote " << file.filename().string() << '\n';
}

#include "tests/yaml/TestCatalog.h"

namespace mrpp::test
{

namespace
{

/// A problem of the tests never runs.
class Family : public Problem
{
public:
    [[nodiscard]] std::shared_ptr<const Graph> makeGraph(Seed) const override
    {
        return Graph::fromEdges(2, {{0, 1}});
    }
};

class Puzzle final : public Family
{
public:
    Puzzle() { declareParam("problem", problem_, "tree,tunnel,string", "which one"); }
    [[nodiscard]] std::string name() const override { return problem_; }
    [[nodiscard]] bool takesRobotCount() const override { return false; }

private:
    std::string problem_ = "tree";
};

class Map final : public Family
{
public:
    Map()
    {
        declareParam("map", map_, "", "file");
        declareParam("passable", passable_, "movingai,strict", "cells");
    }
    [[nodiscard]] std::string name() const override { return map_.stem().string(); }

private:
    std::filesystem::path map_;
    std::string passable_ = "movingai";
};

class Ladder final : public Family
{
public:
    Ladder()
    {
        declareParam("rungs", rungs_, "1:1000", "how many");
        declareParam("density", density_, "0:1", "share of rungs");
    }
    [[nodiscard]] std::string name() const override { return "ladder"; }

private:
    std::int64_t rungs_ = 1;
    double density_ = 1;
};

/// Takes `graph: {square: {side: N}}` or `graph: {ring: {length: N, chords: N}}`.
class Growing final : public Family
{
public:
    void configure(const Config &settings, const ProblemContext &context) override
    {
        const Config *graph = settings.isMap() ? settings.find("graph") : nullptr;
        if (graph == nullptr || !graph->isMap() || graph->entries().size() != 1)
            throw PlanError(settings.where(), "give a graph");
        std::vector<Config::Entry> others;
        for (const Config::Entry &entry : settings.entries())
            if (entry.key != "graph")
                others.push_back(entry);
        Problem::configure(Config::map(others, settings.where()), context);
        name_ = graph->entries().front().key;
        for (const Config::Entry &entry : graph->entries().front().value.entries())
            name_ += " " + std::to_string(entry.value.integer());
    }
    [[nodiscard]] std::string name() const override { return name_; }
    [[nodiscard]] bool variesGraph() const override { return true; }

private:
    std::string name_;
};

class Walker final : public Planner
{
public:
    Walker() : Planner({.citation = "none", .completeFor = "nothing"})
    {
        declareParam("pace", pace_, "1:10", "vertices at once");
        declareParam("order", order_, "near_first,far_first", "who goes first");
    }
    PlannerStatus solve(const TerminationCondition &) override { return PlannerStatus::gave_up; }

private:
    std::int64_t pace_ = 1;
    std::string order_ = "near_first";
};

class Runner final : public Planner
{
public:
    Runner() : Planner({.citation = "none", .completeFor = "nothing"}) {}
    PlannerStatus solve(const TerminationCondition &) override { return PlannerStatus::gave_up; }
};

class Shorten final : public Optimizer
{
public:
    Shorten() { declareParam("rounds", rounds_, "1:100", "how often"); }
    [[nodiscard]] Solution improve(const Instance &, Solution solution,
                                   const TerminationCondition &) const override
    {
        return solution;
    }

private:
    std::int64_t rounds_ = 1;
};

class Silence final : public Report
{
public:
    [[nodiscard]] std::vector<std::filesystem::path> write(const ResultTable &, const Provenance &,
                                                           const std::filesystem::path &) const override
    {
        return {};
    }
};

/// Files of the tests are neither written nor read.
class NoFiles final : public FileExchange
{
public:
    [[nodiscard]] std::string extensionOf(const std::string &) const override { return ".txt"; }
    void writeGraph(const std::string &, const Graph &, const std::filesystem::path &) const override {}
    void writeInstance(const std::string &, const Instance &, const std::filesystem::path &,
                       const std::filesystem::path &) const override
    {}
    [[nodiscard]] std::optional<Schedule> readSolution(const std::string &, const Instance &,
                                                       const std::filesystem::path &) const override
    {
        return std::nullopt;
    }
};

} // namespace

Catalog makeCatalog()
{
    Catalog catalog;
    catalog.problems.add<Puzzle>("puzzle", "one of three");
    catalog.problems.add<Map>("map", "a map");
    catalog.problems.add<Ladder>("ladder", "a ladder");
    catalog.problems.add<Growing>("growing", "graphs of many sizes");
    catalog.planners.add<Walker>("walker", "walks");
    catalog.planners.add<Runner>("runner", "runs");
    catalog.optimizers.add<Shorten>("shorten", "shortens");
    catalog.reports.add<Silence>("csv", "tables");
    catalog.reports.add<Silence>("charts", "figures");
    catalog.formats = {{"graphml", ".graphml", "graph", true, true, ""},
                       {"instance", ".instance", "instance", true, true, ""},
                       {"solution", ".csv", "solution", true, true, ""},
                       {"kei18_result", ".txt", "solution", true, true, ""}};
    catalog.files = std::make_shared<NoFiles>();
    return catalog;
}

} // namespace mrpp::test

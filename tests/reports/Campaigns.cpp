#include "tests/reports/Campaigns.h"

#include "framework/Problem.h"
#include "framework/run/RunIdentity.h"
#include "framework/support/Config.h"

#include <cmath>

namespace mrpp::testing
{

namespace
{

class FixedProblem : public Problem
{
public:
    FixedProblem(std::string name, Instance instance) : name_(std::move(name)), instance_(std::move(instance))
    {}
    [[nodiscard]] std::string name() const override { return name_; }
    [[nodiscard]] std::shared_ptr<const Graph> makeGraph(Seed) const override { return instance_.graph; }
    [[nodiscard]] std::size_t robotCount(const Graph &) const override { return instance_.robotCount(); }
    [[nodiscard]] Instance makeInstance(std::shared_ptr<const Graph>, std::size_t, Seed) const override
    {
        return instance_;
    }

private:
    std::string name_;
    Instance instance_;
};

} // namespace

FakeCampaign::FakeCampaign(std::string name, std::int64_t repetitions)
{
    plan_.campaign = std::move(name);
    plan_.repetitions = repetitions;
    plan_.text = "campaign: " + plan_.campaign + "\nrepetitions: " + std::to_string(repetitions) + "\n";
    plan_.file = "plan.yaml";
}

FakeCampaign &FakeCampaign::planner(const std::string &name, MotionRule rule)
{
    plan_.planners.push_back({"fake" + std::to_string(plan_.planners.size()), name, {}});
    plan_.planners.back().motion = rule;
    return *this;
}

FakeCampaign &FakeCampaign::planners(std::size_t count)
{
    for (std::size_t i = 0; i < count; ++i)
        planner("planner_" + std::to_string(i));
    return *this;
}

FakeCampaign &FakeCampaign::problem(const std::string &model, const std::string &name,
                                    const Instance &instance)
{
    plan_.points.push_back(
        {model, std::make_shared<FixedProblem>(name, instance), name, "", std::nullopt, name});
    return *this;
}

FakeCampaign &FakeCampaign::sweep(const std::string &model, const std::string &name,
                                  const std::string &variable, const std::vector<double> &values,
                                  const std::function<Instance(double value)> &makeInstance)
{
    for (const double value : values)
        plan_.points.push_back({model, std::make_shared<FixedProblem>(name, makeInstance(value)), name,
                                variable, value, name + formatNumber(value)});
    return *this;
}

FakeCampaign &FakeCampaign::solution(const std::string &problem, Solution solution)
{
    solutions_[problem] = std::move(solution);
    return *this;
}

ResultTable FakeCampaign::run(const Outcome &outcome) const
{
    std::vector<RunRecord> records;
    std::map<std::string, Solution> byKey;
    for (const RunSpec &spec : expand(plan_))
    {
        RunRecord record;
        fillIdentity(record, plan_, spec);
        const Problem &problem = *plan_.points[spec.point].problem;
        const Instance instance = makeInstance(problem, problem.makeGraph(0), 0);
        record.vertices = static_cast<std::int64_t>(instance.graph->vertexCount());
        record.edges = static_cast<std::int64_t>(instance.graph->edgeCount());
        record.robots = static_cast<std::int64_t>(instance.robotCount());
        record.free = static_cast<std::int64_t>(instance.freeCount());
        record.occupancy = instance.occupancy();
        outcome(record, spec.planner);
        if (const auto solution = solutions_.find(record.problem);
            record.solved() && solution != solutions_.end())
            byKey[record.runKey] = solution->second;
        records.push_back(std::move(record));
    }
    return {plan_, std::move(records),
            [byKey](const std::string &key) -> std::optional<Solution>
            {
                const auto found = byKey.find(key);
                return found == byKey.end() ? std::nullopt : std::optional(found->second);
            }};
}

void solveSmoothly(RunRecord &record, std::size_t planner)
{
    const double size = record.sweepValue.value_or(static_cast<double>(*record.vertices));
    const auto factor = 1 + 0.3 * static_cast<double>(planner);
    const auto wobble = 1 + 0.1 * static_cast<double>((record.repetition * 7) % 5);
    record.status = PlannerStatus::solved;
    record.completed = 1;
    record.time = 1e-4 * size * size * factor * wobble;
    record.memory = 10 + size / 100;
    record.pathLengthLowerBound = static_cast<std::int64_t>(size * 8);
    record.makespanLowerBound = static_cast<std::int64_t>(std::sqrt(size) * 4) + 1;
    record.pathLength = static_cast<std::int64_t>(size * 10 * factor * wobble);
    record.actions = record.pathLength;
    record.optimizedPathLength = static_cast<std::int64_t>(size * 9 * factor * wobble);
    record.makespan = static_cast<std::int64_t>(size * 2 * factor * wobble) + 4;
    record.optimizedMakespan = static_cast<std::int64_t>(size * 1.7 * factor * wobble) + 4;
    record.sumOfCosts = static_cast<std::int64_t>(size * 20 * factor * wobble);
}

Instance gridInstance(std::size_t side, std::size_t robots, bool withCoordinates)
{
    std::vector<Graph::Edge> edges;
    std::vector<Point> coordinates;
    for (std::size_t y = 0; y < side; ++y)
        for (std::size_t x = 0; x < side; ++x)
        {
            const auto v = static_cast<Vertex>(y * side + x);
            if (withCoordinates)
                coordinates.push_back({static_cast<double>(x), static_cast<double>(y), 0});
            if (x + 1 < side)
                edges.push_back({v, v + 1});
            if (y + 1 < side)
                edges.push_back({v, static_cast<Vertex>(v + side)});
        }
    Instance instance{Graph::fromEdges(side * side, edges, std::move(coordinates), YAxis::down), {}, {}};
    for (std::size_t robot = 0; robot < robots; ++robot)
    {
        instance.starts.push_back(static_cast<Vertex>(robot));
        instance.goals.push_back(static_cast<Vertex>(side * side - 1 - robot));
    }
    return instance;
}

Instance treeInstance()
{
    const std::vector<Graph::Edge> edges = {{0, 1}, {1, 2}, {3, 1}, {4, 3}, {4, 5}, {6, 4}};
    std::vector<Point> coordinates = {{0, 0}, {1, 0}, {2, 0}, {1, 1}, {1, 2}, {2, 2}, {1, 3}};
    return {Graph::fromEdges(7, edges, std::move(coordinates), YAxis::down), {1, 4, 6}, {6, 1, 4}};
}

Provenance fakeProvenance()
{
    Provenance provenance;
    provenance.version = "0.1.0";
    provenance.revision = "0123456789abcdef0123456789abcdef01234567";
    provenance.compiler = "GNU 12.2.0";
    provenance.buildType = "Release";
    provenance.host = "workstation";
    provenance.system = "Linux 6.1, Debian GNU/Linux 12 (bookworm)";
    provenance.cpu = "A processor @ 3.00GHz";
    provenance.cores = 2;
    provenance.memory = 24000;
    provenance.started = "2026-07-31T12:00:00Z";
    provenance.finished = "2026-07-31T12:34:56Z";
    provenance.campaign = "demo";
    provenance.planFile = "plan.yaml";
    provenance.planFingerprint = "00112233445566778899aabbccddeeff";
    provenance.seed = 2016;
    provenance.libraries = {"SQLite 3.40.1", "gnuplot 5.4"};
    return provenance;
}

} // namespace mrpp::testing

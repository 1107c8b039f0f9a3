#include "tests/campaign/Fixtures.h"

#include "framework/run/RunRecordJson.h"
#include "framework/store/ResultStore.h"
#include "framework/system/File.h"

#include <chrono>
#include <cstdlib>
#include <memory>
#include <new>
#include <stdexcept>
#include <thread>

namespace mrpp::fixtures
{

namespace
{

/// A planner that is one function.
class Scripted final : public Planner
{
public:
    using Act = std::function<PlannerStatus(Scripted &, const TerminationCondition &)>;

    explicit Scripted(Act act, MotionRule motion = MotionRule::pebble)
        : Planner({.citation = "", .motion = motion, .completeFor = "nothing", .provesInfeasibility = false}),
          act_(std::move(act))
    {}
    PlannerStatus solve(const TerminationCondition &ptc) override { return act_(*this, ptc); }

    using Planner::because;
    using Planner::instance;
    using Planner::setSolution;

private:
    Act act_;
};

class SetupThrower final : public Planner
{
public:
    SetupThrower() : Planner({}) {}
    void setup() override { throw std::runtime_error("no setup today"); }
    PlannerStatus solve(const TerminationCondition &) override { return PlannerStatus::solved; }
};

class Picky final : public Planner
{
public:
    Picky() : Planner({}) {}
    std::optional<std::string> reasonToReject(const Instance &) const override { return "not my kind"; }
    PlannerStatus solve(const TerminationCondition &) override { return PlannerStatus::solved; }
};

class ScriptedOptimizer final : public Optimizer
{
public:
    using Act = std::function<std::vector<Move>(std::vector<Move>)>;
    explicit ScriptedOptimizer(Act act) : act_(std::move(act)) {}
    Solution improve(const Instance &, Solution solution, const TerminationCondition &) const override
    {
        return Solution(act_(std::move(solution).releaseMoves()));
    }

private:
    Act act_;
};

std::vector<Move> trim(std::vector<Move> moves)
{
    std::vector<Move> kept;
    for (const Move &move : moves)
    {
        const bool back = !kept.empty() && kept.back().robot == move.robot && kept.back().from == move.to;
        if (back)
            kept.pop_back();
        else
            kept.push_back(move);
    }
    return kept;
}

std::vector<Move> stretch(std::vector<Move> moves)
{
    const Move first = moves.front();
    moves.insert(moves.begin(), {first, {first.robot, first.to, first.from}});
    return moves;
}

/// Along the row, one column a move.
void walk(Robot robot, Vertex from, Vertex to, Solution &solution)
{
    while (from != to)
    {
        const Vertex next = from < to ? from + 1 : from - 1;
        solution.append({robot, from, next});
        from = next;
    }
}

void addPlanner(Catalog &catalog, const std::string &name, Scripted::Act act,
                MotionRule motion = MotionRule::pebble)
{
    catalog.planners.add(name, "",
                         [act, motion]() -> std::unique_ptr<Planner>
                         { return std::make_unique<Scripted>(act, motion); });
}

void addOptimizer(Catalog &catalog, const std::string &name, ScriptedOptimizer::Act act)
{
    catalog.optimizers.add(
        name, "", [act]() -> std::unique_ptr<Optimizer> { return std::make_unique<ScriptedOptimizer>(act); });
}

} // namespace

Lanes::Lanes()
{
    declareParam("rows", rows_, "1:100", "rows");
    declareParam("length", length_, "2:1000", "columns");
    declareParam("file", file_, "", "another input");
}

void Lanes::check() const
{
    for (const auto &file : inputFiles())
        if (readFile(file).starts_with("bad"))
            throw ParseError({file.string(), 1, 1}, "begins with 'bad'");
    const std::size_t robots = robotCount(*makeGraph(0));
    if (!inputFiles().empty() && robots > static_cast<std::size_t>(rows_))
        throw InputError(std::to_string(robots) + " robots never fit " + std::to_string(rows_) + " lanes");
}

std::vector<std::filesystem::path> Lanes::inputFiles() const
{
    return file_.empty() ? std::vector<std::filesystem::path>() : std::vector{file_};
}

std::shared_ptr<const Graph> Lanes::makeGraph(Seed) const
{
    std::vector<Graph::Edge> edges;
    const auto rows = static_cast<Vertex>(rows_);
    const auto length = static_cast<Vertex>(length_);
    for (Vertex v = 0; v < rows * length; ++v)
    {
        if (v % length + 1 < length)
            edges.push_back({v, v + 1});
        if (v + length < rows * length)
            edges.push_back({v, v + length});
    }
    return Graph::fromEdges(rows * length, edges);
}

Instance Lanes::makeInstance(std::shared_ptr<const Graph> graph, std::size_t robots, Seed seed) const
{
    if (robots > static_cast<std::size_t>(rows_))
        throw DoesNotFit(std::to_string(robots) + " robots do not fit " + std::to_string(rows_) + " lanes");
    Instance instance{std::move(graph), {}, {}};
    Random random(seed);
    const auto length = static_cast<std::uint64_t>(length_);
    for (std::uint64_t row = 0; row < robots; ++row)
    {
        instance.starts.push_back(static_cast<Vertex>(row * length + random.below(length / 2)));
        instance.goals.push_back(static_cast<Vertex>(row * length + length / 2 + random.below(length / 2)));
    }
    return instance;
}

Walker::Walker() : Planner({.citation = "", .completeFor = "lanes"})
{
    declareParam("detours", detours_, "0:100", "steps to and fro");
    declareParam("pause", pause_, "0:100", "seconds");
}

PlannerStatus Walker::solve(const TerminationCondition &ptc)
{
    const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(pause_);
    while (std::chrono::steady_clock::now() < end)
    {
        if (ptc())
            return PlannerStatus::timeout;
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    Solution solution;
    for (Robot robot = 0; robot < instance().robotCount(); ++robot)
    {
        const Vertex start = instance().starts[robot];
        for (std::int64_t i = 0; i < detours_ && robot == 0; ++i)
        {
            solution.append({robot, start, start + 1});
            solution.append({robot, start + 1, start});
        }
        walk(robot, start, instance().goals[robot], solution);
    }
    setSolution(std::move(solution));
    return PlannerStatus::solved;
}

Catalog catalog()
{
    using enum PlannerStatus;
    Catalog catalog;
    catalog.problems.add<Lanes>("lanes", "");
    catalog.planners.add<Walker>("walker", "");
    catalog.planners.add<SetupThrower>("setup_thrower", "");
    catalog.planners.add<Picky>("picky", "");
    addPlanner(catalog, "thrower",
               [](auto &, auto &) -> PlannerStatus { throw std::runtime_error("no luck"); });
    addPlanner(catalog, "ball_thrower", [](auto &, auto &) -> PlannerStatus { throw 7; });
    addPlanner(catalog, "eater", [](auto &, auto &) -> PlannerStatus { throw std::bad_alloc(); });
    addPlanner(catalog, "hanger",
               [](auto &, const TerminationCondition &ptc)
               {
                   while (!ptc())
                       std::this_thread::sleep_for(std::chrono::milliseconds(1));
                   return timeout;
               });
    addPlanner(catalog, "sleeper",
               [](Scripted &self, auto &)
               {
                   std::this_thread::sleep_for(std::chrono::milliseconds(300));
                   Solution solution;
                   for (Robot robot = 0; robot < self.instance().robotCount(); ++robot)
                       walk(robot, self.instance().starts[robot], self.instance().goals[robot], solution);
                   self.setSolution(std::move(solution));
                   return solved;
               });
    addPlanner(catalog, "quitter", [](Scripted &self, auto &) { return self.because(gave_up, "too hard"); });
    addPlanner(catalog, "prover", [](Scripted &self, auto &) { return self.because(infeasible, "proof"); });
    addPlanner(catalog, "shrugger", [](auto &, auto &) { return unknown; });
    addPlanner(catalog, "liar", [](auto &, auto &) { return solved; });
    addPlanner(catalog, "jumper",
               [](Scripted &self, auto &)
               {
                   self.setSolution(Solution({{0, self.instance().starts[0], self.instance().goals[0]}}));
                   return solved;
               });
    const auto half = [](Scripted &self, auto &)
    {
        Solution solution;
        walk(0, self.instance().starts[0], self.instance().goals[0], solution);
        self.setSolution(std::move(solution));
        return self.because(partial, "only robot 0");
    };
    addPlanner(catalog, "half", half);
    addPlanner(catalog, "turner", half, MotionRule::rotation);
    addPlanner(catalog, "bad_half",
               [](Scripted &self, auto &)
               {
                   self.setSolution(Solution({{0, self.instance().goals[0], self.instance().starts[0]}}));
                   return partial;
               });
    addOptimizer(catalog, "trimmer", trim);
    addOptimizer(catalog, "stretcher", stretch);
    addOptimizer(catalog, "breaker",
                 [](std::vector<Move> moves)
                 {
                     moves.pop_back();
                     return moves;
                 });
    addOptimizer(catalog, "failing",
                 [](std::vector<Move>) -> std::vector<Move> { throw std::logic_error("lost count"); });
    return catalog;
}

ProblemPoint lanes(std::int64_t robots, const std::filesystem::path &file)
{
    std::vector<Config::Entry> entries;
    const auto set = [&entries](const std::string &key, const std::string &value)
    {
        entries.emplace_back();
        entries.back().key = key;
        entries.back().value = Config::scalar(value);
    };
    set("robots", std::to_string(robots));
    if (!file.empty())
        set("file", file.string());
    const Config settings = Config::map(entries);
    auto problem = std::make_shared<Lanes>();
    problem->configure(settings, {});
    return {"lanes", problem, "lanes", "robots", static_cast<double>(robots), settings.canonical(), ""};
}

BenchmarkPlan plan(const std::vector<std::string> &planners, std::int64_t repetitions)
{
    BenchmarkPlan plan;
    plan.campaign = "test";
    plan.seed = 2016;
    plan.repetitions = repetitions;
    plan.limits.time = 10;
    for (const std::int64_t robots : {1, 2, 3})
        plan.points.push_back(lanes(robots));
    for (const std::string &planner : planners)
        plan.planners.push_back({planner, planner, {}});
    plan.text = "campaign: test\n";
    plan.file = "test.yaml";
    return plan;
}

std::string timeless(RunRecord record)
{
    record.time.reset();
    record.setupTime.reset();
    record.optimizationTime.reset();
    for (auto *measured : {&record.memory, &record.cpuTime, &record.timeMin, &record.timeMax, &record.timeIqr,
                           &record.load, &record.boundTime})
        measured->reset();
    record.cores.clear();
    record.limitMeans.clear();
    record.attempt = 0;
    return toJson(record, JsonColumns::all);
}

ResultTable table(const BenchmarkPlan &plan, const std::filesystem::path &folder)
{
    const auto store = std::make_shared<ResultStore>(folder, ResultStore::Access::read);
    auto records = store->records();
    return {plan, std::move(records), [store](const std::string &key) { return store->solution(key); }};
}

std::vector<std::string> rows(const BenchmarkPlan &plan, const std::filesystem::path &folder)
{
    std::vector<std::string> texts;
    const ResultTable results = table(plan, folder);
    for (const RunRecord &record : results.records())
        texts.push_back(timeless(record));
    return texts;
}

TemporaryFolder::TemporaryFolder()
{
    std::string name = (std::filesystem::temp_directory_path() / "mrpp-campaign-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr)
        throw std::runtime_error("no temporary folder");
    path_ = name;
}

TemporaryFolder::~TemporaryFolder()
{
    std::error_code error;
    std::filesystem::remove_all(path_, error);
}

} // namespace mrpp::fixtures

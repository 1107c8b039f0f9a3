#include "framework/plan/BenchmarkPlan.h"

#include "framework/plan/InputIdentity.h"
#include "framework/plan/PointError.h"
#include "framework/plan/RunKey.h"
#include "framework/support/Config.h"
#include "framework/support/Error.h"
#include "framework/support/Fingerprint.h"

#include <algorithm>
#include <map>

namespace mrpp
{

namespace
{

/// One part of a path: letters, digits and a few signs stay, every other character becomes one '_'.
std::string fileNamePart(std::string_view text)
{
    constexpr std::size_t kLongest = 100; // file systems take 255 bytes; names are joined with others
    constexpr std::string_view kSafe = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789._=+-";
    std::string part;
    for (const char c : text)
    {
        const bool continuesCharacter = (static_cast<unsigned char>(c) & 0xC0U) == 0x80U;
        if (continuesCharacter)
            continue;
        part += kSafe.find(c) == std::string_view::npos ? '_' : c;
    }
    part.resize(std::min(part.size(), kLongest));
    if (part.empty() || part.front() == '.')
        part.insert(part.begin(), '_');
    return part;
}

/// The case ids without their repetition, one a point.
std::vector<std::string> pointIds(const BenchmarkPlan &plan)
{
    std::vector<std::string> ids;
    std::map<std::string, int> uses;
    for (const ProblemPoint &point : plan.points)
    {
        std::string id = fileNamePart(point.model) + "/" + fileNamePart(point.name);
        if (!point.sweepVariable.empty())
            id += "/" + fileNamePart(point.sweepVariable + "=" +
                                     (point.sweepValue ? formatNumber(*point.sweepValue) : ""));
        const int use = ++uses[id];
        ids.push_back(use == 1 ? id : id + "#" + std::to_string(use)); // '#' is not in any part
    }
    return ids;
}

/// The key of a run by an outside program also depends on the files that its command names.
std::string withFiles(const std::string &key, const FileHashes &files)
{
    Fingerprint all;
    all.add(key);
    for (const auto &[name, hash] : files)
        all.add(name).add(hash);
    return all.hex();
}

/// What the problem itself says is wrong, which is more than that a file cannot be read.
InputError complaintOf(const Problem &problem, const InputError &error)
{
    try
    {
        problem.check();
    }
    catch (const InputError &better)
    {
        return better;
    }
    return error;
}

} // namespace

std::vector<PointIdentity> identifyPoints(const BenchmarkPlan &plan, MissingInput missing)
{
    InputHashes hashes;
    std::vector<PointIdentity> points;
    for (std::string &id : pointIds(plan))
    {
        const std::size_t point = points.size();
        const Problem &problem = *plan.points[point].problem;
        std::optional<std::string> inputs;
        try
        {
            inputs = hashes.of(problem.inputFiles(), missing);
        }
        catch (const InputError &error)
        {
            if (missing == MissingInput::refuse)
                throw PointError(complaintOf(problem, error), plan, point);
        }
        points.push_back({std::move(id), std::move(inputs)});
    }
    return points;
}

std::vector<RunSpec> expand(const BenchmarkPlan &plan, MissingInput missing)
{
    const std::vector<PointIdentity> points = identifyPoints(plan, missing);
    RunKeys keys(plan);
    const std::vector<std::optional<FileHashes>> files = identifyPlanners(plan, missing);
    std::vector<RunSpec> specs;
    specs.reserve(plan.points.size() * static_cast<std::size_t>(plan.repetitions) * plan.planners.size());
    for (std::size_t p = 0; p < plan.points.size(); ++p)
    {
        const ProblemPoint &point = plan.points[p];
        const std::string &identity = point.problem->identity();
        const auto &inputs = points[p].inputs;
        if (inputs)
            keys.enter(point, *inputs);
        for (std::int64_t repetition = 0; repetition < plan.repetitions; ++repetition)
        {
            RunSpec spec;
            spec.point = p;
            spec.repetition = repetition;
            spec.graphSeed = deriveSeed(plan.seed, "graph", point.model, identity, repetition);
            spec.instanceSeed = deriveSeed(plan.seed, "instance", point.model, identity, repetition);
            spec.plannerSeed = deriveSeed(plan.seed, "planner", point.model, point.settings, repetition);
            spec.caseId = points[p].id + "/" + std::to_string(repetition);
            for (spec.planner = 0; spec.planner < plan.planners.size(); ++spec.planner)
            {
                if (inputs)
                    keys.set(spec);
                if (inputs && !files[spec.planner])
                    spec.runKey.clear();
                else if (inputs && plan.planners[spec.planner].command)
                    spec.runKey = withFiles(spec.runKey, *files[spec.planner]);
                specs.push_back(spec);
            }
        }
    }
    return specs;
}

std::string graphKey(const BenchmarkPlan &plan, const RunSpec &spec)
{
    // All points of a sweep over robots share the graph, and all repetitions where it is not drawn by chance.
    const ProblemPoint &point = plan.points[spec.point];
    return point.model + '\n' + point.problem->identity() + '\n' +
           (point.problem->drawsGraph() ? std::to_string(spec.graphSeed) : "");
}

Instance makeInstance(const Problem &problem, std::shared_ptr<const Graph> graph, Seed seed)
{
    const std::size_t robots = problem.robotCount(*graph);
    Instance instance = problem.makeInstance(std::move(graph), robots, seed);
    if (const auto defect = instance.defect())
        throw InputError("problem '" + problem.name() + "' made a malformed instance: " + *defect);
    return instance;
}

} // namespace mrpp

#pragma once
/// \file
/// The public benchmark model (section III.B.3 of the MRPPSim paper): large grid maps of the Moving AI Lab,
/// with random instances or those of a scenario.
///
/// \code
/// - public_benchmark: {map: AR0307SR.map, robots: {from: 200, to: 2000, step: 100}}
/// - public_benchmark: {map: den520d.map, scenario: den520d-random-1.scen, robots: [50, 100]}
/// \endcode
///
/// Random robots start and end in the map's largest component; with `solvable: true` only instances are drawn
/// that have a solution (SolvableInstance.h), with `well_formed: true` only well-formed ones
/// (WellFormedInstance.h). The maps are their owner's and must be fetched
/// from https://movingai.com/benchmarks by the user: nothing here downloads.

#include "framework/Problem.h"
#include "problems/formats/MovingAiMap.h"

namespace mrpp
{

class PublicBenchmark : public Problem
{
public:
    PublicBenchmark();

    void configure(const Config &settings, const ProblemContext &context) override;
    /// The map file's name without its extension.
    [[nodiscard]] std::string name() const override { return map_.stem().string(); }
    [[nodiscard]] bool needsRobotCount() const override { return scenario_.empty(); }
    void check() const override;
    [[nodiscard]] std::vector<std::filesystem::path> inputFiles() const override;
    [[nodiscard]] bool drawsGraph() const override { return false; }
    [[nodiscard]] bool drawsInstance() const override { return scenario_.empty(); }
    [[nodiscard]] std::shared_ptr<const Graph> makeGraph(Seed seed) const override;
    /// As the plan says; a scenario without robots, free or occupancy means all of its records.
    [[nodiscard]] std::size_t robotCount(const Graph &graph) const override;
    /// Random, or the scenario's first records.
    [[nodiscard]] Instance makeInstance(std::shared_ptr<const Graph> graph, std::size_t robots,
                                        Seed seed) const override;

private:
    [[nodiscard]] GridMap load() const;

    std::filesystem::path map_;
    std::filesystem::path scenario_; ///< empty for random instances
    std::string passability_ = "movingai";
    bool solvable_ = false;
    bool wellFormed_ = false;
};

} // namespace mrpp

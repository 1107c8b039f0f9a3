#pragma once
/// \file
/// The fully controlled model (section III.B.1 of the MRPPSim paper): the user gives both graph and instance.
///
/// \code
/// - fully_controlled: {graph: theta.graphml, instance: theta.instance}
/// - fully_controlled: theta.instance      # which names its graph
/// \endcode

#include "framework/Problem.h"

namespace mrpp
{

class FullyControlled : public Problem
{
public:
    FullyControlled();

    void configure(const Config &settings, const ProblemContext &context) override;
    /// The instance file's name without its extension.
    [[nodiscard]] std::string name() const override { return instance_.stem().string(); }
    [[nodiscard]] bool takesRobotCount() const override { return false; }
    void check() const override;
    [[nodiscard]] std::vector<std::filesystem::path> inputFiles() const override;
    [[nodiscard]] bool drawsGraph() const override { return false; }
    [[nodiscard]] bool drawsInstance() const override { return false; }
    [[nodiscard]] std::shared_ptr<const Graph> makeGraph(Seed seed) const override;
    [[nodiscard]] std::size_t robotCount(const Graph &graph) const override;
    [[nodiscard]] Instance makeInstance(std::shared_ptr<const Graph> graph, std::size_t robots,
                                        Seed seed) const override;

private:
    [[nodiscard]] Instance load() const;

    std::filesystem::path instance_;
    std::filesystem::path graph_; ///< empty where the instance names it
    std::string passability_ = "movingai";
};

} // namespace mrpp

#pragma once
/// \file
/// The small benchmark model (section III.B.2 of the MRPPSim paper): well-known critical problems, graph and
/// instance ready, built into the library.
///
/// \code
/// - small_benchmark: [tree, tunnel, string]
/// \endcode
///
/// tree, tunnel, string, corners, connector and loop_chain are problems of R. Luna and K. E. Bekris, "Push
/// and Swap: Fast Cooperative Path-Finding with Completeness Guarantees", IJCAI 2011. corners_published has
/// the edges of the published file, which do not fit its drawing; corners has those of the drawing.
/// tree_with_cycle_leaves needs rotations. `theta` is a **reconstruction**: the paper names a theta graph of
/// 7 vertices and 8 edges on which two robots exchange their places, but never published it. Here it is
/// theta-0, two hubs (0 and 3) joined by three paths with one, two and two inner vertices.

#include "framework/Problem.h"

namespace mrpp
{

class SmallBenchmark : public Problem
{
public:
    SmallBenchmark();

    void configure(const Config &settings, const ProblemContext &context) override;
    [[nodiscard]] std::string name() const override { return problem_; }
    [[nodiscard]] bool takesRobotCount() const override { return false; }
    [[nodiscard]] bool drawsGraph() const override { return false; }
    [[nodiscard]] bool drawsInstance() const override { return false; }
    [[nodiscard]] std::shared_ptr<const Graph> makeGraph(Seed seed) const override;
    [[nodiscard]] std::size_t robotCount(const Graph &graph) const override;
    [[nodiscard]] Instance makeInstance(std::shared_ptr<const Graph> graph, std::size_t robots,
                                        Seed seed) const override;

private:
    std::string problem_;
};

/// The problems' names, in the order in which they are listed.
[[nodiscard]] std::vector<std::string> smallProblemNames();

/// Throws InputError for an unknown name, with the nearest known one.
[[nodiscard]] Instance smallProblem(std::string_view name);

} // namespace mrpp

#pragma once
/// \file
/// Whether the reason of an unsolvable instance is true, by brute force.

#include "framework/model/Instance.h"
#include "framework/model/MotionRule.h"
#include "tests/support/ConfigurationOrbits.h"

#include <string>
#include <vector>

namespace mrpp::test
{

/// Checks what solvability() says about instances on one tiny connected graph with one number of robots.
class ReasonCheck
{
public:
    /// \param orbits of the same graph, robots and rule; must outlive it
    ReasonCheck(std::shared_ptr<const Graph> graph, std::size_t robots, MotionRule rule,
                const ConfigurationOrbits &orbits);

    /// What is wrong with the reason; empty where it is true.
    [[nodiscard]] std::string complaint(const Instance &instance, const std::string &reason) const;

private:
    [[nodiscard]] std::string checkCorridor(const Instance &instance, const std::string &reason) const;
    [[nodiscard]] std::string checkPath(const Instance &instance, const std::string &reason) const;
    [[nodiscard]] std::string checkCycle(const Instance &instance, const std::string &reason) const;
    [[nodiscard]] std::string checkCutVertex(const Instance &instance, const std::string &reason) const;
    [[nodiscard]] std::string checkBridge(const Instance &instance, const std::string &reason) const;
    [[nodiscard]] std::string checkParity(const Instance &instance, const std::string &reason) const;

    [[nodiscard]] bool onCycle(Vertex v) const;
    [[nodiscard]] bool connected(Vertex a, Vertex b, Vertex withoutVertex) const;
    /// The configurations that the starts lead to and in which the goals' vertices are occupied.
    [[nodiscard]] std::vector<std::vector<Vertex>> places(const Instance &instance) const;

    std::shared_ptr<const Graph> graph_;
    std::size_t robots_;
    MotionRule rule_;
    const ConfigurationOrbits &orbits_;
    std::vector<std::vector<Vertex>> cycles_;
    std::vector<Vertex> positionOrbits_;
};

} // namespace mrpp::test

#pragma once
/// \file
/// Graphs of the generators, for tests, and what Boost.Graph says of them.

#include "framework/model/Graph.h"
#include "framework/support/Config.h"
#include "framework/support/Random.h"

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace mrpp::test
{

using Settings = std::vector<std::pair<std::string, std::string>>;

/// A map of scalars that stands at plan.yaml:4:5, its keys at column 7, its values at column 20.
[[nodiscard]] Config config(const Settings &settings);

/// A configured problem of the family.
template <class Family>
[[nodiscard]] std::unique_ptr<Family> make(const Settings &settings)
{
    auto problem = std::make_unique<Family>();
    problem->configure(config(settings), {});
    return problem;
}

/// What the error says that configuring the family ends with.
[[nodiscard]] std::string complaint(const char *family, const Settings &settings);

[[nodiscard]] bool isConnected(const Graph &graph);
[[nodiscard]] bool isBiconnected(const Graph &graph);
[[nodiscard]] bool isPlanar(const Graph &graph);

/// Whether each vertex lies on a cycle.
[[nodiscard]] std::vector<bool> onCycle(const Graph &graph);

/// Edges of the longest path of bridges whose inner vertices lie on no cycle. \pre no such path branches
[[nodiscard]] std::size_t longestIsthmus(const Graph &graph);

} // namespace mrpp::test

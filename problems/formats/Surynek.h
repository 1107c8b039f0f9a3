#pragma once
/// \file
/// Problems and solutions as the programs of P. Surynek (BIBOX, reLOC, boOX) write them: a graph with its
/// robots in one file (`.cpf`), moves in another.
///
/// \code
/// V =
/// (0:-1)[1:0:0]
/// (1:-1)[0:1:1]
/// E =
/// {0,1} (-1)
/// \endcode
///
/// `(vertex:cycle)[robot:goal:goal]`: the robot that starts here and the robot that ends here, counted from
/// 1; 0 is nobody. The variants of the same programs are read too: `(vertex:cycle:capacity)[…]` (.ccpf),
/// `(vertex,robot,goal)` (.mpf) and `(vertex,capacity,robot,goal)` (.cmpf).

#include "framework/model/Instance.h"
#include "problems/formats/SolutionRows.h"

#include <string>
#include <string_view>
#include <vector>

namespace mrpp
{

struct CpfProblem
{
    Instance instance; ///< with its graph, which has no coordinates
    std::vector<std::string> warnings;
};

/// Throws ParseError where a line breaks the grammar, vertices are not numbered 0, 1, 2, …, an edge names a
/// vertex that does not exist, a robot stands twice, or lacks its start or its goal, and where the file asks
/// for what this program does not have: capacities other than 1, sets of goals, conflicting edges. O(file).
[[nodiscard]] CpfProblem parseCpf(std::string_view text, const std::string &file);

[[nodiscard]] std::string formatCpf(const Instance &instance);

/// Reads `robot # from ---> to (step)` lines behind `Fine solution` and `Length:<moves>`; steps may have
/// gaps, in which everybody waits. Throws ParseError where a line breaks the grammar, steps go down, or there
/// are more or fewer moves than the length says. O(file).
[[nodiscard]] SolutionRows parseSurynekSolution(std::string_view text, const std::string &file);

[[nodiscard]] std::string formatSurynekSolution(const Schedule &schedule);

} // namespace mrpp

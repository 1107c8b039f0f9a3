#pragma once
/// \file
/// Instances as text: starts and goals on a graph that stands in another file.
///
/// \code
/// graph = theta.graphml
/// agent: start = 0, goal = 2
/// agent: start = 2, goal = 3
/// \endcode
///
/// Vertex numbers are positions of the graph's vertices in its file, from 0. The form is that of Fig. 2 in
/// E. T. S. Alotaibi and H. Al-Rawi, "MRPPSim: A Multi-Robot Path Planning Simulation", IJACSA 7(8), 2016.

#include "framework/model/Instance.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace mrpp
{

struct InstanceText
{
    struct Number
    {
        std::int64_t value = 0;
        std::size_t column = 0;
    };
    struct Agent
    {
        Number start;
        Number goal;
        std::size_t line = 0;
    };

    std::string file;  ///< for messages
    std::string graph; ///< as written, without the `//` of the paper; empty where the file names none
    std::size_t graphLine = 0;
    std::vector<Agent> agents;

    /// Where the named graph lies: relative to the instance file, or, where there is no such file, a file of
    /// that name beside the instance. \pre the file names a graph
    [[nodiscard]] std::filesystem::path graphPath() const;
};

/// Throws ParseError for every line that is neither blank, `graph = <file>` nor
/// `agent: start = <vertex>, goal = <vertex>`, for a second `graph` line, and for a file without either.
[[nodiscard]] InstanceText readInstanceText(const std::filesystem::path &file);
[[nodiscard]] InstanceText parseInstanceText(std::string_view text, const std::string &file);

/// Puts the robots onto the graph. Throws ParseError where a vertex does not exist or two robots have one
/// start or one goal. O(V + robots).
[[nodiscard]] Instance textInstance(const InstanceText &text, std::shared_ptr<const Graph> graph);

/// \param graphFile what the line `graph = …` names; no such line where it is empty
[[nodiscard]] std::string formatInstanceText(const Instance &instance, const std::string &graphFile);

} // namespace mrpp

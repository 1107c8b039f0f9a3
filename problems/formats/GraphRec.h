#pragma once
/// \file
/// Animations for GraphRec (P. Koupý, 2010, https://www.koupy.net/graphrec.php), in its text form
/// "Multirobot (*.txt)" and its own XML.
///
/// Written files count robots and vertices from 1, draw y downwards, and have some 60 units between
/// neighbours, which looks right. In the text, a goal is the second and third number in a vertex's brackets,
/// which GraphRec itself does not show; the XML carries no goals.

#include "framework/model/Instance.h"
#include "framework/model/MotionRule.h"
#include "framework/model/Schedule.h"
#include "problems/formats/SolutionRows.h"

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace mrpp
{

enum class GraphRecForm
{
    text,
    xml,
};

/// Takes the pieces of a file one by one.
using TextSink = std::function<void(std::string_view)>;

/// Writes in pieces, so that the moves need no memory. Steps in which nobody moves are left out, as GraphRec
/// needs steps without gaps. Without coordinates GraphRec lays the graph out itself. Under `pebble` and
/// `parallel` GraphRec is told that vertices must be empty before they are entered (its IMMEDIATE, "Pebble"),
/// under the other rules that robots may follow each other (TRANSITIVE, "Multirobot").
/// \pre the schedule is legal on the instance under the rule
/// O(V + E + moves) time, O(V + E) memory.
void writeGraphRec(const Instance &instance, const Schedule &schedule, MotionRule rule, GraphRecForm form,
                   const TextSink &sink);

/// The same as one string.
[[nodiscard]] std::string formatGraphRec(const Instance &instance, const Schedule &schedule,
                                         MotionRule rule = MotionRule::rotation,
                                         GraphRecForm form = GraphRecForm::text);

/// What a GraphRec file says. Vertices are numbered in the order of their lines, robots in the order of their
/// numbers in the file.
struct GraphRecFile
{
    struct TimedEdge
    {
        std::int64_t step = 0;
        Vertex from = 0;
        Vertex to = 0;
        std::uint32_t line = 0;
    };

    std::string file; ///< for messages
    std::shared_ptr<const Graph> graph;
    std::vector<Vertex> starts;
    std::vector<Vertex> goals; ///< empty where the file does not say them for all robots
    std::vector<TimedEdge> moves;
    std::vector<std::string> warnings;
};

/// Throws ParseError where a line that looks like a vertex, edge, move or position breaks the grammar, a
/// vertex or robot is there twice, a vertex is not there at all, a second graph begins, or the line `Length:`
/// is missing. Lines that mean nothing to GraphRec mean nothing here. O(file).
[[nodiscard]] GraphRecFile parseGraphRec(std::string_view text, const std::string &file);

/// The same for the XML. Throws ParseError for what is no GraphRec file of one solution.
[[nodiscard]] GraphRecFile parseGraphRecXml(std::string_view text, const std::string &file);

/// Says which robots make the moves, from the instance's starts on. Throws ParseError where the instance has
/// another number of vertices, or a move begins where nobody stands. O(V + moves).
[[nodiscard]] SolutionRows graphRecRows(const GraphRecFile &file, const Instance &instance);

} // namespace mrpp

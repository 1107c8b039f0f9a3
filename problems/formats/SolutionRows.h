#pragma once
/// \file
/// Answers as files from outside give them: rows of moves about whose numbers nothing is known yet.
/// Whether they make sense is the validator's business.

#include "framework/evaluation/Validator.h"
#include "framework/model/Schedule.h"

#include <cstdint>
#include <string>
#include <vector>

namespace mrpp
{

struct SolutionRows
{
    std::string file; ///< for messages
    std::vector<TimedMove> moves;
    std::vector<std::uint32_t> lines; ///< of the moves; empty where the first is line 2, and each has its own

    std::vector<std::string> warnings;

    /// The line of a row, for messages about moves that break the rules.
    [[nodiscard]] std::size_t lineOf(std::size_t row) const { return lines.empty() ? row + 2 : lines[row]; }
};

/// Where a robot is said to stand, and in which line.
struct PathPoint
{
    Vertex vertex = 0;
    std::uint32_t line = 0;
};

/// Rows of paths that say where each robot stands at the times 0, 1, 2, …; a robot stays where its path ends.
/// Times at which nobody moves leave no gap. Throws ParseError where there are more or fewer paths than
/// robots, or a path begins elsewhere than its robot. O(moves · log robots + points).
[[nodiscard]] SolutionRows rowsOfPaths(const std::string &file, const Instance &instance,
                                       const std::vector<std::vector<PathPoint>> &paths);

/// Where a robot is said to stand from a time on, after a move to it at that time.
struct Stay
{
    std::int64_t time = 0;
    Vertex vertex = 0;
    std::uint32_t line = 0;
};

/// Rows of paths that say times only where a robot moves (or stays). The first time of each is 0, and they
/// ascend. Times at which nobody moves leave no gap. Throws as rowsOfPaths() does. O(stays · log stays).
[[nodiscard]] SolutionRows rowsOfStays(const std::string &file, const Instance &instance,
                                       const std::vector<std::vector<Stay>> &paths);

/// The rows as steps, whatever rules they break; a gap between steps is none. \pre robots and vertices fit
/// into 32 bits. O(rows)
[[nodiscard]] Schedule stepsOf(const SolutionRows &rows);

/// The rows as a schedule. Throws ParseError at the first move that no motion rule allows. O(V + rows).
[[nodiscard]] Schedule scheduleOf(const SolutionRows &rows, const Instance &instance);

/// Where every robot stands at the times 0 … makespan: calls `visit(positions)` for each.
template <class Visitor>
void forEachTime(const Instance &instance, const Schedule &schedule, Visitor &&visit)
{
    std::vector<Vertex> positions = instance.starts;
    visit(positions);
    for (std::size_t step = 0; step < schedule.makespan(); ++step)
    {
        for (const Move &move : schedule.step(step))
            positions[move.robot] = move.to;
        visit(positions);
    }
}

} // namespace mrpp

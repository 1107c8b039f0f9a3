#pragma once
/// \file
/// Checks animations by the grammar and the rules that GraphRec goes by, line by line. Shares no code with
/// the writer or the readers.

#include <map>
#include <string>

namespace mrpp
{

struct CheckedAnimation
{
    std::string complaint;      ///< the first thing that GraphRec would not play; empty where all is well
    std::map<int, int> robotAt; ///< at the end: the robot on each vertex that is not empty
    std::size_t moves = 0;
    std::size_t steps = 0;
};

[[nodiscard]] CheckedAnimation checkGraphRecText(const std::string &text);

} // namespace mrpp

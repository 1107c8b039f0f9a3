#pragma once
/// \file
/// Instances and results of K. Okumura's programs (mapf-IR, pibt2, lacam): robots on the cells of a map.
///
/// \code
/// map_file=room.map          agents=1
/// agents=1                   map_file=room.map
/// random_problem=0           solved=1
/// 0,0,2,1                    solution=
///                            0:(0,0),
///                            1:(1,0),
/// \endcode
///
/// On the left an instance: `key=value` lines, then a start and a goal a line, column before row. On the
/// right a result: where every robot stands at the times 0, 1, 2, ….

#include "framework/model/Instance.h"
#include "framework/model/Schedule.h"
#include "problems/formats/MovingAiMap.h"
#include "problems/formats/SolutionRows.h"

#include <string>
#include <string_view>
#include <vector>

namespace mrpp
{

struct Kei18Instance
{
    struct Number
    {
        std::int64_t value = 0;
        std::size_t column = 0;
    };
    struct Agent
    {
        Number startX;
        Number startY;
        Number goalX;
        Number goalY;
        std::size_t line = 0;
    };

    std::string file; ///< for messages
    std::string map;  ///< as the file names it; empty where it does not
    std::vector<Agent> agents;
};

/// The robots are the first `agents=` lines. Throws ParseError where a line breaks the grammar, a key is not
/// known, there are fewer lines than robots, or the robots are left to a random generator
/// (`random_problem=1`): they would be others in every program.
[[nodiscard]] Kei18Instance parseKei18Instance(std::string_view text, const std::string &file);

/// Puts the robots onto the map. Throws ParseError where a cell is outside or an obstacle, or two robots have
/// one start or one goal.
[[nodiscard]] Instance kei18Instance(const Kei18Instance &text, const GridMap &map);

/// Without limits and seed: whoever runs a program sets them.
/// \param mapName what the line `map_file=` names
/// Throws InputError where the graph does not lie on cells.
[[nodiscard]] std::string formatKei18Instance(const Instance &instance, const std::string &mapName);

/// Reads the lines `time:(x,y),…` of a result. Throws ParseError where a line breaks the grammar, times are
/// not 0, 1, 2, …, or a robot stands on no vertex, NoSolution where it says solved=0.
[[nodiscard]] SolutionRows parseKei18Result(std::string_view text, const std::string &file,
                                            const Instance &instance);

/// Throws InputError where the graph does not lie on cells.
[[nodiscard]] std::string formatKei18Result(const Instance &instance, const Schedule &schedule,
                                            const std::string &mapName);

} // namespace mrpp

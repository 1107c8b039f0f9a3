#include "problems/formats/support/Directions.h"

#include "framework/support/Error.h"

namespace mrpp
{

std::vector<std::string> directionsOf(const Instance &instance, const Schedule &schedule, const Cells &cells)
{
    std::vector<std::string> result(instance.robotCount());
    for (std::size_t step = 0; step < schedule.makespan(); ++step)
        for (const Move &move : schedule.step(step))
        {
            const auto [fromX, fromY] = cells.cellOf(move.from);
            const auto [toX, toY] = cells.cellOf(move.to);
            char letter = 0;
            if (fromY == toY)
                letter = toX == fromX + 1 ? 'r' : fromX == toX + 1 ? 'l' : letter;
            else if (fromX == toX)
                letter = toY == fromY + 1 ? 'd' : fromY == toY + 1 ? 'u' : letter;
            if (letter == 0)
                throw InputError("robot " + std::to_string(move.robot) + " goes from the cell " +
                                 cellName(fromX, fromY) + " to " + cellName(toX, toY) +
                                 ", but this format knows moves to a cell beside only");
            result[move.robot].resize(step, 'w');
            result[move.robot] += letter;
        }
    return result;
}

} // namespace mrpp

#include "framework/store/SolutionCodec.h"

#include "framework/support/Bytes.h"

#include <unordered_map>

namespace mrpp
{

namespace
{

constexpr std::uint8_t kFormat = 1;

/// Where each robot went last, which is where its next move begins.
using Places = std::unordered_map<Robot, Vertex>;

} // namespace

std::vector<std::uint8_t> packSolution(const Solution &solution)
{
    ByteWriter writer;
    writer.byte(kFormat);
    writer.number(solution.pathLength());
    writer.number(solution.rotations().size());
    std::size_t end = 0;
    for (const Solution::Rotation &rotation : solution.rotations())
    {
        writer.number(rotation.first - end);
        writer.number(rotation.size);
        end = rotation.first + rotation.size;
    }
    Places places;
    Robot robot = 0;
    for (const Move &move : solution.moves())
    {
        Vertex &place = places[move.robot];
        writer.difference(move.robot, robot);
        writer.difference(move.from, place);
        writer.difference(move.to, move.from);
        robot = move.robot;
        place = move.to;
    }
    return writer.take();
}

std::optional<Solution> unpackSolution(std::span<const std::uint8_t> bytes)
{
    constexpr std::size_t kLeastBytesAMove = 3;
    constexpr std::size_t kLeastBytesARotation = 2;
    if (bytes.empty() || bytes.front() != kFormat)
        return std::nullopt;
    ByteReader reader(bytes.subspan(1));
    const std::uint64_t moveCount = reader.number();
    const std::uint64_t rotationCount = reader.number();
    if (moveCount > reader.left() / kLeastBytesAMove || rotationCount > reader.left() / kLeastBytesARotation)
        return std::nullopt;

    std::vector<Solution::Rotation> rotations(rotationCount);
    std::size_t end = 0;
    for (Solution::Rotation &rotation : rotations)
    {
        const std::uint64_t gap = reader.number();
        rotation.size = reader.number();
        if (!reader.good() || gap > moveCount - end || rotation.size < 2 ||
            rotation.size > moveCount - end - gap)
            return std::nullopt;
        rotation.first = end + gap;
        end = rotation.first + rotation.size;
    }
    std::vector<Move> moves(moveCount);
    Places places;
    Robot robot = 0;
    for (Move &move : moves)
    {
        robot = move.robot = reader.difference(robot);
        Vertex &place = places[robot];
        move.from = reader.difference(place);
        place = move.to = reader.difference(move.from);
    }
    if (!reader.good() || reader.left() != 0)
        return std::nullopt;
    return Solution(std::move(moves), std::move(rotations));
}

} // namespace mrpp

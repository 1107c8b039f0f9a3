#include "framework/campaign/SolutionCodec.h"

#include <unordered_map>

namespace mrpp
{

namespace
{

constexpr std::uint8_t kFormat = 1;
constexpr unsigned kPayloadBits = 7;
constexpr std::uint8_t kMore = 0x80; // another byte follows

class Writer
{
public:
    void number(std::uint64_t value)
    {
        for (; value >= kMore; value >>= kPayloadBits)
            bytes.push_back(static_cast<std::uint8_t>(value) | kMore);
        bytes.push_back(static_cast<std::uint8_t>(value));
    }

    /// The difference modulo 2³², small in both directions (zigzag).
    void difference(std::uint32_t value, std::uint32_t expected)
    {
        const std::uint32_t delta = value - expected;
        number((delta << 1) ^ (0 - (delta >> 31)));
    }

    std::vector<std::uint8_t> bytes;
};

class Reader
{
public:
    explicit Reader(std::span<const std::uint8_t> bytes) : rest_(bytes) {}

    std::uint64_t number()
    {
        std::uint64_t value = 0;
        for (unsigned shift = 0; shift < 64; shift += kPayloadBits)
        {
            if (rest_.empty())
                break;
            const std::uint8_t byte = rest_.front();
            rest_ = rest_.subspan(1);
            value |= static_cast<std::uint64_t>(byte & ~kMore) << shift;
            if ((byte & kMore) == 0)
                return value;
        }
        good_ = false;
        return 0;
    }

    std::uint32_t difference(std::uint32_t expected)
    {
        const std::uint64_t zigzag = number();
        good_ = good_ && zigzag <= 0xffffffffU;
        const auto code = static_cast<std::uint32_t>(zigzag);
        return expected + ((code >> 1) ^ (0 - (code & 1U)));
    }

    [[nodiscard]] bool good() const { return good_; }
    [[nodiscard]] std::size_t left() const { return rest_.size(); }

private:
    std::span<const std::uint8_t> rest_;
    bool good_ = true;
};

/// Where each robot went last, which is where its next move begins.
using Places = std::unordered_map<Robot, Vertex>;

} // namespace

std::vector<std::uint8_t> packSolution(const Solution &solution)
{
    Writer writer;
    writer.bytes.push_back(kFormat);
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
    return std::move(writer.bytes);
}

std::optional<Solution> unpackSolution(std::span<const std::uint8_t> bytes)
{
    constexpr std::size_t kLeastBytesAMove = 3;
    constexpr std::size_t kLeastBytesARotation = 2;
    if (bytes.empty() || bytes.front() != kFormat)
        return std::nullopt;
    Reader reader(bytes.subspan(1));
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

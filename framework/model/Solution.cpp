#include "framework/model/Solution.h"

#include "framework/support/Fingerprint.h"

namespace mrpp
{

Solution::Solution(std::vector<Move> moves, std::vector<Rotation> rotations)
    : moves_(std::move(moves)), rotations_(std::move(rotations))
{
#ifndef NDEBUG
    std::size_t end = 0;
    for (const Rotation &rotation : rotations_)
    {
        assert(rotation.first >= end && rotation.size >= 2);
        end = rotation.first + rotation.size;
    }
    assert(end <= moves_.size());
#endif
}

void Solution::appendRotation(std::span<const Move> moves)
{
    assert(moves.size() >= 2);
    rotations_.push_back({moves_.size(), moves.size()});
    moves_.insert(moves_.end(), moves.begin(), moves.end());
}

void Solution::truncate(std::size_t pathLength)
{
    assert(pathLength <= moves_.size());
    moves_.resize(pathLength);
    while (!rotations_.empty() && rotations_.back().first >= pathLength)
        rotations_.pop_back();
    assert(rotations_.empty() || rotations_.back().first + rotations_.back().size <= pathLength);
}

std::size_t Solution::actionCount() const
{
    std::size_t count = moves_.size();
    for (const Rotation &rotation : rotations_)
        count -= rotation.size - 1;
    return count;
}

std::string Solution::fingerprint() const
{
    static_assert(sizeof(Move) == 3 * sizeof(std::uint32_t));
    Fingerprint hash;
    hash.add(std::span(reinterpret_cast<const std::uint32_t *>(moves_.data()), 3 * moves_.size()));
    for (const Rotation &rotation : rotations_)
        hash.add(static_cast<std::uint64_t>(rotation.first)).add(static_cast<std::uint64_t>(rotation.size));
    return hash.hex();
}

std::vector<Move> Solution::releaseMoves() &&
{
    rotations_.clear();
    return std::move(moves_);
}

} // namespace mrpp

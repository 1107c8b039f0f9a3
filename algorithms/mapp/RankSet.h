#pragma once
/// \file
/// A set of ranks that is walked through in order while it changes.

#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace mrpp::mapp
{

class RankSet
{
public:
    explicit RankSet(std::size_t size) : words_((size + 63) / 64, 0), size_(size) {}

    void insert(std::size_t rank) { words_[rank / 64] |= std::uint64_t{1} << rank % 64; }
    void erase(std::size_t rank) { words_[rank / 64] &= ~(std::uint64_t{1} << rank % 64); }

    /// The smallest element from `rank` on; size where there is none. O(size / 64).
    [[nodiscard]] std::size_t next(std::size_t rank) const
    {
        if (rank >= size_)
            return size_;
        std::size_t word = rank / 64;
        std::uint64_t bits = words_[word] >> rank % 64 << rank % 64;
        while (bits == 0)
        {
            if (++word == words_.size())
                return size_;
            bits = words_[word];
        }
        return word * 64 + static_cast<std::size_t>(std::countr_zero(bits));
    }

private:
    std::vector<std::uint64_t> words_;
    std::size_t size_;
};

} // namespace mrpp::mapp

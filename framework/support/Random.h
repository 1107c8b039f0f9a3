#pragma once
/// \file
/// Random numbers whose sequence depends on the seed alone, never on the standard library: the same seed
/// gives the same graphs, instances and solutions on every machine. (`std::uniform_int_distribution` and
/// `std::shuffle` promise no such thing.)
///
/// \code
/// Random random(deriveSeed(campaignSeed, "graph", 3));
/// random.shuffle(std::span(vertices));
/// \endcode
///
/// Generator: xoshiro256** of D. Blackman and S. Vigna, "Scrambled linear pseudorandom number generators",
/// ACM TOMS 47(4), 2021, seeded by SplitMix64. Bounded numbers: D. Lemire, "Fast random integer generation in
/// an interval", ACM TOMACS 29(1), 2019.

#include "framework/support/Fingerprint.h"

#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <utility>

namespace mrpp
{

using Seed = std::uint64_t;

/// A seed that depends on every one of the parts (strings or integers) and on nothing else. 63 bits, so that
/// every database and language reads it back as a whole number.
template <class... Parts>
[[nodiscard]] Seed deriveSeed(Seed seed, const Parts &...parts)
{
    Fingerprint hash;
    hash.add(seed);
    [[maybe_unused]] const auto addPart = [&hash](const auto &part)
    {
        if constexpr (std::is_convertible_v<decltype(part), std::string_view>)
            hash.add(std::string_view(part));
        else
            hash.add(static_cast<std::uint64_t>(part));
    };
    (addPart(parts), ...);
    return hash.bits() >> 1;
}

/// A small, fast generator; copy it to fork a sequence.
class Random
{
public:
    explicit Random(Seed seed)
    {
        for (std::uint64_t &word : state_)
        {
            seed += 0x9e3779b97f4a7c15U;
            std::uint64_t z = seed;
            z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
            z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
            word = z ^ (z >> 31);
        }
    }

    /// 64 random bits.
    std::uint64_t bits()
    {
        const std::uint64_t result = rotateLeft(state_[1] * 5, 7) * 9;
        const std::uint64_t t = state_[1] << 17;
        state_[2] ^= state_[0];
        state_[3] ^= state_[1];
        state_[1] ^= state_[2];
        state_[0] ^= state_[3];
        state_[2] ^= t;
        state_[3] = rotateLeft(state_[3], 45);
        return result;
    }

    /// Uniform in 0 … bound−1, without bias; bound ≥ 1.
    std::uint64_t below(std::uint64_t bound)
    {
        __extension__ using Wide = unsigned __int128;
        Wide product = static_cast<Wide>(bits()) * bound;
        if (static_cast<std::uint64_t>(product) < bound)
        {
            const std::uint64_t threshold = (0 - bound) % bound;
            while (static_cast<std::uint64_t>(product) < threshold)
                product = static_cast<Wide>(bits()) * bound;
        }
        return static_cast<std::uint64_t>(product >> 64);
    }

    /// Uniform in [0, 1), 53 random bits.
    double uniform() { return static_cast<double>(bits() >> 11) * 0x1.0p-53; }

    /// Fisher–Yates from the front: the first k elements of the result depend on the first k draws only, so
    /// that a smaller sample is a prefix of a larger one.
    template <class T>
    void shuffle(std::span<T> items)
    {
        shuffleFront(items, items.size());
    }

    /// Moves `count` random elements to the front, as shuffle() would. O(count).
    template <class T>
    void shuffleFront(std::span<T> items, std::size_t count)
    {
        for (std::size_t i = 0; i < count && i + 1 < items.size(); ++i)
            std::swap(items[i], items[i + below(items.size() - i)]);
    }

private:
    static std::uint64_t rotateLeft(std::uint64_t x, int k) { return (x << k) | (x >> (64 - k)); }

    std::array<std::uint64_t, 4> state_{};
};

} // namespace mrpp

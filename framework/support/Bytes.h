#pragma once
/// \file
/// Numbers and texts as bytes and back: variable-length integers, the same on every machine. Reading never
/// goes beyond the end: what is damaged reads as zeros, and good() says so.

#include <bit>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace mrpp
{

class ByteWriter
{
public:
    void byte(std::uint8_t value) { bytes_.push_back(value); }

    /// 1 to 10 bytes, few for small numbers.
    void number(std::uint64_t value)
    {
        constexpr std::uint8_t kMore = 0x80; // another byte follows
        for (; value >= kMore; value >>= 7)
            byte(static_cast<std::uint8_t>(value) | kMore);
        byte(static_cast<std::uint8_t>(value));
    }

    /// How far a value is from another, modulo 2³²: small in both directions (zigzag).
    void difference(std::uint32_t value, std::uint32_t expected)
    {
        const std::uint32_t delta = value - expected;
        number((delta << 1) ^ (0 - (delta >> 31)));
    }

    /// Eight bytes, every bit kept.
    void real(double value)
    {
        const auto bits = std::bit_cast<std::uint64_t>(value);
        for (int shift = 0; shift < 64; shift += 8)
            byte(static_cast<std::uint8_t>(bits >> shift));
    }

    void text(std::string_view value)
    {
        number(value.size());
        bytes_.insert(bytes_.end(), value.begin(), value.end());
    }

    void block(std::span<const std::uint8_t> value)
    {
        number(value.size());
        bytes_.insert(bytes_.end(), value.begin(), value.end());
    }

    /// Gives the bytes away.
    [[nodiscard]] std::vector<std::uint8_t> take() { return std::move(bytes_); }

private:
    std::vector<std::uint8_t> bytes_;
};

/// Reads what ByteWriter wrote; the bytes must outlive it.
class ByteReader
{
public:
    explicit ByteReader(std::span<const std::uint8_t> bytes) : rest_(bytes) {}

    std::uint8_t byte()
    {
        if (rest_.empty())
        {
            good_ = false;
            return 0;
        }
        const std::uint8_t value = rest_.front();
        rest_ = rest_.subspan(1);
        return value;
    }

    std::uint64_t number()
    {
        std::uint64_t value = 0;
        for (unsigned shift = 0; shift < 64 && good_; shift += 7)
        {
            const std::uint8_t next = byte();
            value |= static_cast<std::uint64_t>(next & 0x7fU) << shift;
            if ((next & 0x80U) == 0)
                return value;
        }
        good_ = false;
        return 0;
    }

    /// Whatever the bytes are, the result is some 32-bit number.
    std::uint32_t difference(std::uint32_t expected)
    {
        const auto code = static_cast<std::uint32_t>(number());
        return expected + ((code >> 1) ^ (0 - (code & 1U)));
    }

    double real()
    {
        std::uint64_t bits = 0;
        for (int shift = 0; shift < 64; shift += 8)
            bits |= static_cast<std::uint64_t>(byte()) << shift;
        return std::bit_cast<double>(bits);
    }

    std::span<const std::uint8_t> block()
    {
        const std::uint64_t size = number();
        good_ = good_ && size <= rest_.size();
        if (!good_)
            return {};
        const auto value = rest_.first(size);
        rest_ = rest_.subspan(size);
        return value;
    }

    std::string text()
    {
        const auto value = block();
        return {value.begin(), value.end()};
    }

    /// False once something was not there.
    [[nodiscard]] bool good() const { return good_; }
    [[nodiscard]] std::size_t left() const { return rest_.size(); }

private:
    std::span<const std::uint8_t> rest_;
    bool good_ = true;
};

} // namespace mrpp

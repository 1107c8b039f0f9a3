#pragma once
/// \file
/// Content fingerprints (SHA-256): of graphs, instances, solutions and runs. The same contents have the same
/// fingerprint on every machine, so that results are kept when nothing changed and run again when something
/// did.

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>

namespace mrpp
{

/// Collects values and hashes them in order. Strings are length-prefixed and numbers little-endian, so that
/// different sequences of values of the same types never collide by concatenation.
class Fingerprint
{
public:
    Fingerprint();
    ~Fingerprint();
    Fingerprint(Fingerprint &&) noexcept;
    Fingerprint &operator=(Fingerprint &&) noexcept;

    Fingerprint &add(std::string_view text);
    Fingerprint &add(std::uint64_t number);
    Fingerprint &add(double number);
    Fingerprint &add(std::span<const std::uint32_t> numbers);

    /// 32 hexadecimal digits (the first 128 bits). The object is spent afterwards.
    [[nodiscard]] std::string hex();

    /// The first 64 bits. The object is spent afterwards.
    [[nodiscard]] std::uint64_t bits();

private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace mrpp

#pragma once
/// \file
/// Which runs are finished, and how they ended: small and fast for millions of them.

#include "framework/PlannerStatus.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <string_view>
#include <unordered_map>

namespace mrpp
{

class FinishedRuns
{
public:
    void reserve(std::size_t count) { runs_.reserve(count); }
    void add(std::string_view runKey, PlannerStatus status) { runs_.emplace(digest(runKey), status); }
    [[nodiscard]] std::size_t size() const { return runs_.size(); }

    [[nodiscard]] bool contains(std::string_view runKey) const { return runs_.contains(digest(runKey)); }

    /// Nothing where the run is not finished.
    [[nodiscard]] std::optional<PlannerStatus> status(std::string_view runKey) const
    {
        const auto found = runs_.find(digest(runKey));
        return found == runs_.end() ? std::nullopt : std::optional(found->second);
    }

private:
    /// A key's 128 bits; keys that are not made of 32 hexadecimal digits keep apart as well as their hashes
    /// do.
    struct Digest
    {
        std::uint64_t high = 0;
        std::uint64_t low = 0;
        bool operator==(const Digest &) const = default;
    };
    struct Hash
    {
        std::size_t operator()(const Digest &digest) const { return digest.low; }
    };

    static Digest digest(std::string_view key)
    {
        constexpr std::size_t kDigits = 16;
        Digest digest{number(key.substr(0, kDigits)), 0};
        if (key.size() == 2 * kDigits)
            digest.low = number(key.substr(kDigits));
        else
            digest = {key.size(), std::hash<std::string_view>()(key)};
        return digest;
    }

    static std::uint64_t number(std::string_view digits)
    {
        std::uint64_t value = 0;
        for (const char c : digits)
            value = value << 4U | static_cast<std::uint64_t>(c <= '9' ? c - '0' : c - 'a' + 10);
        return value;
    }

    std::unordered_map<Digest, PlannerStatus, Hash> runs_;
};

} // namespace mrpp

#pragma once
/// \file
/// Something for each of many runs, by key: small and fast for millions of them.

#include <cstdint>
#include <functional>
#include <string_view>
#include <unordered_map>

namespace mrpp
{

template <class T>
class RunKeyMap
{
public:
    void reserve(std::size_t count) { values_.reserve(count); }
    /// The newest value of a key counts.
    void set(std::string_view key, T value) { values_.insert_or_assign(digest(key), value); }
    [[nodiscard]] std::size_t size() const { return values_.size(); }
    [[nodiscard]] bool contains(std::string_view key) const { return find(key) != nullptr; }

    /// Null where there is none.
    [[nodiscard]] const T *find(std::string_view key) const
    {
        const auto found = values_.find(digest(key));
        return found == values_.end() ? nullptr : &found->second;
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
        if (key.size() == 2 * kDigits)
            return {number(key.substr(0, kDigits)), number(key.substr(kDigits))};
        return {key.size(), std::hash<std::string_view>()(key)};
    }

    static std::uint64_t number(std::string_view digits)
    {
        std::uint64_t value = 0;
        for (const char c : digits)
            value = value << 4U | static_cast<std::uint64_t>(c <= '9' ? c - '0' : c - 'a' + 10);
        return value;
    }

    std::unordered_map<Digest, T, Hash> values_;
};

} // namespace mrpp

#include "framework/support/Config.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>

namespace mrpp
{

Config Config::scalar(std::string text, SourceLocation where)
{
    Config node;
    node.kind_ = Kind::scalar;
    node.text_ = std::move(text);
    node.where_ = std::move(where);
    return node;
}

Config Config::list(std::vector<Config> items, SourceLocation where)
{
    Config node;
    node.kind_ = Kind::list;
    node.items_ = std::move(items);
    node.where_ = std::move(where);
    return node;
}

Config Config::map(std::vector<Entry> entries, SourceLocation where)
{
    Config node;
    node.kind_ = Kind::map;
    node.entries_ = std::move(entries);
    node.where_ = std::move(where);
    return node;
}

const Config *Config::find(std::string_view key) const
{
    for (const Entry &entry : entries_)
        if (entry.key == key)
            return &entry.value;
    return nullptr;
}

double Config::number() const
{
    const auto value = isScalar() ? parseNumber(text_) : std::nullopt;
    if (!value)
        throw PlanError(where_, isScalar() ? "'" + text_ + "' is not a number" : "expected a number");
    return *value;
}

std::int64_t Config::integer() const
{
    const auto value = isScalar() ? parseInteger(text_) : std::nullopt;
    if (!value)
        throw PlanError(where_,
                        isScalar() ? "'" + text_ + "' is not a whole number" : "expected a whole number");
    return *value;
}

namespace
{
/// 5, 5.0 and +5 are one setting; 9007199254740993, which no floating-point number is, stays itself.
std::string canonicalText(const std::string &text)
{
    constexpr std::int64_t kExact = std::int64_t{1} << 53;
    if (const auto whole = parseInteger(text); whole && (*whole > kExact || *whole < -kExact))
        return std::to_string(*whole);
    const auto number = parseNumber(text);
    return number ? formatNumber(*number) : text;
}

nlohmann::json toJson(const Config &node)
{
    switch (node.kind())
    {
    case Config::Kind::empty:
        return nullptr;
    case Config::Kind::scalar:
        return canonicalText(node.text());
    case Config::Kind::list: {
        nlohmann::json items = nlohmann::json::array();
        for (const Config &item : node.items())
            items.push_back(toJson(item));
        return items;
    }
    case Config::Kind::map: {
        nlohmann::json entries = nlohmann::json::object();
        for (const Config::Entry &entry : node.entries())
            entries[entry.key] = toJson(entry.value);
        return entries;
    }
    }
    return nullptr;
}
} // namespace

std::string Config::canonical() const
{
    return toJson(*this).dump(-1, ' ', true, nlohmann::json::error_handler_t::replace);
}

namespace
{
/// Without the plus that from_chars does not know.
std::string_view withoutPlus(std::string_view text)
{
    const bool plus = text.size() > 1 && text[0] == '+' && text[1] != '-';
    return text.substr(plus ? 1 : 0);
}

template <class Number>
std::optional<Number> parseWhole(std::string_view text)
{
    text = withoutPlus(text);
    Number value{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size())
        return std::nullopt;
    return value;
}
} // namespace

std::optional<double> parseNumber(std::string_view text)
{
    const auto value = parseWhole<double>(text);
    return value && std::isfinite(*value) ? value : std::nullopt;
}

std::optional<std::int64_t> parseInteger(std::string_view text)
{
    return parseWhole<std::int64_t>(text);
}

std::string formatNumber(double value)
{
    if (value == std::floor(value) && std::abs(value) < 1e15)
        return std::to_string(static_cast<std::int64_t>(value));
    std::array<char, 40> buffer{};
    const auto [end, error] = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
    return std::string(buffer.data(), error == std::errc() ? end : buffer.data());
}

} // namespace mrpp

#include "framework/support/ReadableText.h"

#include <algorithm>
#include <cstdint>
#include <fmt/core.h>

namespace mrpp
{

namespace
{

bool continues(char c)
{
    return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U;
}

/// Of a well-formed sequence.
std::uint32_t codePoint(std::string_view sequence)
{
    if (sequence.size() == 1)
        return static_cast<unsigned char>(sequence.front());
    std::uint32_t code = static_cast<unsigned char>(sequence.front()) & (0x7FU >> sequence.size());
    for (const char c : sequence.substr(1))
        code = code << 6U | (static_cast<unsigned char>(c) & 0x3FU);
    return code;
}

} // namespace

std::size_t sequenceLength(std::string_view text)
{
    const auto byte = [text](std::size_t i) -> unsigned
    { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U; };
    const auto allContinue = [byte](std::size_t to)
    {
        for (std::size_t i = 1; i <= to; ++i)
            if ((byte(i) & 0xC0U) != 0x80U)
                return false;
        return true;
    };
    const unsigned first = byte(0);
    const unsigned second = byte(1);
    if (first < 0x80)
        return 1;
    if (first >= 0xC2 && first <= 0xDF)
        return allContinue(1) ? 2 : 0;
    if (first >= 0xE0 && first <= 0xEF)
    {
        const bool overlong = first == 0xE0 && second < 0xA0;
        const bool surrogate = first == 0xED && second >= 0xA0;
        return allContinue(2) && !overlong && !surrogate ? 3 : 0;
    }
    if (first >= 0xF0 && first <= 0xF4)
    {
        const bool overlong = first == 0xF0 && second < 0x90;
        const bool outside = first == 0xF4 && second >= 0x90;
        return allContinue(3) && !overlong && !outside ? 4 : 0;
    }
    return 0;
}

bool isControl(std::string_view text, std::size_t length)
{
    const std::uint32_t code = codePoint(text.substr(0, length));
    const auto lies = [code](std::uint32_t low, std::uint32_t high) { return code >= low && code <= high; };
    return (code < 0x20 && code != '\n' && code != '\t') || lies(0x7F, 0x9F) || code == 0x061C ||
           lies(0x200E, 0x200F) || lies(0x2028, 0x202E) || lies(0x2066, 0x2069);
}

std::string readable(std::string_view text)
{
    std::string shown;
    shown.reserve(text.size());
    while (!text.empty())
    {
        const std::size_t length = sequenceLength(text);
        if (length == 0)
            shown += "\xEF\xBF\xBD";
        else if (text.starts_with("\r\n"))
            shown += "";
        else if (!isControl(text, length))
            shown += text.substr(0, length);
        else if (const std::uint32_t code = codePoint(text.substr(0, length)); code < 0x100)
            shown += fmt::format("\\x{:02X}", code);
        else
            shown += fmt::format("\\u{:04X}", code);
        text.remove_prefix(std::max<std::size_t>(length, 1));
    }
    return shown;
}

std::string oneLine(std::string_view text)
{
    std::string line = readable(text);
    std::replace_if(
        line.begin(), line.end(), [](char c) { return c == '\n' || c == '\t'; }, ' ');
    return line;
}

std::string counted(std::size_t count, std::string_view noun)
{
    if (count == 1)
        return "1 " + std::string(noun);
    std::string plural(noun);
    if (plural.ends_with("vertex"))
        plural.replace(plural.size() - 2, 2, "ices");
    else
        plural += plural.ends_with('s') ? "es" : "s";
    return std::to_string(count) + " " + plural;
}

std::string_view tail(std::string_view text, std::size_t most)
{
    if (text.size() <= most)
        return text;
    text.remove_prefix(text.size() - most);
    constexpr int kMostOfACharacter = 3;
    for (int i = 0; i < kMostOfACharacter && !text.empty() && continues(text.front()); ++i)
        text.remove_prefix(1);
    return text;
}

} // namespace mrpp

#include "reports/drawing/Text.h"

#include "framework/support/ReadableText.h"

#include <algorithm>
#include <cstdint>

namespace mrpp
{

namespace
{

std::string clean(std::string_view text, bool keepLines)
{
    std::string result;
    for (std::size_t i = 0; i < text.size();)
    {
        const std::size_t length = sequenceLength(text.substr(i));
        const char c = text[i];
        const bool isC1Control = length == 2 && c == '\xC2' && static_cast<std::uint8_t>(text[i + 1]) < 0xA0;
        if (length == 0)
            result += "\xEF\xBF\xBD";
        else if (length > 1)
            result += isC1Control ? std::string_view() : text.substr(i, length);
        else if (c == '\n')
            result += keepLines ? '\n' : ' ';
        else if (c == '\t')
            result += keepLines ? "    " : " ";
        else if (c >= ' ' && c != '\x7F')
            result += c;
        i += std::max<std::size_t>(length, 1);
    }
    return result;
}

} // namespace

std::string oneLine(std::string_view text)
{
    return clean(text, false);
}

std::string manyLines(std::string_view text)
{
    return clean(text, true);
}

std::size_t characterCount(std::string_view text)
{
    return static_cast<std::size_t>(
        std::count_if(text.begin(), text.end(), [](char c) { return (c & '\xC0') != '\x80'; }));
}

std::string ellipsize(std::string_view text, std::size_t characters)
{
    if (characterCount(text) <= characters)
        return std::string(text);
    std::size_t bytes = 0;
    for (std::size_t kept = 0; kept + 1 < characters; ++kept)
        do
            ++bytes;
        while (bytes < text.size() && (text[bytes] & '\xC0') == '\x80');
    return std::string(text.substr(0, bytes)) + "…";
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

std::string spaced(std::string_view identifier)
{
    std::string words(identifier);
    std::replace(words.begin(), words.end(), '_', ' ');
    return words;
}

std::string FileNames::add(std::string_view title)
{
    constexpr std::size_t kLongest = 90;
    std::string name;
    for (const char c : title)
    {
        const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                           c == '_' || (c == '.' && !name.empty());
        if (plain)
            name += c;
        else if (!name.empty() && name.back() != '-')
            name += '-';
    }
    name.resize(std::min(name.size(), kLongest));
    while (!name.empty() && (name.back() == '-' || name.back() == '.'))
        name.pop_back();
    if (name.empty())
        name = "unnamed";
    std::string unique = name;
    for (std::size_t copy = 2; !taken_.insert(unique).second; ++copy)
        unique = name + "-" + std::to_string(copy);
    return unique;
}

} // namespace mrpp

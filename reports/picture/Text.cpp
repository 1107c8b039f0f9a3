#include "reports/picture/Text.h"

#include "framework/support/ReadableText.h"

#include <algorithm>

namespace mrpp
{

std::string manyLines(std::string_view text)
{
    std::string lines;
    for (const char c : readable(text))
        lines += c == '\t' ? "    " : std::string(1, c);
    return lines;
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

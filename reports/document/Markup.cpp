#include "reports/document/Markup.h"

#include "reports/picture/Text.h"

#include <array>
#include <cctype>

namespace mrpp
{

std::string latexText(std::string_view text)
{
    std::string result;
    for (const char c : oneLine(text))
        switch (c)
        {
        case '\\':
            result += "\\textbackslash{}";
            break;
        case '~':
            result += "\\textasciitilde{}";
            break;
        case '^':
            result += "\\textasciicircum{}";
            break;
        case '"':
            result += "\\textquotedbl{}";
            break;
        case '\'':
            result += "\\textquotesingle{}";
            break;
        case '`':
            result += "\\textasciigrave{}";
            break;
        case '<':
            result += "\\textless{}";
            break;
        case '>':
            result += "\\textgreater{}";
            break;
        case '|':
            result += "\\textbar{}";
            break;
        case '-':
            result += "{-}"; // two of them would become a dash
            break;
        case '&':
        case '%':
        case '$':
        case '#':
        case '_':
        case '{':
        case '}':
            result += '\\';
            result += c;
            break;
        default:
            result += c;
        }
    return result;
}

std::string markdownText(std::string_view text)
{
    constexpr std::string_view kSpecial = "\\`*_{}[]()#+!|~$";
    std::string result;
    for (const char c : oneLine(text))
    {
        if (c == '<')
            result += "&lt;";
        else if (c == '>')
            result += "&gt;";
        else if (c == '&')
            result += "&amp;";
        else if (c == '@')
            result += "&#64;"; // addresses nobody
        else
        {
            if (kSpecial.find(c) != std::string_view::npos)
                result += '\\';
            result += c;
        }
    }
    return result;
}

std::string latexName(std::string_view text)
{
    constexpr std::array<const char *, 10> kDigits = {"Zero", "One", "Two",   "Three", "Four",
                                                      "Five", "Six", "Seven", "Eight", "Nine"};
    std::string name;
    bool isFirst = true;
    for (const char c : text)
    {
        const auto byte = static_cast<unsigned char>(c);
        if (byte < 0x80 && std::isalpha(byte) != 0)
            name += isFirst ? static_cast<char>(std::toupper(byte)) : c;
        else if (c >= '0' && c <= '9')
            name += kDigits[static_cast<std::size_t>(c - '0')];
        isFirst = byte < 0x80 && std::isalpha(byte) == 0;
    }
    return name.empty() ? "Unnamed" : name;
}

} // namespace mrpp

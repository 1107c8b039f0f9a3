#include "problems/formats/support/TextReader.h"

#include "framework/support/Config.h"

#include <algorithm>

namespace mrpp
{

TextReader::TextReader(std::string_view text, std::string file)
    : rest_(withoutByteOrderMark(text)), file_(std::move(file)), size_(rest_.size())
{}

std::optional<std::string_view> TextReader::next()
{
    if (rest_.empty())
        return std::nullopt;
    ++line_;
    const std::size_t end = rest_.find('\n');
    std::string_view line = rest_.substr(0, end);
    rest_ = end == std::string_view::npos ? std::string_view() : rest_.substr(end + 1);
    if (!line.empty() && line.back() == '\r')
        line.remove_suffix(1);
    return line;
}

void TextReader::fail(std::size_t column, const std::string &what) const
{
    fail(line_, column, what);
}

void TextReader::fail(std::size_t line, std::size_t column, const std::string &what) const
{
    throw ParseError({file_, line, column}, what);
}

void LineCursor::skipBlanks()
{
    while (position_ < line_.size() && (line_[position_] == ' ' || line_[position_] == '\t'))
        ++position_;
}

std::size_t LineCursor::column()
{
    skipBlanks();
    return position_ + 1;
}

bool LineCursor::atEnd()
{
    skipBlanks();
    return position_ == line_.size();
}

bool LineCursor::take(std::string_view text)
{
    skipBlanks();
    if (line_.substr(position_, text.size()) != text)
        return false;
    position_ += text.size();
    return true;
}

char LineCursor::takeCharacter()
{
    skipBlanks();
    return position_ < line_.size() ? line_[position_++] : '\0';
}

std::string_view LineCursor::until(std::string_view stops)
{
    skipBlanks();
    const std::size_t end = std::min(line_.find_first_of(stops, position_), line_.size());
    const std::string_view found = line_.substr(position_, end - position_);
    position_ = end;
    return trimmed(found);
}

std::string_view LineCursor::digits()
{
    skipBlanks();
    const bool hasSign = position_ < line_.size() && (line_[position_] == '-' || line_[position_] == '+');
    const std::size_t first = position_ + (hasSign ? 1 : 0);
    const std::size_t end = std::min(line_.find_first_not_of("0123456789", first), line_.size());
    if (end <= first)
        return {};
    const std::string_view found = line_.substr(position_, end - position_);
    position_ = end;
    return found;
}

void expectText(const TextReader &reader, LineCursor &cursor, std::string_view text, std::string_view form)
{
    if (!cursor.take(text))
        reader.fail(cursor.column(),
                    "expected '" + std::string(text) + "' here, as in '" + std::string(form) + "'");
}

std::int64_t expectInteger(const TextReader &reader, LineCursor &cursor, std::string_view what)
{
    const std::size_t column = cursor.column();
    const std::string_view text = cursor.digits();
    const auto value = parseInteger(text);
    if (!value)
        reader.fail(column, text.empty() ? "expected a whole number here, the " + std::string(what)
                                         : inQuotes(text) + " is too large for a " + std::string(what));
    return *value;
}

double expectNumber(const TextReader &reader, LineCursor &cursor, std::string_view what)
{
    const std::size_t column = cursor.column();
    const std::string_view text = cursor.until(", \t");
    const auto value = parseNumber(text);
    if (!value)
        reader.fail(column, inQuotes(text) + " is no " + std::string(what) + "; expected a number");
    return *value;
}

void expectEnd(const TextReader &reader, LineCursor &cursor, std::string_view form)
{
    if (!cursor.atEnd())
        reader.fail(cursor.column(), "expected the line's end here, as in '" + std::string(form) + "'");
}

std::string_view trimmed(std::string_view text)
{
    constexpr std::string_view blanks = " \t\r\n\v\f";
    const std::size_t first = text.find_first_not_of(blanks);
    if (first == std::string_view::npos)
        return {};
    return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

std::string_view withoutByteOrderMark(std::string_view text)
{
    constexpr std::string_view mark = "\xEF\xBB\xBF";
    return text.substr(0, mark.size()) == mark ? text.substr(mark.size()) : text;
}

std::string inQuotes(std::string_view text)
{
    constexpr std::size_t longest = 40;
    std::string result = "'";
    for (const char c : text.substr(0, longest))
        result += static_cast<unsigned char>(c) < 0x20 || c == 0x7f ? '?' : c;
    if (text.size() <= longest)
        return result + "'";
    while ((static_cast<unsigned char>(result.back()) & 0xC0) == 0x80) // never half a UTF-8 character
        result.pop_back();
    if (static_cast<unsigned char>(result.back()) >= 0xC0)
        result.pop_back();
    return result + "…'";
}

std::string counted(std::size_t count, const char *one, const char *many)
{
    return std::to_string(count) + " " + (count == 1 ? one : many);
}

std::string_view fileNameIn(std::string_view path)
{
    return path.substr(path.find_last_of("/\\") + 1); // npos + 1 is 0
}

} // namespace mrpp

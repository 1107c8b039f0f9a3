#pragma once
/// \file
/// Line by line through a text that somebody else wrote, with places for error messages. Internal to the
/// readers of this folder.

#include "framework/support/Error.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace mrpp
{

/// Lines end with LF or CRLF; the last may lack its end; a byte order mark at the front is skipped. Lines and
/// columns count from 1, columns in bytes.
class TextReader
{
public:
    /// \param text must outlive the reader
    /// \param file the name for messages
    TextReader(std::string_view text, std::string file);

    /// The next line without its end, or nothing at the end of the text. A line end right at the end of the
    /// text starts no further line.
    std::optional<std::string_view> next();

    /// The number of the line that next() gave last; 0 before the first.
    [[nodiscard]] std::size_t line() const { return line_; }

    /// Bytes of the whole text: a bound for what can stand in it.
    [[nodiscard]] std::size_t size() const { return size_; }

    /// Throws ParseError at a column of the current line, or at a place anywhere.
    [[noreturn]] void fail(std::size_t column, const std::string &what) const;
    [[noreturn]] void fail(std::size_t line, std::size_t column, const std::string &what) const;

private:
    std::string_view rest_;
    std::string file_;
    std::size_t size_ = 0;
    std::size_t line_ = 0;
};

/// Walks through one line by its tokens: words, punctuation, numbers. Blanks and tabs between them are free.
class LineCursor
{
public:
    explicit LineCursor(std::string_view line) : line_(line) {}

    /// The column (from 1) of the next character that is no blank.
    [[nodiscard]] std::size_t column();
    [[nodiscard]] bool atEnd();

    /// Takes the text if it is what comes next.
    bool take(std::string_view text);

    /// Takes the next character that is no blank; 0 at the end.
    char takeCharacter();

    /// Everything up to the next character of `stops`, without blanks at its ends.
    [[nodiscard]] std::string_view until(std::string_view stops);

    /// The next run of characters that are no blanks.
    [[nodiscard]] std::string_view word() { return until(" \t"); }

    /// The next run of digits, with a sign in front where there is one; empty where something else comes.
    [[nodiscard]] std::string_view digits();

private:
    void skipBlanks();

    std::string_view line_;
    std::size_t position_ = 0;
};

/// Takes the text. Throws ParseError where something else comes.
/// \param form an example of the whole line, for the message
void expectText(const TextReader &reader, LineCursor &cursor, std::string_view text, std::string_view form);

/// Takes a whole number. Throws ParseError where there is none, or one beyond 64 bits.
[[nodiscard]] std::int64_t expectInteger(const TextReader &reader, LineCursor &cursor, std::string_view what);

/// Takes a number up to the next blank or comma. Throws ParseError where there is none.
[[nodiscard]] double expectNumber(const TextReader &reader, LineCursor &cursor, std::string_view what);

/// Throws ParseError unless the line is at its end.
void expectEnd(const TextReader &reader, LineCursor &cursor, std::string_view form);

/// Without blanks, tabs and line ends at both ends.
[[nodiscard]] std::string_view trimmed(std::string_view text);

/// Without a byte order mark at the front.
[[nodiscard]] std::string_view withoutByteOrderMark(std::string_view text);

/// `'text'`, shortened to fit a message, with what cannot be printed replaced.
[[nodiscard]] std::string inQuotes(std::string_view text);

/// "1 loop is" or "3 loops are", to begin a warning with.
[[nodiscard]] std::string counted(std::size_t count, const char *one, const char *many);

/// The last part of a path of this or another system: behind the last slash or backslash.
[[nodiscard]] std::string_view fileNameIn(std::string_view path);

} // namespace mrpp

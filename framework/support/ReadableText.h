#pragma once
/// \file
/// Text from outside (what programs print, what plugins throw, bytes of files in messages) made fit to be
/// kept and shown: in databases, tables, pages and on terminals.

#include <cstddef>
#include <string>
#include <string_view>

namespace mrpp
{

/// Length in bytes of the well-formed UTF-8 sequence (Unicode 15, table 3-7) at the front; 0 where there is
/// none.
[[nodiscard]] std::size_t sequenceLength(std::string_view text);

/// Whether the character at the front of that length does something instead of showing something: C0 and C1
/// controls and DEL but for line feed and tab, marks that turn the direction of writing, line separators.
[[nodiscard]] bool isControl(std::string_view text, std::size_t length);

/// Valid UTF-8 without control characters: bytes that are no UTF-8 become U+FFFD, CR LF becomes a line feed,
/// control characters are shown: `\x1B`, `\x00`, `\u202E`. Line feeds and tabs stay.
[[nodiscard]] std::string readable(std::string_view text);

/// readable(), with a blank for every line break and tab, so that no name can end its line.
[[nodiscard]] std::string oneLine(std::string_view text);

/// "1 run", "2 runs", "3 vertices".
[[nodiscard]] std::string counted(std::size_t count, std::string_view noun);

/// The last bytes, at most so many, without half a character at their beginning.
[[nodiscard]] std::string_view tail(std::string_view text, std::size_t most);

} // namespace mrpp

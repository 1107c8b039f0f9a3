#pragma once
/// \file
/// Names from a user made fit for pictures and file names.

#include "framework/support/ReadableText.h"

#include <cstddef>
#include <set>
#include <string>
#include <string_view>

namespace mrpp
{

/// readable(), with four blanks for every tab.
[[nodiscard]] std::string manyLines(std::string_view text);

/// Number of code points of valid UTF-8.
[[nodiscard]] std::size_t characterCount(std::string_view text);

/// At most `characters` code points, the last of them "…" where something was cut.
[[nodiscard]] std::string ellipsize(std::string_view text, std::size_t characters);

/// "push_and_swap" as a heading writes it: "push and swap".
[[nodiscard]] std::string spaced(std::string_view identifier);

/// File names without an extension that work everywhere: letters, digits, '-', '_', '.', never empty, at most
/// 100 bytes. A name that was given out before gets a number, so the same sequence of titles always gives
/// the same names.
class FileNames
{
public:
    [[nodiscard]] std::string add(std::string_view title);

private:
    std::set<std::string> taken_;
};

} // namespace mrpp

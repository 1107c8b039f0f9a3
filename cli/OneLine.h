#pragma once
/// \file
/// Names and messages on a terminal.

#include "framework/support/ReadableText.h"

#include <algorithm>
#include <string>

namespace mrpp
{

/// readable(), with a blank for every line break and tab, so that no name can end the line or steer a
/// terminal.
[[nodiscard]] inline std::string oneLine(const std::string &text)
{
    std::string line = readable(text);
    std::replace_if(
        line.begin(), line.end(), [](char c) { return c == '\n' || c == '\t'; }, ' ');
    return line;
}

} // namespace mrpp

#pragma once
/// \file
/// Names and messages on a terminal.

#include <algorithm>
#include <string>

namespace mrpp
{

/// The text with a blank for every control character, so that no name can end the line or steer a terminal.
[[nodiscard]] inline std::string oneLine(std::string text)
{
    std::replace_if(
        text.begin(), text.end(), [](unsigned char c) { return c < 0x20 || c == 0x7F; }, ' ');
    return text;
}

} // namespace mrpp

#pragma once
/// \file
/// What variables and measures are called in headings, on axes and in sentences.

#include <string>
#include <string_view>

namespace mrpp
{

/// "Robots", "Free vertices", …: the title of a swept variable's axis.
[[nodiscard]] std::string variableTitle(const std::string &variable);

/// "Path length" of "path_length": a measure without its unit.
[[nodiscard]] std::string measureName(std::string_view column);

} // namespace mrpp

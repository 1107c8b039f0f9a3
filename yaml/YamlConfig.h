#pragma once
/// \file
/// Strict YAML text in, a Config tree out, every node knowing its file:line:column.
///
/// A plan needs scalars, lists and maps in one document, and nothing else of YAML. What other readers take
/// silently is refused here with its place: a key that stands twice, a second document, anchors, aliases and
/// merge keys (&a, *a, <<), tags (!!str), keys that are not plain words, numbers that some readers take for
/// octal or hexadecimal (010, 0x10), tabs in an indentation, nesting deeper than kMaximalYamlDepth, text that
/// is not UTF-8 or longer than kMaximalYamlSize.

#include "framework/support/Config.h"

#include <string>
#include <string_view>

namespace mrpp
{

inline constexpr std::size_t kMaximalYamlDepth = 32;
inline constexpr std::size_t kMaximalYamlSize = 4 << 20; ///< bytes

/// The document's tree; an empty node where the text holds none. Columns count bytes from 1.
/// \param file for messages
/// Throws PlanError.
[[nodiscard]] Config parseYaml(std::string_view text, const std::string &file);

} // namespace mrpp

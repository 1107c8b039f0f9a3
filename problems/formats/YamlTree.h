#pragma once
/// \file
/// YAML that other programs wrote, as a tree. Internal to the readers of this folder.

#include "framework/support/Config.h"

#include <string>
#include <string_view>

namespace mrpp
{

/// The one document of the text. Places have no file name, to save memory. Tags are skipped (Python's writers
/// add them to tuples). Throws ParseError for what is no YAML, anchors and aliases, keys that are no words or
/// stand twice, a second document, and nesting deeper than any of the formats has.
[[nodiscard]] Config parseYamlTree(std::string_view text, const std::string &file);

} // namespace mrpp

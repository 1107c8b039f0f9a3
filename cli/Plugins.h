#pragma once

#include "framework/Catalog.h"

#include <vector>

namespace mrpp
{

/// Loads what `--plugin FILE` names anywhere among the words, so that every command knows it from the start;
/// returns the other words. Throws InputError where a file is missing or is no plugin.
[[nodiscard]] std::vector<const char *> takePlugins(int count, const char *const *words, Catalog &catalog);

} // namespace mrpp

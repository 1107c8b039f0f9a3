#pragma once

#include "framework/Catalog.h"

#include <filesystem>

namespace mrpp
{

/// Loads a shared library (see Plugin.h) and adds what it brings; a library that is loaded already adds
/// nothing. It stays loaded until the process ends. Throws InputError where the file is no plugin, was built
/// against another version or by another compiler, or brings a name that is taken.
void loadPlugin(Catalog &catalog, const std::filesystem::path &file);

} // namespace mrpp

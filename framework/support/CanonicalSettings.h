#pragma once
/// \file
/// Settings of an object with parameters as one line of text, from which seeds and keys derive.

#include "framework/support/Config.h"
#include "framework/support/Parameters.h"

#include <string>

namespace mrpp
{

/// Whether that parameter is a text or a path, so that "1.10" is not "1.1".
[[nodiscard]] bool takesText(const ParameterSet &parameters, const std::string &name);

/// Config::canonical() of a map, in which texts stay what they are also where they look like numbers.
[[nodiscard]] std::string canonicalSettings(const Config &settings, const ParameterSet &parameters);

} // namespace mrpp

#pragma once
/// \file
/// The explorer's page without its data, as reports/web/ builds it.

#include <string_view>

namespace mrpp
{

/// Has kExplorerData once, where the data go. Empty where the explorer was left out of the build.
[[nodiscard]] std::string_view explorerTemplate();

inline constexpr std::string_view kExplorerData = "<!-- data -->";

} // namespace mrpp

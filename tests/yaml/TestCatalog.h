#pragma once
/// \file
/// A small catalogue for the plan reader's tests: families, planners, an optimizer and reports of every shape
/// that a plan can name.

#include "framework/Catalog.h"

namespace mrpp::test
{

/// `puzzle`: one text parameter, its own robots. `map`: a file and a number of robots. `ladder`: two numbers,
/// robots by count. `growing`: nested settings, varies graphs. Planners `walker` (parameters pace, order) and
/// `runner`; optimizer `shorten` (rounds); reports csv, charts; four formats.
[[nodiscard]] Catalog makeCatalog();

} // namespace mrpp::test

#pragma once
/// \file
/// Damaged files, for tests of readers: whatever happens to a file, it must be read or refused.

#include "framework/support/Random.h"

#include <string>

namespace mrpp::test
{

/// The text after one to three damages: cut off, bytes changed, lost, doubled or repeated 200 times, numbers
/// beyond all bounds, and signs that open what they never close.
[[nodiscard]] std::string damaged(std::string text, Random &random);

} // namespace mrpp::test

#pragma once
/// \file
/// Comparison of whole outputs with files kept in tests/golden.

#include <string>

namespace mrpp::testing
{

/// Fails unless tests/golden/NAME holds exactly this text. With the environment variable MRPP_BLESS=1 the
/// file is written instead: look at the difference before committing it.
void expectGolden(const std::string &name, const std::string &text);

} // namespace mrpp::testing

#pragma once
/// \file
/// Valid files of formats that are not read here, of random contents, and what a refusal should call them.

#include "framework/support/Random.h"

#include <string>
#include <vector>

namespace mrpp::test
{

struct ForeignFile
{
    std::string kind;
    std::string text;
    std::string name; ///< a part of what a message should call it
};

/// One file of each kind.
[[nodiscard]] std::vector<ForeignFile> foreignFiles(Random &random);

} // namespace mrpp::test

#pragma once
/// \file
/// One row of results as JSON: what `mrppsim solve --json` writes.

#include "framework/run/RunRecord.h"

#include <string>

namespace mrpp
{

enum class JsonColumns
{
    solve, ///< those of `solve --json`
    all,   ///< every column, then those that events added
};

/// One object, indented, the columns in the order of runColumns(). A number that does not exist is null; so
/// is an infinite one. Bytes that are no UTF-8 become U+FFFD.
[[nodiscard]] std::string toJson(const RunRecord &record, JsonColumns columns);

} // namespace mrpp

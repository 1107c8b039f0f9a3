#pragma once
/// \file
/// What of a run's record is its answer: the part that the same question gives again, on any machine and
/// however busy it is.

#include "framework/run/RunRecord.h"

#include <span>
#include <string_view>
#include <vector>

namespace mrpp
{

/// Names of the columns: how the run ended, on which instance, with which solution of which lengths.
[[nodiscard]] std::span<const std::string_view> answerColumns();

/// The columns in which two answers to one question differ; empty where they agree.
[[nodiscard]] std::vector<std::string_view> answerDifferences(const RunRecord &a, const RunRecord &b);

/// Whether the clock or the memory ended the run, so that it may end otherwise on another day.
[[nodiscard]] bool endedByLimit(const RunRecord &record);

} // namespace mrpp

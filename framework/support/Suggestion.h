#pragma once
/// \file
/// "Did you mean …?": the known word nearest to a misspelt one.

#include <span>
#include <string>
#include <string_view>

namespace mrpp
{

/// The candidate with the least edit distance to `word` (insert, delete, replace, swap neighbours), or an
/// empty string where none is near enough to be what was meant. O(|word| · total length of candidates).
[[nodiscard]] std::string nearestWord(std::string_view word, std::span<const std::string> candidates);

/// `; did you mean 'x'?` or, where nothing is near, `; known: a, b, c`.
[[nodiscard]] std::string suggestion(std::string_view word, std::span<const std::string> candidates);

} // namespace mrpp

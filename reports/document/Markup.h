#pragma once
/// \file
/// Text for other languages, in which it means itself and nothing else.

#include <string>
#include <string_view>

namespace mrpp
{

/// For LaTeX text (not its arguments or verbatim parts).
[[nodiscard]] std::string latexText(std::string_view text);

/// For a paragraph or a table's cell of Markdown, as GitHub and CommonMark read it.
[[nodiscard]] std::string markdownText(std::string_view text);

/// Letters alone, as LaTeX wants command names: "push_and_swap 2" becomes "PushAndSwapTwo".
[[nodiscard]] std::string latexName(std::string_view text);

} // namespace mrpp

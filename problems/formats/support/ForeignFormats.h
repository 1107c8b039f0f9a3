#pragma once
/// \file
/// Names files of formats that are not read, so that a message can say what a file is instead of what it is
/// not. Internal to this folder.

#include <string>
#include <string_view>

namespace mrpp
{

/// "a PDF document", "GML (the bracketed format)", …: what a text is by marks that no format of ours has;
/// empty where it may be one of ours. Looks at the beginning alone. O(1).
[[nodiscard]] std::string foreignFormat(std::string_view text);

/// What describeUnknown() says at worst.
inline constexpr std::string_view kPlainText = "plain text";

/// The same for files that no reader knows: always says something, at worst "plain text". O(text).
[[nodiscard]] std::string describeUnknown(std::string_view text);

/// What a table of nothing but numbers, or of a map's cells, may be instead of a list of edges: "a graph as
/// METIS has it", "an adjacency matrix", …; empty where it is a list of edges or no such table. O(text).
[[nodiscard]] std::string tableOfNumbers(std::string_view text);

/// Whether some line begins with these characters.
[[nodiscard]] bool hasLine(std::string_view text, std::string_view begin);

/// The name of the outermost element of XML; empty where there is none nearby.
[[nodiscard]] std::string_view rootElement(std::string_view text);

} // namespace mrpp

#pragma once
/// \file
/// What the readers of a plan's parts ask of its nodes. All throw PlanError at the node's place.

#include "framework/support/Config.h"

#include <cstdint>
#include <string>
#include <vector>

namespace mrpp
{

/// The node, which must be a map. \param where stands in where the node has no place of its own
/// \param what is said otherwise
const Config &requireMap(const Config &node, const SourceLocation &where, const std::string &what);

/// Every key of the map must be known. \param owner whose keys they are: "a plan"
void checkKeys(const Config &map, const std::string &owner, const std::vector<std::string> &known);

/// A scalar that is not empty.
[[nodiscard]] const std::string &textOf(const Config::Entry &entry);

[[nodiscard]] std::int64_t integerOf(const Config::Entry &entry, std::int64_t low, std::int64_t high);

/// The name of something in tables and figures: textOf() in one line.
[[nodiscard]] const std::string &nameOf(const Config::Entry &entry);

/// Blanks for line breaks and tabs: for names that are made of values.
[[nodiscard]] std::string inOneLine(std::string text);

/// "60 s", "1.5h": seconds, above 0; or 0 as well.
enum class Zero
{
    refused,
    allowed,
};
[[nodiscard]] double durationOf(const Config::Entry &entry, Zero zero = Zero::refused);

/// "4 GiB": MB (10^6 bytes), above 0. \param examples for the message otherwise
[[nodiscard]] double sizeOf(const Config::Entry &entry, const std::string &examples);

/// The items of a list that must not be empty.
[[nodiscard]] const std::vector<Config> &itemsOf(const Config::Entry &entry, const std::string &what);

} // namespace mrpp

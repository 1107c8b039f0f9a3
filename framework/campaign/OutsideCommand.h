#pragma once
/// \file
/// An outside program as a plan describes it: a command with places to fill in.
///
///     "./solver.py --weight {weight} {graph} {instance} -o {output}"
///
/// No shell sees it: it is split into words at blanks, outside of quotes ('…' and "…") and after a backslash
/// as a shell does, and nothing else of a shell is known. `{name}` is a place where `name` is a word of small
/// letters, digits and underscores; `{{name}}` stands for the text `{name}`.

#include "framework/PlannerStatus.h"
#include "framework/model/MotionRule.h"
#include "framework/support/Error.h"

#include <filesystem>
#include <functional>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace mrpp
{

struct OutsideCommand
{
    std::vector<std::string> words;
    std::string answerFormat = {}; ///< empty: what the answer's contents tell
    std::string graphFormat = "graphml";
    std::string instanceFormat = "instance";
    MotionRule motion = MotionRule::rotation;    ///< that its answers obey
    std::map<int, PlannerStatus> exitCodes = {}; ///< what they mean, but for 0
    std::filesystem::path folder = {};           ///< where it starts: the plan's
    SourceLocation where = {};                   ///< in the plan
};

/// Throws InputError where a quote is not closed or there is no word.
[[nodiscard]] std::vector<std::string> splitCommand(std::string_view text);

/// The names of the places, each once, in their order.
[[nodiscard]] std::vector<std::string> placesIn(std::span<const std::string> words);

/// The word with its places filled.
[[nodiscard]] std::string fillPlaces(std::string_view word,
                                     const std::function<std::string(const std::string &)> &valueOf);

/// The places that the program fills itself: graph, instance, map, scen, robots, time_limit, seed, output.
[[nodiscard]] const std::vector<std::string> &ownPlaces();

/// What else a plan says of a command, and what no place may be called: command, format, graph_format,
/// instance_format, motion, exit_codes.
[[nodiscard]] const std::vector<std::string> &commandProperties();

/// Files that the command names by their paths (relative ones start at its folder): its script, its model,
/// the executable itself unless it is found in PATH.
[[nodiscard]] std::vector<std::filesystem::path> filesOf(const OutsideCommand &command);

/// Throws PlanError where there is no such program.
void checkExecutable(const OutsideCommand &command);

} // namespace mrpp

#pragma once
/// \file
/// An outside program as a plan describes it: a command with places to fill in.
///
///     "./solver.py --weight {weight} {graph} {instance} -o {output}"
///
/// No shell sees it: it is split into words as a shell does (blanks, '…', "…", backslashes), and nothing else
/// of a shell is known. `{name}` is a place where `name` is a word of small letters, digits and underscores;
/// `{{name}}` stands for the text `{name}`.

#include "framework/PlannerStatus.h"
#include "framework/model/MotionRule.h"
#include "framework/support/Error.h"

#include <filesystem>
#include <functional>
#include <map>
#include <optional>
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
    std::vector<std::string> files = {};         ///< that its answers depend on, besides those in its words
    std::optional<double> margin = {};           ///< seconds, see timeMargin()
    std::filesystem::path folder = {};           ///< the plan's: its relative paths start there
    SourceLocation where = {};                   ///< in the plan
};

/// As a POSIX shell splits and unquotes, a backslash at a line's end included. Throws InputError where a
/// quote is not closed or there is no word.
[[nodiscard]] std::vector<std::string> splitCommand(std::string_view text);

/// The names of the places, each once, in their order.
[[nodiscard]] std::vector<std::string> placesIn(std::span<const std::string> words);

/// What looks like a place and is none, without its braces: "Output", "time-limit", " output ". Not
/// "${HOME}".
[[nodiscard]] std::vector<std::string> doubtfulPlacesIn(std::span<const std::string> words);

/// The name of a place as it would be right: "time_limit" of "Time-Limit ".
[[nodiscard]] std::string asPlaceName(std::string_view text);

/// The word with its places filled.
[[nodiscard]] std::string fillPlaces(std::string_view word,
                                     const std::function<std::string(const std::string &)> &valueOf);

/// The places that the program fills itself: graph, instance, map, scen, robots, time_limit, time_limit_s,
/// time_limit_ms, seed, output, folder, plan_folder.
[[nodiscard]] const std::vector<std::string> &ownPlaces();

/// What else a plan says of a command, and what no place may be called: command, format, graph_format,
/// instance_format, motion, exit_codes, files, margin.
[[nodiscard]] const std::vector<std::string> &commandProperties();

/// How long before the run's limit the program is told to stop, so that one that stops at its limit has time
/// to write its answer: what the plan says, else a tenth of the limit, at most a second.
[[nodiscard]] double timeMargin(const OutsideCommand &command, double limit);

/// A word as the program is given it. It starts in a folder of its own that shows what is in the plan's
/// (makeWorkingFolder()), so that only the program's own path, and parts of words that lead out of the plan's
/// folder to something ("../x", "--config=../x"), become absolute.
[[nodiscard]] std::string givenWord(const OutsideCommand &command, std::size_t index,
                                    const std::string &filled);

/// A file that the answers of a program depend on.
struct CommandFile
{
    std::string name; ///< as the command says it
    std::filesystem::path path;
};

/// The files of the plan's `files`, whether they are there or not, and those that the words name when the
/// places are filled with these values: a whole word, what stands behind an option's letter (-fconf.txt), and
/// what stands between blanks, quotes, and the signs = : , ; @ ( ) < > | &. Not a program that is found in
/// PATH.
[[nodiscard]] std::vector<CommandFile> filesOf(const OutsideCommand &command,
                                               std::span<const std::pair<std::string, std::string>> values);

/// Throws PlanError where there is no such program.
void checkExecutable(const OutsideCommand &command);

} // namespace mrpp

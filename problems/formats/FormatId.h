#pragma once
/// \file
/// Which formats there are, and which one a file has. Internal to this folder.

#include "framework/support/Error.h"

#include <filesystem>
#include <string>
#include <string_view>

namespace mrpp
{

enum class FormatId
{
    graphMl,
    movingAiMap,
    dimacs,
    edgeList,
    matrixMarket,
    instanceText,
    scenario,
    cpf,
    kei18Instance,
    libMrpInstance,
    vetandInstance,
    solutionCsv,
    surynekSolution,
    kei18Result,
    libMrpSchedule,
    vetandResult,
    paths,
    trackerCsv,
    trackerJson,
    graphRec,
    graphRecXml,
    planViz, ///< only written
    unknown,
};

/// By what is in the file; by its extension where that says nothing. What is of a format that is not read at
/// all is unknown, whatever its extension.
[[nodiscard]] FormatId formatOf(const std::filesystem::path &file, std::string_view text);

/// By what is in the file alone.
[[nodiscard]] FormatId formatOf(std::string_view text);

/// As in fileFormats(); empty for an unknown one.
[[nodiscard]] std::string_view nameOf(FormatId format);

/// In a sentence: "this is …".
[[nodiscard]] std::string_view describe(FormatId format);

/// The same of a text of that format, or of one that only looks like it, as METIS does like a list of edges.
[[nodiscard]] std::string describe(FormatId format, std::string_view text);

/// What can be read out of such a file.
[[nodiscard]] bool holdsGraph(FormatId format);
[[nodiscard]] bool holdsInstance(FormatId format);
[[nodiscard]] bool holdsSolution(FormatId format);

/// A file that says of itself that there is no solution in it: its program found none.
class NoSolution : public InputError
{
public:
    using InputError::InputError;
};

/// The same complaint, unless the text is of another format: then the complaint is that.
[[nodiscard]] ParseError blamed(const ParseError &error, FormatId expected, std::string_view text,
                                const std::string &file);

/// Runs a reader. Where it refuses a text of another format, the message says which one that is.
template <class Read>
auto readAs(FormatId expected, std::string_view text, const std::string &file, Read &&read)
{
    try
    {
        return read();
    }
    catch (const ParseError &error)
    {
        throw blamed(error, expected, text, file);
    }
}

} // namespace mrpp

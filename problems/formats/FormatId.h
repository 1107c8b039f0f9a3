#pragma once
/// \file
/// Which formats there are, and which one a file has. Internal to this folder.

#include <filesystem>
#include <string_view>

namespace mrpp
{

enum class FormatId
{
    graphMl,
    movingAiMap,
    dimacs,
    edgeList,
    instanceText,
    scenario,
    cpf,
    kei18Instance,
    libMrpInstance,
    solutionCsv,
    surynekSolution,
    kei18Result,
    libMrpSchedule,
    paths,
    trackerCsv,
    trackerJson,
    graphRec,
    graphRecXml,
    planViz, ///< only written
    unknown,
};

/// By what is in the file; by its extension where that says nothing.
[[nodiscard]] FormatId formatOf(const std::filesystem::path &file, std::string_view text);

/// As in fileFormats(); empty for an unknown one.
[[nodiscard]] std::string_view nameOf(FormatId format);

/// What can be read out of such a file.
[[nodiscard]] bool holdsGraph(FormatId format);
[[nodiscard]] bool holdsInstance(FormatId format);
[[nodiscard]] bool holdsSolution(FormatId format);

} // namespace mrpp

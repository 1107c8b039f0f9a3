#pragma once
/// \file
/// From one file format to another.
///
/// \code
/// const Conversion done = convertFile({.in = "board.cpf", .out = "board.graphml"});
/// for (const std::string &note : done.notes) // what board.graphml cannot say
///     …
/// \endcode

#include "framework/system/File.h"
#include "framework/system/Supervision.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace mrpp
{

struct ConversionRequest
{
    std::filesystem::path in;
    std::filesystem::path out;
    std::optional<std::filesystem::path> graph;    ///< of the instance, where it does not say itself
    std::optional<std::filesystem::path> instance; ///< of a solution, which cannot be read without
    std::optional<std::string> format;             ///< of `out`, as in fileFormats(); else by its extension
    std::string passability = "movingai";          ///< of a MovingAI map that is read, see passabilities()
};

struct Conversion
{
    std::string format;                       ///< of `out`
    std::vector<std::filesystem::path> files; ///< that were written: `out`, and perhaps its graph
    std::vector<std::string> notes;           ///< what is lost or may not be what was meant
};

/// Reads `in` and writes `out`. Where an instance's new format does not hold its graph, and no file has it in
/// a format that suits, the graph is written beside it. Throws InputError where a file is malformed, the
/// format of `out` is not clear, holds another kind of thing, or cannot express this one.
Conversion convertFile(const ConversionRequest &request);

/// The same. \param files what is written, and committed here \param listener hears of what takes long
Conversion convertFile(const ConversionRequest &request, FileSet &files,
                       const Supervision::Listener &listener);

} // namespace mrpp

#pragma once
/// \file
/// The files of this folder, as they were when the library was built. Written by embed.cmake.

#include <span>
#include <string_view>

namespace mrpp
{

struct SmallProblemData
{
    std::string_view name;
    std::string_view graph;    ///< GraphML
    std::string_view instance; ///< instance text
};

[[nodiscard]] std::span<const SmallProblemData> smallProblems();

} // namespace mrpp

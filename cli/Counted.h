#pragma once

#include <cstddef>
#include <string>

namespace mrpp
{

/// "1 run", "2 runs".
[[nodiscard]] inline std::string counted(std::size_t count, const std::string &word)
{
    return std::to_string(count) + " " + word + (count == 1 ? "" : "s");
}

} // namespace mrpp

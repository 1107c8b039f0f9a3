#pragma once
/// \file
/// Reads what the explorer's pages carry, independently of the code that packs it.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace mrpp::testing
{

/// The bytes of a packedText(); nothing where it is damaged.
[[nodiscard]] std::optional<std::vector<std::uint8_t>> unpacked(std::string_view text);

/// The text of the page's <script> element of that id; nothing where there is none.
[[nodiscard]] std::optional<std::string> dataBlock(std::string_view page, const std::string &id);

struct UnpackedGraph
{
    std::vector<std::pair<std::int64_t, std::int64_t>> places;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
    std::vector<std::uint32_t> blocks; ///< of each edge
    std::vector<std::uint64_t> blockSizes;
};

/// Of a graphBlock(); nothing where it is damaged or something is left.
[[nodiscard]] std::optional<UnpackedGraph> unpackGraph(const std::vector<std::uint8_t> &bytes);

} // namespace mrpp::testing

#pragma once
/// \file
/// Bytes as text that a page can carry: compressed (RFC 1950, which browsers call "deflate") and then written
/// in base64 (RFC 4648).

#include <cstdint>
#include <span>
#include <string>

namespace mrpp
{

/// The same bytes give the same text. O(bytes).
[[nodiscard]] std::string packedText(std::span<const std::uint8_t> bytes);

} // namespace mrpp

#include "reports/explorer/Packing.h"

#include <new>
#include <stdexcept>
#include <vector>
#include <zlib.h>

namespace mrpp
{

namespace
{

std::vector<std::uint8_t> compressed(std::span<const std::uint8_t> bytes)
{
    uLongf size = compressBound(static_cast<uLong>(bytes.size()));
    std::vector<std::uint8_t> result(size);
    const int code =
        compress2(result.data(), &size, bytes.data(), static_cast<uLong>(bytes.size()), Z_BEST_COMPRESSION);
    if (code == Z_MEM_ERROR)
        throw std::bad_alloc();
    if (code != Z_OK)
        throw std::logic_error("zlib could not compress");
    result.resize(size);
    return result;
}

std::string base64(std::span<const std::uint8_t> bytes)
{
    constexpr char kDigits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t at = 0; at < bytes.size(); at += 3)
    {
        const std::size_t count = std::min<std::size_t>(3, bytes.size() - at);
        std::uint32_t group = 0;
        for (std::size_t i = 0; i < 3; ++i)
            group = group << 8 | (i < count ? bytes[at + i] : 0U);
        for (std::size_t i = 0; i < 4; ++i)
            text += i <= count ? kDigits[group >> (18 - 6 * i) & 0x3fU] : '=';
    }
    return text;
}

} // namespace

std::string packedText(std::span<const std::uint8_t> bytes)
{
    return base64(compressed(bytes));
}

} // namespace mrpp

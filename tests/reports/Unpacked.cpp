#include "tests/reports/Unpacked.h"

#include "framework/support/Bytes.h"

#include <zlib.h>

namespace mrpp::testing
{

std::optional<std::vector<std::uint8_t>> unpacked(std::string_view text)
{
    const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::vector<std::uint8_t> compressed;
    std::uint32_t bits = 0;
    int count = 0;
    for (const char c : text.substr(0, text.find('=')))
    {
        const std::size_t digit = digits.find(c);
        if (digit == std::string::npos)
            return std::nullopt;
        bits = bits << 6 | static_cast<std::uint32_t>(digit);
        count += 6;
        if (count >= 8)
            compressed.push_back(static_cast<std::uint8_t>(bits >> (count -= 8)));
    }

    std::vector<std::uint8_t> bytes;
    z_stream stream{};
    if (inflateInit(&stream) != Z_OK)
        return std::nullopt;
    stream.next_in = compressed.data();
    stream.avail_in = static_cast<uInt>(compressed.size());
    int code = Z_OK;
    while (code == Z_OK)
    {
        std::uint8_t buffer[4096];
        stream.next_out = buffer;
        stream.avail_out = sizeof buffer;
        code = inflate(&stream, Z_NO_FLUSH);
        bytes.insert(bytes.end(), buffer, buffer + (sizeof buffer - stream.avail_out));
    }
    inflateEnd(&stream);
    return code == Z_STREAM_END ? std::optional(bytes) : std::nullopt;
}

std::optional<std::string> dataBlock(std::string_view page, const std::string &id)
{
    const std::size_t mark = page.find(" id=\"" + id + "\">");
    if (mark == std::string_view::npos)
        return std::nullopt;
    const std::size_t begin = page.find('>', mark) + 1;
    return std::string(page.substr(begin, page.find("</script>", begin) - begin));
}

std::optional<UnpackedGraph> unpackGraph(const std::vector<std::uint8_t> &bytes)
{
    ByteReader reader(bytes);
    UnpackedGraph graph;
    const std::uint64_t vertices = reader.number();
    const std::uint64_t edges = reader.number();
    std::uint32_t x = 0;
    std::uint32_t y = 0;
    for (std::uint64_t v = 0; v < vertices && reader.good(); ++v)
    {
        x = reader.difference(x);
        y = reader.difference(y);
        graph.places.emplace_back(static_cast<std::int32_t>(x), static_cast<std::int32_t>(y));
    }
    for (std::uint32_t v = 0; v < vertices && reader.good(); ++v)
    {
        std::uint32_t neighbor = v;
        for (std::uint64_t left = reader.number(); left > 0 && reader.good(); --left)
        {
            neighbor += static_cast<std::uint32_t>(reader.number());
            graph.edges.emplace_back(v, neighbor);
        }
    }
    std::uint32_t block = 0;
    for (std::uint64_t edge = 0; edge < edges && reader.good(); ++edge)
        graph.blocks.push_back(block = reader.difference(block));
    for (std::uint64_t left = reader.number(); left > 0 && reader.good(); --left)
        graph.blockSizes.push_back(reader.number());
    const bool isWhole = reader.good() && reader.left() == 0 && graph.edges.size() == edges;
    return isWhole ? std::optional(graph) : std::nullopt;
}

} // namespace mrpp::testing

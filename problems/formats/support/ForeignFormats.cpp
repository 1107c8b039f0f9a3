#include "problems/formats/support/ForeignFormats.h"

#include "framework/support/Config.h"
#include "problems/formats/support/TextReader.h"

#include <algorithm>
#include <cctype>
#include <vector>

namespace mrpp
{

namespace
{

using namespace std::string_view_literals;

constexpr std::size_t kBeginning = 4096; ///< how far a mark may lie behind a file's begin

struct Mark
{
    std::string_view begin;
    std::string_view what;
};

/// Of files that are no text, or text that announces itself.
constexpr Mark kFirstBytes[] = {
    {"%PDF-", "a PDF document"},
    {"%!PS", "a PostScript document"},
    {"{\\rtf", "a rich-text document (RTF)"},
    {"\x89PNG", "a PNG picture"},
    {"\xFF\xD8\xFF", "a JPEG picture"},
    {"GIF8", "a GIF picture"},
    {"II*\0"sv, "a TIFF picture"},
    {"MM\0*"sv, "a TIFF picture"},
    {"RIFF", "a RIFF file (sound, video or WebP)"},
    {"OggS", "an Ogg file (sound or video)"},
    {"ID3", "an MP3 file"},
    {"\x1F\x8B", "data compressed by gzip; unpack it first"},
    {"BZh", "data compressed by bzip2; unpack it first"},
    {"\xFD"
     "7zXZ\0"sv,
     "data compressed by xz; unpack it first"},
    {"\x28\xB5\x2F\xFD", "data compressed by zstd; unpack it first"},
    {"\x04\x22\x4D\x18", "data compressed by lz4; unpack it first"},
    {"PK\x03\x04", "a zip archive; unpack it first"},
    {"PK\x05\x06", "an empty zip archive"},
    {"7z\xBC\xAF\x27\x1C", "a 7z archive; unpack it first"},
    {"Rar!\x1A", "a RAR archive; unpack it first"},
    {"!<arch>", "an archive of object files"},
    {"\x7F"
     "ELF",
     "an executable (ELF)"},
    {"MZ\x90", "an executable for Windows"},
    {"\xCA\xFE\xBA\xBE", "a Java class or an executable for macOS"},
    {"SQLite format 3", "an SQLite database"},
    {"\x89HDF", "an HDF5 file"},
    {"CDF\x01", "a NetCDF file"},
    {"CDF\x02", "a NetCDF file"},
    {"\x93NUMPY", "an array of NumPy"},
    {"PAR1", "a Parquet file"},
    {"MATLAB 5.0", "a MAT file of MATLAB"},
    {"\0asm"sv, "a WebAssembly module"},
    {"wOFF", "a font"},
    {"wOF2", "a font"},
    {"\xD0\xCF\x11\xE0", "a document of old Microsoft Office"},
    {"\x80\x02", "a pickle of Python"},
    {"\x80\x03", "a pickle of Python"},
    {"\x80\x04", "a pickle of Python"},
    {"\x80\x05", "a pickle of Python"},
    {">>graph6<<", "graphs as graph6"},
    {">>sparse6<<", "graphs as sparse6"},
    {">>digraph6<<", "graphs as digraph6"},
    {"LEDA.GRAPH", "a graph of LEDA"},
    {"nodedef>", "a graph as GDF"},
    {"% bip ", "a bipartite network of KONECT, whose two sides have numbers of their own"},
    {"#!", "a script"},
    {"\\documentclass", "a LaTeX document"},
    {"\\begin{", "a piece of LaTeX"},
};

/// Text whose first line that is no comment begins so, whatever the case of its letters.
constexpr Mark kFirstLines[] = {
    {"*vertices", "a network of Pajek"},
    {"*network", "a network of Pajek"},
    {"*arcs", "a network of Pajek"},
    {"*edges", "a network of Pajek"},
    {"*partition", "a partition of Pajek"},
    {"*node data", "a network of UCINET (VNA)"},
    {"dl ", "a network of UCINET (DL)"},
    {"p1\n", "a picture as PBM"},
    {"p2\n", "a picture as PGM; maps of cells are MovingAI maps here"},
    {"p3\n", "a picture as PPM"},
    {"p4\n", "a picture as PBM"},
    {"p5\n", "a picture as PGM; maps of cells are MovingAI maps here"},
    {"p6\n", "a picture as PPM"},
    {"p2 ", "a picture as PGM; maps of cells are MovingAI maps here"},
    {"p5 ", "a picture as PGM; maps of cells are MovingAI maps here"},
    {"p cnf", "a formula as DIMACS CNF"},
    {"#include", "a source text in C"},
    {"init(object(", "an instance of asprilo"},
    {"occurs(object(", "a plan of asprilo"},
};

bool isBlank(char c)
{
    return c == ' ' || c == '\t' || c == '\r' || c == '\n';
}

std::string lowered(std::string_view text)
{
    std::string lower(text);
    std::transform(lower.begin(), lower.end(), lower.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return lower;
}

std::string byFirstBytes(std::string_view text)
{
    if (text.starts_with("\xFF\xFE\0\0"sv) || text.starts_with("\0\0\xFE\xFF"sv))
        return "a text in UTF-32; save it as UTF-8";
    if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF"))
        return "a text in UTF-16; save it as UTF-8";
    for (const Mark &mark : kFirstBytes)
        if (text.starts_with(mark.begin))
            return std::string(mark.what);
    constexpr std::size_t kTarMark = 257;
    if (text.size() > kTarMark && text.substr(kTarMark).starts_with("ustar"))
        return "a tar archive; unpack it first";
    const std::string_view beginning = text.substr(0, kBeginning);
    const auto zeros = [beginning](std::size_t from)
    {
        std::size_t count = 0;
        for (std::size_t at = from; at < beginning.size(); at += 2)
            count += beginning[at] == '\0' ? 1 : 0;
        return count;
    };
    const std::size_t half = beginning.size() / 2;
    if (half > 0 && std::max(zeros(0), zeros(1)) * 10 >= half * 9 &&
        std::min(zeros(0), zeros(1)) * 10 <= half)
        return "a text in UTF-16; save it as UTF-8";
    return {};
}

/// Whether bytes of no text make up a good part of the beginning: control characters, and what no UTF-8 is.
bool isBinary(std::string_view beginning)
{
    std::size_t odd = 0;
    for (std::size_t i = 0; i < beginning.size(); ++i)
    {
        const auto c = static_cast<unsigned char>(beginning[i]);
        if (c < 0x20)
            odd += isBlank(beginning[i]) || c == '\f' || c == '\v' ? 0 : 1;
        if (c < 0x80)
            continue;
        const std::size_t more = c >= 0xF0 ? 3 : c >= 0xE0 ? 2 : c >= 0xC0 ? 1 : 0;
        bool valid = more > 0;
        for (std::size_t k = 1; k <= more && i + k < beginning.size(); ++k)
            valid = valid && (static_cast<unsigned char>(beginning[i + k]) & 0xC0) == 0x80;
        odd += valid ? 0 : 1;
        i += valid ? more : 0;
    }
    return odd > 2 && odd * 10 > beginning.size();
}

/// `[strict] graph [name] {` or `graph [`, wherever they stand in the beginning.
std::string graphWithBrackets(std::string_view beginning)
{
    const std::string text = lowered(beginning);
    for (std::size_t at = text.find("graph"); at != std::string::npos; at = text.find("graph", at + 1))
    {
        const std::size_t lineStart = text.rfind('\n', at) + 1; // npos + 1 is 0
        const std::string_view before = trimmed(std::string_view(text).substr(lineStart, at - lineStart));
        std::string_view behind = std::string_view(text).substr(at + 5);
        behind.remove_prefix(std::min(behind.find_first_not_of(" \t\r\n"), behind.size()));
        if (before.empty() && behind.starts_with('['))
            return "GML (the bracketed format)";
        if (!before.empty() && before != "di" && before != "strict" && before != "strict di")
            continue;
        if (behind.starts_with('"'))
            behind.remove_prefix(std::min(behind.find('"', 1), behind.size() - 1) + 1);
        else
            while (!behind.empty() &&
                   (std::isalnum(static_cast<unsigned char>(behind.front())) != 0 || behind.front() == '_'))
                behind.remove_prefix(1);
        if (trimmed(behind).starts_with('{'))
            return "a graph as Graphviz has it (dot)";
    }
    return {};
}

std::string byFirstLines(std::string_view text)
{
    const std::string_view beginning = text.substr(0, kBeginning);
    TextReader reader(beginning, "");
    while (const auto line = reader.next())
    {
        const std::string_view content = trimmed(*line);
        if (content.empty() || (content.starts_with('%') && !content.starts_with("%%")) ||
            (content.starts_with('#') && !content.starts_with("#include")) || content == "c" ||
            content.starts_with("c ") || content.starts_with("/*"))
            continue;
        const std::string lower = lowered(content) + '\n';
        for (const Mark &mark : kFirstLines)
            if (lower.starts_with(mark.begin))
                return std::string(mark.what);
        break;
    }
    return graphWithBrackets(beginning);
}

/// XML that is none of ours.
std::string ofXml(std::string_view text)
{
    const std::string_view root = rootElement(text);
    const std::string name = lowered(root);
    const std::string local = name.substr(name.find(':') + 1); // npos + 1 is 0
    if (local == "html" || lowered(text.substr(0, 100)).starts_with("<!doctype html"))
        return "an HTML page";
    if (local == "graphml" || local == "graphrec" || (local == "root" && root == "root") || root.empty())
        return {};
    if (local == "gexf")
        return "a graph as GEXF";
    if (local == "gxl")
        return "a graph as GXL";
    if (local == "svg")
        return "an SVG picture";
    if (local == "osm")
        return "a map of OpenStreetMap";
    return "XML that begins with " + inQuotes("<" + std::string(root) + ">");
}

} // namespace

bool hasLine(std::string_view text, std::string_view begin)
{
    for (std::size_t at = text.find(begin); at != std::string_view::npos; at = text.find(begin, at + 1))
        if (at == 0 || text[at - 1] == '\n')
            return true;
    return false;
}

std::string_view rootElement(std::string_view text)
{
    text = text.substr(0, kBeginning);
    for (std::size_t at = text.find('<'); at != std::string_view::npos; at = text.find('<', at + 1))
    {
        if (text.substr(at).starts_with("<!--"))
        {
            at = text.find("-->", at);
            if (at == std::string_view::npos)
                return {};
            continue;
        }
        if (text.substr(at + 1, 1) == "!" || text.substr(at + 1, 1) == "?")
        {
            at = text.find('>', at);
            if (at == std::string_view::npos)
                return {};
            continue;
        }
        const std::string_view name = text.substr(at + 1);
        return name.substr(0, name.find_first_of(" \t\r\n/>"));
    }
    return {};
}

std::string foreignFormat(std::string_view text)
{
    if (std::string found = byFirstBytes(text); !found.empty())
        return found;
    text = withoutByteOrderMark(text);
    if (isBinary(text.substr(0, kBeginning)))
        return "binary data, no text";
    text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
    if (text.starts_with('<'))
        return ofXml(text);
    if (text.starts_with('{') || text.starts_with('['))
        return {};
    return byFirstLines(text);
}

namespace
{

/// The numbers of a table: how many a line has, which they are as far as they are small and whole.
struct Numbers
{
    std::vector<std::size_t> perLine; ///< blank lines have none; comments are left out
    std::vector<double> values;
    bool isTable = true; ///< nothing but numbers
};

Numbers numbersOf(std::string_view text)
{
    Numbers numbers;
    TextReader reader(text, "");
    while (const auto line = reader.next())
    {
        LineCursor cursor(*line);
        if (!cursor.atEnd() && (cursor.take("#") || cursor.take("%")))
            continue;
        std::size_t count = 0;
        for (; !cursor.atEnd(); ++count)
        {
            const auto value = parseNumber(cursor.until(", \t;"));
            if (!value)
                return {{}, {}, false};
            numbers.values.push_back(*value);
            (void)(cursor.take(",") || cursor.take(";"));
        }
        numbers.perLine.push_back(count);
    }
    while (!numbers.perLine.empty() && numbers.perLine.back() == 0)
        numbers.perLine.pop_back();
    numbers.perLine.erase(numbers.perLine.begin(),
                          std::find_if(numbers.perLine.begin(), numbers.perLine.end(),
                                       [](std::size_t count) { return count > 0; }));
    return numbers;
}

/// `n m [format [weights]]`, then a line of neighbours for each vertex, from 1.
bool isMetis(const Numbers &numbers)
{
    const std::size_t header = numbers.perLine.front();
    if (header < 2 || header > 4)
        return false;
    const double n = numbers.values[0];
    const double m = numbers.values[1];
    const double format = header > 2 ? numbers.values[2] : 0;
    const double weights = header > 3 ? numbers.values[3] : 1;
    const auto digit = [format](double place)
    { return static_cast<std::int64_t>(format / place) % 10 == 1 ? 1.0 : 0.0; };
    if (n < 1 || m < 0 || n != static_cast<double>(numbers.perLine.size() - 1) || format < 0 || format > 111)
        return false;
    const double wanted = n * (digit(100) + digit(10) * weights) + 2 * m * (1 + digit(1));
    const double entries = static_cast<double>(numbers.values.size() - header);
    const bool fits =
        std::all_of(numbers.values.begin() + static_cast<std::ptrdiff_t>(header), numbers.values.end(),
                    [&](double value) { return format > 0 || (value >= 1 && value <= n); });
    return entries == wanted && fits;
}

/// As many lines as numbers in each of them; with three of them, which lists of edges have, too, symmetric or
/// of nothing but 0 and 1. Two lines of two are the same graph either way.
bool isMatrix(const Numbers &numbers)
{
    const std::size_t size = numbers.perLine.size();
    if (size < 3 || std::any_of(numbers.perLine.begin(), numbers.perLine.end(),
                                [size](std::size_t count) { return count != size; }))
        return false;
    if (size > 3)
        return true;
    const std::vector<double> &m = numbers.values;
    return (m[1] == m[3] && m[2] == m[6] && m[5] == m[7]) ||
           std::all_of(m.begin(), m.end(), [](double value) { return value == 0 || value == 1; });
}

/// Each line begins with a vertex of its own, whose neighbours follow.
bool isAdjacencyList(const Numbers &numbers)
{
    if (std::all_of(numbers.perLine.begin(), numbers.perLine.end(),
                    [&](std::size_t count) { return count == numbers.perLine.front(); }))
        return false;
    std::vector<double> firsts;
    std::size_t at = 0;
    for (const std::size_t count : numbers.perLine)
    {
        if (count > 0)
            firsts.push_back(numbers.values[at]);
        at += count;
    }
    std::sort(firsts.begin(), firsts.end());
    return std::adjacent_find(firsts.begin(), firsts.end()) == firsts.end();
}

/// Rows of signs without blanks: of 0 and 1, or of a map's dots and walls, perhaps behind a line of counts.
std::string rowsOfSigns(std::string_view text)
{
    std::vector<std::string_view> rows;
    TextReader reader(text, "");
    while (const auto line = reader.next())
        if (const std::string_view row = trimmed(*line); !row.empty())
            rows.push_back(row);
    const auto consistOf = [&rows](std::size_t first, std::string_view signs)
    {
        return rows.size() >= first + 2 &&
               std::all_of(rows.begin() + static_cast<std::ptrdiff_t>(first), rows.end(),
                           [signs](std::string_view row)
                           { return row.find_first_not_of(signs) == std::string_view::npos; });
    };
    constexpr std::string_view kCells = ".@TGOSWE#";
    if (consistOf(0, "01"))
        return "rows of 0 and 1 (an adjacency matrix, or a map of cells)";
    if (consistOf(0, kCells))
        return "rows of a map's cells without the header of a MovingAI map";
    if (consistOf(1, kCells) && rows.front().find_first_not_of("0123456789, \t") == std::string_view::npos)
        return "a map of EECBS's or the BGU's kind, which counts rows and columns in front";
    return {};
}

} // namespace

std::string tableOfNumbers(std::string_view text)
{
    if (hasLine(text, "# Nodes:"))
        return {};
    if (std::string found = rowsOfSigns(text); !found.empty())
        return found;
    const Numbers numbers = numbersOf(text);
    if (!numbers.isTable || numbers.perLine.size() < 2)
        return {};
    if (isMetis(numbers))
        return "a graph as METIS has it (vertices and edges are counted in front, then come each vertex's "
               "neighbours)";
    if (isMatrix(numbers))
        return "an adjacency matrix";
    if (isAdjacencyList(numbers))
        return "adjacency lists (a vertex and its neighbours a line), or a list of edges of which only some "
               "have a weight";
    const std::size_t columns = numbers.perLine.back();
    const bool ofOneForm = std::all_of(numbers.perLine.begin() + 1, numbers.perLine.end(),
                                       [&](std::size_t count) { return count == columns; });
    if (numbers.perLine.front() != columns && ofOneForm)
        return "a table of numbers with counts in its first line";
    return columns == 2 || columns == 3 ? std::string() : "a table of numbers";
}

std::string describeUnknown(std::string_view text)
{
    if (std::string found = foreignFormat(text); !found.empty())
        return found;
    text = withoutByteOrderMark(text);
    const std::string_view content = trimmed(text);
    if (content.empty())
        return "an empty file";
    if (std::string found = tableOfNumbers(text); !found.empty())
        return found;
    if (hasLine(text, "Grid:"))
        return "an instance of the BGU's kind";
    if (content.find("\n#\n") != std::string_view::npos &&
        std::isdigit(static_cast<unsigned char>(content.front())) != 0)
        return "a graph as TGF";
    const std::string_view line = trimmed(content.substr(0, content.find('\n')));
    const bool closes = content.ends_with('}') || content.ends_with(']');
    if (content.starts_with('{') || content.starts_with('['))
    {
        const auto has = [content](std::string_view word)
        { return content.find(word) != std::string_view::npos; };
        if (has("\"mapFile\"") || has("\"agentFile\""))
            return "a problem of the League of Robot Runners (JSON)";
        if ((has("\"nodes\"") || has("\"vertices\"")) && (has("\"links\"") || has("\"edges\"")))
            return "a graph as JSON";
        if (has("\"adjacency\""))
            return "a graph as JSON";
        if (content.starts_with('[') && !closes)
            return "a file of settings (INI or TOML)";
        return "JSON";
    }
    if (lowered(line).starts_with("name") && line.find(':') != std::string_view::npos &&
        hasLine(text, "DIMENSION"))
        return "a problem of TSPLIB";
    const std::size_t comma = line.find_first_of(",;\t");
    if (comma != std::string_view::npos && comma > 0 &&
        line.find_first_of("0123456789.({[") == std::string_view::npos)
        return "a table with the heading " + inQuotes(line);
    const std::size_t colon = line.find(':');
    if (line == "---" || (colon != std::string_view::npos && line.find_first_of(" \t") > colon &&
                          (colon + 1 == line.size() || line[colon + 1] == ' ')))
        return "YAML, or a text like it";
    return std::string(kPlainText);
}

} // namespace mrpp

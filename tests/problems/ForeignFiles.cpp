#include "tests/problems/ForeignFiles.h"

#include "tests/support/RandomCases.h"

#include <algorithm>
#include <array>
#include <utility>

namespace mrpp::test
{

namespace
{

using namespace std::string_literals;

using Pairs = std::vector<std::pair<std::size_t, std::size_t>>;

/// A connected graph that is no tree: a ring and some chords.
Pairs ringWithChords(std::size_t n, Random &random)
{
    Pairs edges;
    for (std::size_t v = 0; v < n; ++v)
        edges.emplace_back(std::min(v, (v + 1) % n), std::max(v, (v + 1) % n));
    for (std::size_t v = 0; v + 2 < n; ++v)
        if ((v > 0 || n > 3) && !(v == 0 && v + 2 == n - 1) && random.below(2) == 0)
            edges.emplace_back(v, v + 2);
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    return edges;
}

std::vector<std::vector<std::size_t>> neighborsOf(std::size_t n, const Pairs &edges)
{
    std::vector<std::vector<std::size_t>> neighbors(n);
    for (const auto &[a, b] : edges)
    {
        neighbors[a].push_back(b);
        neighbors[b].push_back(a);
    }
    return neighbors;
}

template <class Line>
std::string lines(const Pairs &edges, Line &&line)
{
    std::string text;
    for (const auto &[a, b] : edges)
        text += line(std::to_string(a), std::to_string(b)) + "\n";
    return text;
}

std::string numbers(const std::vector<std::size_t> &values, std::size_t base, const std::string &separator)
{
    std::string text;
    for (const std::size_t value : values)
        text += (text.empty() ? "" : separator) + std::to_string(value + base);
    return text;
}

std::string matrix(std::size_t n, const Pairs &edges, const std::string &separator)
{
    std::vector<std::vector<std::size_t>> rows(n, std::vector<std::size_t>(n, 0));
    for (const auto &[a, b] : edges)
        rows[a][b] = rows[b][a] = 1;
    std::string text;
    for (const auto &row : rows)
        text += numbers(row, 0, separator) + "\n";
    return text;
}

void addGraphs(std::vector<ForeignFile> &files, std::size_t n, const Pairs &edges)
{
    const auto neighbors = neighborsOf(n, edges);
    const std::string counts = std::to_string(n) + " " + std::to_string(edges.size()) + "\n";
    const std::string from0 = lines(edges, [](const auto &a, const auto &b) { return a + " " + b; });
    const auto add = [&files](const std::string &kind, std::string text, const std::string &name) {
        files.push_back({kind, std::move(text), name});
    };

    std::string metis = counts;
    std::string weighted = std::to_string(n) + " " + std::to_string(edges.size()) + " 001\n";
    std::string adjacency = "#/usr/bin/x.py\n# GMT Mon Nov 23 2026\n#\n";
    for (std::size_t v = 0; v < n; ++v)
    {
        metis += numbers(neighbors[v], 1, " ") + "\n";
        for (const std::size_t w : neighbors[v])
            weighted += std::to_string(w + 1) + " 7 ";
        weighted += "\n";
        adjacency += std::to_string(v);
        for (const std::size_t w : neighbors[v])
            adjacency += w > v ? " " + std::to_string(w) : "";
        adjacency += "\n";
    }
    add("Metis", metis, "METIS");
    add("MetisWithComments", "% a graph\n" + metis, "METIS");
    add("MetisWithWeights", weighted, "METIS");
    add("AdjacencyMatrix", matrix(n, edges, " "), "matrix");
    add("AdjacencyMatrixOfCommas", matrix(n, edges, ","), "matrix");
    add("AdjacencyMatrixWithoutBlanks", matrix(n, edges, ""), "adjacency matrix");
    add("AdjacencyLists", adjacency, "adjacency lists");
    add("Counts", counts + from0, "counts");
    add("CountsOfWeights",
        counts + lines(edges, [](const auto &a, const auto &b) { return a + " " + b + " 5"; }), "counts");
    add("CountOfVertices", std::to_string(n) + "\n" + from0, "counts");
    add("Pace", "p tw " + counts + from0, "DIMACS");
    add("KonectBipartite", "% bip unweighted\n" + from0, "KONECT");
    add("MatrixMarketArray", "%%MatrixMarket matrix array real general\n2 2\n0\n1\n1\n0\n",
        "Matrix Market file");
    add("MatrixMarketComplex", "%%MatrixMarket matrix coordinate complex general\n2 2 1\n1 2 1 0\n",
        "Matrix Market file");

    std::string gml = "graph [\n  directed 0\n";
    std::string pajek = "*Vertices " + std::to_string(n) + "\n";
    std::string tgf;
    std::string gdf = "nodedef>name VARCHAR\n";
    std::string nodes;
    for (std::size_t v = 0; v < n; ++v)
    {
        const std::string name = std::to_string(v);
        gml += "  node [\n    id " + name + "\n    label \"v" + name + "\"\n  ]\n";
        pajek += std::to_string(v + 1) + " \"v" + name + "\"\n";
        tgf += std::to_string(v + 1) + " v" + name + "\n";
        gdf += "v" + name + "\n";
        nodes += (v == 0 ? "" : ", ") + ("{\"id\": " + name + "}");
    }
    std::string links;
    for (const auto &[a, b] : edges)
        links += (links.empty() ? "" : ", ") + ("{\"source\": " + std::to_string(a)) +
                 ", \"target\": " + std::to_string(b) + "}";
    const std::string gmlEdges =
        lines(edges, [](const auto &a, const auto &b)
              { return "  edge [\n    source " + a + "\n    target " + b + "\n  ]"; });
    const std::string dot =
        lines(edges, [](const auto &a, const auto &b) { return "  " + a + " -- " + b + ";"; });
    const std::string named = lines(edges, [](const auto &a, const auto &b) { return "v" + a + " v" + b; });
    add("Gml", gml + gmlEdges + "]\n", "GML");
    add("GmlWithCreator", "Creator \"yFiles\"\nVersion \"2.14\"\n" + gml + gmlEdges + "]\n", "GML");
    add("GmlWithComment", "# made by hand\ngraph\n" + gml.substr(6) + gmlEdges + "]\n", "GML");
    add("Pajek", pajek + "*Edges\n" + from0, "Pajek");
    add("PajekNetwork", "*Network a\r\n" + pajek + "*Arcs\r\n", "Pajek");
    add("Dot", "graph {\n" + dot + "}\n", "Graphviz");
    add("DotWithName", "/* a comment */\nstrict graph \"a b\" {\n" + dot + "}\n", "Graphviz");
    add("Digraph", "// made by x\ndigraph G\n{\n  a -> b;\n}\n", "Graphviz");
    add("Tgf", tgf + "#\n" + from0, "TGF");
    add("TgfOfNumbers", "1 1\n2 2\n3 3\n#\n1 2\n2 3\n", "TGF");
    add("Gdf", gdf + "edgedef>node1 VARCHAR,node2 VARCHAR\n", "GDF");
    add("Leda", "LEDA.GRAPH\nvoid\nvoid\n-2\n" + std::to_string(n) + "\n", "LEDA");
    add("Graph6", ">>graph6<<DQc\n", "graph6");
    add("Ucinet", "dl n=" + std::to_string(n) + " format=edgelist1\ndata:\n" + from0, "UCINET");
    add("JsonNodeLink",
        "{\"directed\": false, \"multigraph\": false, \"graph\": {}, \"nodes\": [" + nodes +
            "], \"links\": [" + links + "]}",
        "a graph as JSON");
    add("JsonOfEdges", "{\n  \"nodes\": [" + nodes + "],\n  \"edges\": [" + links + "]\n}\n",
        "a graph as JSON");
    add("Gexf",
        "<?xml version=\"1.0\"?>\n<gexf xmlns=\"http://gexf.net/1.3\" "
        "version=\"1.3\"><graph><nodes/></graph></gexf>\n",
        "GEXF");
    add("Gxl", "<?xml version=\"1.0\"?><!DOCTYPE gxl SYSTEM \"gxl.dtd\"><gxl><graph id=\"g\"/></gxl>", "GXL");
    add("CsvOfEdges",
        "source,target\n" + lines(edges, [](const auto &a, const auto &b) { return a + "," + b; }),
        "a table with the heading 'source,target'");
    add("CsvOfQuotes", "\"Source\",\"Target\",\"Weight\"\n0,1,5\n", "a table with the heading");
    add("TableOfTabs", "from\tto\n" + from0, "a table with the heading");
    add("EdgesOfNames", named, "");
}

void addMaps(std::vector<ForeignFile> &files, Random &random)
{
    const std::size_t width = 3 + random.below(5);
    const std::size_t height = 3 + random.below(5);
    std::string rows;
    std::string numbersOfRows;
    for (std::size_t y = 0; y < height; ++y)
    {
        for (std::size_t x = 0; x < width; ++x)
        {
            const bool wall = random.below(4) == 0;
            rows += wall ? '@' : '.';
            numbersOfRows += wall ? "0 " : "255 ";
        }
        rows += '\n';
        numbersOfRows += '\n';
    }
    const std::string w = std::to_string(width);
    const std::string h = std::to_string(height);
    const auto add = [&files](const std::string &kind, std::string text, const std::string &name) {
        files.push_back({kind, std::move(text), name});
    };
    add("EecbsMap", h + "," + w + "\n" + rows, "EECBS");
    add("BguInstance", "0\nGrid:\n" + h + "," + w + "\n" + rows + "Agents:\n0\n", "BGU");
    add("BareRows", rows, "without the header of a MovingAI map");
    add("Pgm", "P2\n# a map\n" + w + " " + h + "\n255\n" + numbersOfRows, "PGM");
    add("PgmOfBytes", "P5 " + w + " " + h + " 255\n" + rows, "PGM");
    add("LorrProblem", "{\n  \"mapFile\": \"m.map\",\n  \"agentFile\": \"a.agents\",\n  \"teamSize\": 2\n}\n",
        "League of Robot Runners");
    add("Asprilo", "init(object(node,1),value(at,(1,1))).\n", "asprilo");
    add("RosMap", "image: map.pgm\nresolution: 0.05\norigin: [0, 0, 0]\n", "YAML");
    add("Osm", "<?xml version='1.0'?>\n<osm version='0.6'><node id='1' lat='1' lon='2'/></osm>\n",
        "OpenStreetMap");
    add("CcbsAgents", "<?xml version=\"1.0\"?>\n<agents><agent start_id=\"1\" goal_id=\"2\"/></agents>\n",
        "'<agents>'");
}

void addTexts(std::vector<ForeignFile> &files)
{
    const auto add = [&files](const std::string &kind, std::string text, const std::string &name) {
        files.push_back({kind, std::move(text), name});
    };
    add("Html", "<!DOCTYPE html>\n<html><head><title>404</title></head><body>graph</body></html>\n", "HTML");
    add("HtmlWithoutType", "\n<HTML>\n<body><p>map</p></body>\n</HTML>\n", "HTML");
    add("Svg", "<svg xmlns=\"http://www.w3.org/2000/svg\"><g/></svg>", "SVG");
    add("OtherXml", "<?xml version=\"1.0\"?>\n<!-- x -->\n<project name=\"a\"><target/></project>\n", "XML");
    add("Json", "{\"a\": 1, \"b\": [1, 2]}\n", "JSON");
    add("JsonList", "[1, 2, 3]\n", "JSON");
    add("GeoJson", "{\"type\": \"FeatureCollection\", \"features\": []}\n", "JSON");
    add("Yaml", "services:\n  web:\n    image: x\n", "YAML");
    add("YamlWithMarker", "---\nname: x\nvalues: [1, 2]\n", "YAML");
    add("Ini", "[section]\nkey = value\n", "settings");
    add("Latex", "\\documentclass{article}\n\\begin{document}\n\\end{document}\n", "LaTeX");
    add("Script", "#!/bin/sh\necho map\n", "script");
    add("Source", "#include <map>\nint main() { return 0; }\n", "C");
    add("Cnf", "c a formula\np cnf 3 2\n1 -2 0\n2 3 0\n", "CNF");
    add("Tsplib", "NAME : a\nTYPE : TSP\nDIMENSION : 3\nNODE_COORD_SECTION\n1 0 0\n2 1 0\n3 0 1\nEOF\n",
        "TSPLIB");
    add("English", "The robots move along the edges of the graph.\nNobody knows why.\n", "");
    add("Markdown", "# Results\n\n* map: good\n* graph: better\n", "");
    add("Empty", "", "empty");
    add("Blanks", " \n\t\n\r\n", "empty");
    add("EmptyWithMark", "\xEF\xBB\xBF", "empty");
}

std::string wide(const std::string &text, bool littleEndian, std::size_t bytes)
{
    std::string result;
    for (const char c : text)
    {
        const std::string zeros(bytes - 1, '\0');
        result += littleEndian ? c + zeros : zeros + c;
    }
    return result;
}

void addBinaries(std::vector<ForeignFile> &files, Random &random)
{
    const auto add = [&files](const std::string &kind, std::string text, const std::string &name) {
        files.push_back({kind, std::move(text), name});
    };
    std::string noise;
    for (std::size_t i = 0, size = 100 + random.below(1000); i < size; ++i)
        noise += static_cast<char>(random.below(256));
    add("Png", "\x89PNG\r\n\x1A\n"s + noise, "PNG");
    add("Jpeg", "\xFF\xD8\xFF\xE0"s + noise, "JPEG");
    add("Gif", "GIF89a"s + noise, "GIF");
    add("Pdf", "%PDF-1.7\n%\xE2\xE3\xCF\xD3\n" + noise, "PDF");
    add("Gzip", "\x1F\x8B\x08"s + noise, "gzip");
    add("Zip", "PK\x03\x04"s + noise, "zip");
    add("Bzip2", "BZh91AY&SY" + noise, "bzip2");
    add("Xz", "\xFD"s + "7zXZ\0"s + noise, "xz");
    add("Zstd", "\x28\xB5\x2F\xFD" + noise, "zstd");
    add("SevenZip", "7z\xBC\xAF\x27\x1C" + noise, "7z");
    add("Elf", "\x7F"s + "ELF" + noise, "ELF");
    add("Sqlite", "SQLite format 3\0"s + noise, "SQLite");
    add("Hdf5", "\x89HDF\r\n\x1A\n"s + noise, "HDF5");
    add("Numpy", "\x93NUMPY"s + noise, "NumPy");
    add("Pickle", "\x80\x04\x95"s + noise, "pickle");
    add("Tar", std::string(257, 'a') + "ustar\0"s + noise, "tar");
    add("Noise", noise + '\0', "");
    const std::string graph =
        "<?xml version=\"1.0\"?>\n<graphml><graph edgedefault=\"undirected\"/></graphml>\n";
    add("Utf16Little", "\xFF\xFE" + wide(graph, true, 2), "UTF-16");
    add("Utf16Big", "\xFE\xFF" + wide(graph, false, 2), "UTF-16");
    add("Utf16WithoutMark", wide("type octile\nheight 2\nwidth 2\nmap\n..\n..\n", true, 2), "UTF-16");
    add("Utf32", "\xFF\xFE\0\0"s + wide(graph, true, 4), "UTF-32");
}

} // namespace

std::vector<ForeignFile> foreignFiles(Random &random)
{
    std::vector<ForeignFile> files;
    const std::size_t n = 5 + random.below(6);
    addGraphs(files, n, ringWithChords(n, random));
    addMaps(files, random);
    addTexts(files);
    addBinaries(files, random);
    return files;
}

} // namespace mrpp::test

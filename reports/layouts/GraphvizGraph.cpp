#include "reports/layouts/GraphvizGraph.h"

#include "framework/support/Config.h"
#include "framework/support/Error.h"
#include "framework/system/File.h"
#include "framework/system/TemporaryFolder.h"
#include "reports/picture/PdfFile.h"
#include "reports/picture/Process.h"
#include "reports/picture/Text.h"

#include <array>
#include <fmt/format.h>
#include <sstream>
#include <utility>

namespace mrpp
{

namespace
{

using Attributes = std::vector<std::pair<std::string, std::string>>;

constexpr const char *kInput = "drawing.dot";

/// A quoted name or value: between quotes DOT knows no other special character than they.
std::string quoted(const std::string &text)
{
    std::string result = "\"";
    for (const char c : text)
        result += c == '"' ? std::string("\\\"") : std::string(1, c);
    return result + "\"";
}

std::string listed(const Attributes &attributes)
{
    std::string text = " [";
    for (const auto &[name, value] : attributes)
        text += (text.size() > 2 ? "," : "") + name + "=" + quoted(value);
    return text + "]\n";
}

void set(Attributes &attributes, const char *name, const std::string &value)
{
    for (auto &[known, old] : attributes)
        if (known == name)
        {
            old = value;
            return;
        }
    attributes.emplace_back(name, value);
}

/// Runs one of Graphviz' programs. The C library's allocator is told to keep what it has: giving memory back
/// and forth makes drawing PDFs take quadratic time.
void runGraphviz(std::vector<std::string> arguments, const std::filesystem::path &folder,
                 std::chrono::milliseconds limit)
{
    const std::string program = arguments.front();
    arguments.insert(arguments.begin(), {"env", "MALLOC_TRIM_THRESHOLD_=4294967296",
                                         "MALLOC_MMAP_THRESHOLD_=4294967296", "MALLOC_TOP_PAD_=268435456"});
    arguments.emplace_back(kInput);
    const ProcessResult result = runProcess(arguments, folder, limit);
    constexpr int kNoSuchProgram = 127;
    if (!result.started || result.exitCode == kNoSuchProgram)
        throw DrawingError("Graphviz' program " + program +
                           " cannot be started; install it (Debian: graphviz) to get this picture");
    if (result.timedOut)
        throw DrawingError("Graphviz' program " + program + " did not end in time");
    if (!result.succeeded())
        throw DrawingError("Graphviz' program " + program + " failed" +
                           (result.exitCode < 0 ? " (it crashed)" : "") + ": " + oneLine(result.output));
}

std::string written(const std::filesystem::path &file)
{
    try
    {
        return readFile(file);
    }
    catch (const FileError &error)
    {
        throw DrawingError("Graphviz wrote no picture: " + error.complaint());
    }
}

} // namespace

std::string inches(double points)
{
    constexpr double kPointsAnInch = 72;
    return fmt::format("{:.4f}", points / kPointsAnInch);
}

struct GraphvizGraph::State
{
    struct Edge
    {
        std::size_t a = 0;
        std::size_t b = 0;
        Attributes attributes;
    };
    std::chrono::milliseconds limit{};
    std::array<Attributes, 3> defaults;
    std::vector<Attributes> nodes;
    std::vector<Edge> edges;

    [[nodiscard]] std::string dot() const
    {
        std::string text = "strict graph drawing {\n";
        for (const auto &[kind, name] :
             {std::pair{Kind::graph, "graph"}, {Kind::node, "node"}, {Kind::edge, "edge"}})
            text += name + listed(defaults[static_cast<std::size_t>(kind)]);
        for (std::size_t i = 0; i < nodes.size(); ++i)
            text += std::to_string(i) + listed(nodes[i]);
        for (const Edge &edge : edges)
            text += std::to_string(edge.a) + "--" + std::to_string(edge.b) + listed(edge.attributes);
        return text + "}\n";
    }
};

GraphvizGraph::GraphvizGraph(std::chrono::milliseconds limit) : state_(std::make_unique<State>())
{
    state_->limit = limit;
}
GraphvizGraph::~GraphvizGraph() = default;

void GraphvizGraph::setDefault(Kind kind, const char *name, const std::string &value)
{
    set(state_->defaults[static_cast<std::size_t>(kind)], name, value);
}

std::size_t GraphvizGraph::addNode()
{
    state_->nodes.emplace_back();
    return state_->nodes.size() - 1;
}

std::size_t GraphvizGraph::addEdge(std::size_t a, std::size_t b)
{
    state_->edges.push_back({a, b, {}});
    return state_->edges.size() - 1;
}

void GraphvizGraph::setNode(std::size_t node, const char *name, const std::string &value)
{
    set(state_->nodes[node], name, value);
}

void GraphvizGraph::setEdge(std::size_t edge, const char *name, const std::string &value)
{
    set(state_->edges[edge].attributes, name, value);
}

std::vector<Point> GraphvizGraph::arrange(const char *engine)
{
    constexpr double kPointsAnInch = 72;
    const TemporaryFolder folder;
    writeFile(folder.path() / kInput, state_->dot());
    runGraphviz({engine, "-Tplain", "-o", "places.txt"}, folder.path(), state_->limit);
    std::vector<Point> positions(state_->nodes.size());
    std::istringstream lines(written(folder.path() / "places.txt"));
    std::size_t placed = 0;
    for (std::string line; std::getline(lines, line);)
    {
        std::istringstream words(line);
        std::string kind;
        std::string name;
        std::string x;
        std::string y;
        words >> kind >> name >> x >> y;
        const auto node = parseInteger(name);
        if (kind != "node" || !node || static_cast<std::size_t>(*node) >= positions.size())
            continue;
        positions[static_cast<std::size_t>(*node)] = {kPointsAnInch * parseNumber(x).value_or(0),
                                                      kPointsAnInch * parseNumber(y).value_or(0), 0};
        ++placed;
    }
    if (placed != positions.size())
        throw DrawingError(std::string("Graphviz' layout engine ") + engine + " left vertices out");
    return positions;
}

Picture GraphvizGraph::renderPinned(int resolution)
{
    const TemporaryFolder folder;
    writeFile(folder.path() / kInput, state_->dot());
    runGraphviz({"neato", "-n2", "-Gdpi=" + std::to_string(resolution), "-Tpng", "-odrawing.png"},
                folder.path(), state_->limit);
    runGraphviz({"neato", "-n2", "-Gdpi=72", "-Tpdf", "-odrawing.pdf", "-Tsvg", "-odrawing.svg"},
                folder.path(), state_->limit);
    Picture picture{written(folder.path() / "drawing.png"), written(folder.path() / "drawing.pdf"),
                    written(folder.path() / "drawing.svg")};
    verify(picture);
    picture.pdf = withoutTimes(picture.pdf);
    return picture;
}

std::string GraphvizGraph::escaped(const std::string &label)
{
    std::string result;
    for (const char c : manyLines(label))
        if (c == '\\')
            result += "\\\\";
        else if (c == '&')
            result += "&amp;";
        else if (c == '\n')
            result += "\\n";
        else
            result += c;
    return result;
}

} // namespace mrpp

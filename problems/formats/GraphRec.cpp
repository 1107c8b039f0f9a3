#include "problems/formats/GraphRec.h"

#include <array>
#include <charconv>
#include <cmath>

namespace mrpp
{

namespace
{

class Writer
{
public:
    template <class... Parts>
    void line(const Parts &...parts)
    {
        (append(parts), ...);
        text_ += '\n';
    }

    [[nodiscard]] std::string take() { return std::move(text_); }

private:
    void append(std::string_view part) { text_ += part; }
    void append(char part) { text_ += part; }
    void append(std::uint64_t number)
    {
        std::array<char, 20> digits{};
        text_.append(digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr);
    }
    /// GraphRec reads no exponents.
    void append(double number)
    {
        std::array<char, 400> digits{};
        const double rounded = std::round(number * 100) / 100 + 0.0; // + 0.0 turns −0 into 0
        text_.append(digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), rounded,
                                                  std::chars_format::fixed, 2)
                                        .ptr);
    }

    std::string text_;
};

/// How many units of GraphRec one unit of the coordinates takes, for neighbours to lie well apart on average.
double scaleOf(const Graph &graph)
{
    constexpr double wanted = 60;
    double total = 0;
    const auto edges = graph.edges();
    for (const Graph::Edge &edge : edges)
    {
        const Point &a = graph.coordinate(edge.a);
        const Point &b = graph.coordinate(edge.b);
        total += std::hypot(a.x - b.x, a.y - b.y);
    }
    const double scale = wanted * static_cast<double>(edges.size()) / total;
    return std::isfinite(scale) && scale > 0 ? scale : wanted;
}

void writePositions(Writer &out, const Graph &graph)
{
    const double scale = scaleOf(graph);
    const double down = graph.yAxis() == YAxis::down ? scale : -scale;
    out.line("POS =");
    for (Vertex v = 0; v < graph.vertexCount(); ++v)
        out.line(std::uint64_t{v} + 1, ":X", graph.coordinate(v).x * scale, ":Y",
                 graph.coordinate(v).y * down);
}

} // namespace

std::string formatGraphRec(const Instance &instance, const Schedule &schedule)
{
    const Graph &graph = *instance.graph;
    std::vector<std::uint64_t> robotAt(graph.vertexCount(), 0);
    std::vector<std::uint64_t> goalOf(graph.vertexCount(), 0);
    for (std::size_t r = 0; r < instance.robotCount(); ++r)
    {
        robotAt[instance.starts[r]] = r + 1;
        goalOf[instance.goals[r]] = r + 1;
    }

    Writer out;
    out.line("id:1");
    out.line("V =");
    for (Vertex v = 0; v < graph.vertexCount(); ++v)
        out.line('(', std::uint64_t{v} + 1, ":0)[", robotAt[v], ':', goalOf[v], ':', goalOf[v], ']');
    out.line("E =");
    for (const Graph::Edge &edge : graph.edges())
        out.line('{', std::uint64_t{edge.a} + 1, ',', std::uint64_t{edge.b} + 1, "} (0)");
    out.line("MOD =");
    out.line("M:TRANSITIVE");
    if (graph.hasCoordinates())
        writePositions(out, graph);
    out.line("Solution");
    std::uint64_t written = 0;
    for (std::size_t s = 0; s < schedule.makespan(); ++s)
    {
        for (const Move &move : schedule.step(s))
            out.line(std::uint64_t{move.from} + 1, " ---> ", std::uint64_t{move.to} + 1, " (", written, ')');
        written += schedule.step(s).empty() ? 0 : 1;
    }
    out.line("Length:", std::uint64_t{schedule.pathLength()});
    return out.take();
}

} // namespace mrpp

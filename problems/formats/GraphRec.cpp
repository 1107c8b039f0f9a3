#include "problems/formats/GraphRec.h"

#include "framework/model/DrawingCoordinates.h"
#include "framework/support/Error.h"
#include "problems/formats/support/TextWriter.h"

#include <algorithm>
#include <cmath>

namespace mrpp
{

namespace
{

/// How many units of GraphRec one unit of the coordinates takes, for neighbours to lie well apart on average.
double scaleOf(const Graph &graph, const std::vector<Point> &points)
{
    constexpr double wanted = 60;
    constexpr double largest = 1e9; // of what is written
    double total = 0;
    double extent = 0;
    const auto edges = graph.edges();
    for (const Graph::Edge &edge : edges)
        total += std::hypot(points[edge.a].x - points[edge.b].x, points[edge.a].y - points[edge.b].y);
    for (const Point &point : points)
        extent = std::max({extent, std::abs(point.x), std::abs(point.y)});
    const double scale = wanted * static_cast<double>(edges.size()) / total;
    const double scaled = std::isfinite(scale) && scale > 0 ? scale : wanted;
    return extent > 0 ? std::min(scaled, largest / extent) : scaled;
}

class Writer
{
public:
    Writer(const Instance &instance, const Schedule &schedule, MotionRule rule, const TextSink &sink)
        : instance_(instance), graph_(*instance.graph), schedule_(schedule),
          follows_(rule >= MotionRule::following), sink_(sink)
    {
        if (!graph_.hasCoordinates())
            return;
        points_ = drawingCoordinates(graph_);
        scale_ = scaleOf(graph_, points_);
    }

    void writeText()
    {
        const std::vector<std::uint64_t> robotAt = owners(instance_.starts);
        const std::vector<std::uint64_t> goalOf = owners(instance_.goals);
        out_.line("id:1");
        out_.line("V =");
        for (Vertex v = 0; v < graph_.vertexCount(); ++v)
            line('(', id(v), ":0)[", robotAt[v], ':', goalOf[v], ':', goalOf[v], ']');
        out_.line("E =");
        for (const Graph::Edge &edge : graph_.edges())
            line('{', id(edge.a), ',', id(edge.b), "} (0)");
        out_.line("MOD =");
        out_.line(follows_ ? "M:TRANSITIVE" : "M:IMMEDIATE");
        if (graph_.hasCoordinates())
        {
            out_.line("POS =");
            for (Vertex v = 0; v < graph_.vertexCount(); ++v)
            {
                out_.add(id(v), ":X");
                out_.addFixed(x(v));
                out_.add(":Y");
                out_.addFixed(y(v));
                line();
            }
        }
        out_.line("Solution");
        forEachMove([&](std::uint64_t step, const Move &move)
                    { line(id(move.from), " ---> ", id(move.to), " (", step, ')'); });
        out_.line("Length:", std::uint64_t{schedule_.pathLength()});
        flush();
    }

    void writeXml()
    {
        const std::vector<std::uint64_t> robotAt = owners(instance_.starts);
        out_.line("<!DOCTYPE graphrec>");
        out_.line("<graphrec version=\"1.0\">");
        out_.line("  <solution id=\"1\">");
        out_.line("    <graph>");
        for (std::uint64_t robot = 1; robot <= instance_.robotCount(); ++robot)
            line("      <entity id=\"", robot, "\"/>");
        for (Vertex v = 0; v < graph_.vertexCount(); ++v)
        {
            out_.add("      <node id=\"", id(v), '"');
            if (robotAt[v] != 0)
                out_.add(" ent=\"", robotAt[v], '"');
            if (graph_.hasCoordinates())
            {
                out_.add(" x=\"");
                out_.addFixed(x(v));
                out_.add("\" y=\"");
                out_.addFixed(y(v));
                out_.add('"');
            }
            line("/>");
        }
        for (const Graph::Edge &edge : graph_.edges())
            line("      <edge n1=\"", id(edge.a), "\" n2=\"", id(edge.b), "\"/>");
        out_.line("    </graph>");
        out_.line("    <scenario validator=\"", follows_ ? "Multirobot" : "Pebble", "\">");
        forEachMove(
            [&](std::uint64_t step, const Move &move) {
                line("      <move tms=\"", step, "\" src=\"", id(move.from), "\" dst=\"", id(move.to),
                     "\"/>");
            });
        out_.line("    </scenario>");
        out_.line("  </solution>");
        out_.line("</graphrec>");
        flush();
    }

private:
    static std::uint64_t id(Vertex v) { return std::uint64_t{v} + 1; }

    /// For each vertex the robot, from 1, whose place it is; 0 for nobody.
    [[nodiscard]] std::vector<std::uint64_t> owners(const std::vector<Vertex> &places) const
    {
        std::vector<std::uint64_t> owner(graph_.vertexCount(), 0);
        for (std::size_t robot = 0; robot < places.size(); ++robot)
            owner[places[robot]] = robot + 1;
        return owner;
    }

    [[nodiscard]] double x(Vertex v) const { return rounded(points_[v].x * scale_); }
    [[nodiscard]] double y(Vertex v) const
    {
        return rounded(points_[v].y * (graph_.yAxis() == YAxis::down ? scale_ : -scale_));
    }
    static double rounded(double value)
    {
        return std::round(value * 100) / 100 + 0.0; // + 0.0 turns −0 into 0
    }

    template <class Visitor>
    void forEachMove(Visitor &&visit)
    {
        std::uint64_t written = 0;
        for (std::size_t s = 0; s < schedule_.makespan(); ++s)
        {
            for (const Move &move : schedule_.step(s))
                visit(written, move);
            written += schedule_.step(s).empty() ? 0 : 1;
        }
    }

    template <class... Parts>
    void line(const Parts &...parts)
    {
        constexpr std::size_t piece = 1 << 16;
        out_.line(parts...);
        if (out_.size() >= piece)
            flush();
    }

    void flush()
    {
        sink_(out_.text());
        out_.clear();
    }

    const Instance &instance_;
    const Graph &graph_;
    const Schedule &schedule_;
    bool follows_;
    std::vector<Point> points_; ///< none where the graph has none
    double scale_ = 1;
    const TextSink &sink_;
    TextWriter out_;
};

} // namespace

void writeGraphRec(const Instance &instance, const Schedule &schedule, MotionRule rule, GraphRecForm form,
                   const TextSink &sink)
{
    Writer writer(instance, schedule, rule, sink);
    if (form == GraphRecForm::text)
        writer.writeText();
    else
        writer.writeXml();
}

std::string formatGraphRec(const Instance &instance, const Schedule &schedule, MotionRule rule,
                           GraphRecForm form)
{
    std::string text;
    writeGraphRec(instance, schedule, rule, form, [&text](std::string_view piece) { text += piece; });
    return text;
}

SolutionRows graphRecRows(const GraphRecFile &file, const Instance &instance)
{
    if (file.graph->vertexCount() != instance.graph->vertexCount())
        throw ParseError({file.file}, "the graph in this file has " +
                                          std::to_string(file.graph->vertexCount()) +
                                          " vertices, but the instance's has " +
                                          std::to_string(instance.graph->vertexCount()));
    std::vector<GraphRecFile::TimedEdge> moves = file.moves;
    std::stable_sort(moves.begin(), moves.end(),
                     [](const auto &a, const auto &b) { return a.step < b.step; });
    std::vector<Robot> occupant(instance.graph->vertexCount(), kNoRobot);
    for (std::size_t robot = 0; robot < instance.robotCount(); ++robot)
        occupant[instance.starts[robot]] = static_cast<Robot>(robot);

    SolutionRows rows;
    rows.file = file.file;
    for (std::size_t first = 0; first < moves.size();)
    {
        std::size_t last = first;
        for (; last < moves.size() && moves[last].step == moves[first].step; ++last)
        {
            const GraphRecFile::TimedEdge &move = moves[last];
            const Robot robot = occupant[move.from];
            if (robot == kNoRobot)
                throw ParseError({file.file, move.line}, "nobody stands on vertex " +
                                                             std::to_string(move.from) + " in step " +
                                                             std::to_string(move.step));
            rows.moves.push_back({move.step, robot, move.from, move.to});
            rows.lines.push_back(move.line);
        }
        for (std::size_t i = first; i < last; ++i)
            occupant[moves[i].from] = kNoRobot;
        for (std::size_t i = first; i < last; ++i)
            occupant[moves[i].to] = static_cast<Robot>(rows.moves[i].robot);
        first = last;
    }
    return rows;
}

} // namespace mrpp

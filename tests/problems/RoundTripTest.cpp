/// From every format that is read to every format that is written, over random graphs, instances and
/// solutions: what comes out is what went in, but for what the conversion says is lost. The formats are those
/// of fileFormats(), so that a new one is tested without being named here.

#include "problems/formats/Conversion.h"
#include "problems/formats/Formats.h"

#include "framework/evaluation/Validator.h"
#include "framework/support/Error.h"
#include "tests/support/RandomCases.h"

#include <algorithm>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <numeric>
#include <set>
#include <unistd.h>

namespace mrpp
{
namespace
{

using testing::HasSubstr;

/// Every third cell of a small grid is missing, and the graph need not be connected.
std::shared_ptr<const Graph> cells(Random &random)
{
    const std::size_t width = 2 + random.below(5);
    const std::size_t height = 2 + random.below(4);
    std::string text =
        "type octile\nheight " + std::to_string(height) + "\nwidth " + std::to_string(width) + "\nmap\n";
    for (std::size_t cell = 0; cell < width * height; ++cell)
    {
        text += cell > 1 && random.below(3) == 0 ? '@' : '.';
        if (cell % width == width - 1)
            text += '\n';
    }
    return parseMovingAiMap(text, "cells").graph;
}

/// The same with other numbers.
std::shared_ptr<const Graph> shuffled(const Graph &graph, Random &random)
{
    std::vector<Vertex> number(graph.vertexCount());
    std::iota(number.begin(), number.end(), Vertex{0});
    random.shuffleFront(std::span(number), number.size());
    std::vector<Graph::Edge> edges = graph.edges();
    for (Graph::Edge &edge : edges)
        edge = {number[edge.a], number[edge.b], edge.weight};
    std::vector<Point> points(number.size());
    for (Vertex v = 0; v < number.size(); ++v)
        points[number[v]] = graph.coordinate(v);
    return Graph::fromEdges(number.size(), edges, points, graph.yAxis());
}

/// A random graph, the next time without coordinates, the next time with weights.
std::shared_ptr<const Graph> anyGraph(Random &random, std::size_t kind)
{
    const auto plain =
        test::randomConnectedGraph(2 + random.below(12), random.below(6), random.below(1000000));
    std::vector<Graph::Edge> edges = plain->edges();
    std::vector<Point> points;
    for (Vertex v = 0; kind > 0 && v < plain->vertexCount(); ++v)
        points.push_back({static_cast<double>(random.below(1000)) / 7, -static_cast<double>(random.below(9)),
                          kind > 1 ? static_cast<double>(random.below(3)) : 0});
    for (Graph::Edge &edge : edges)
        edge.weight = kind > 1 ? 1 + static_cast<double>(random.below(100)) / 3 : 1;
    return Graph::fromEdges(plain->vertexCount(), edges, points, kind > 1 ? YAxis::down : YAxis::up);
}

enum class Thing
{
    graph,
    instance,
    solution,
};

/// What was read, as far as the format has it.
struct Read
{
    std::shared_ptr<const Graph> graph; ///< of a solution it is the instance's, not the file's
    std::optional<Instance> instance;
    std::optional<Schedule> schedule;
};

bool has(const std::vector<std::string> &notes, const std::string &begin)
{
    return std::any_of(notes.begin(), notes.end(),
                       [&](const std::string &note) { return note.starts_with(begin); });
}

class RoundTrip : public testing::TestWithParam<Thing>
{
protected:
    void SetUp() override
    {
        folder_ =
            std::filesystem::path(testing::TempDir()) / ("mrpp_round_trip_" + std::to_string(::getpid()) +
                                                         "_" + std::to_string(static_cast<int>(GetParam())));
    }
    void TearDown() override { std::filesystem::remove_all(folder_); }

    [[nodiscard]] bool holdsThing(const FileFormat &format) const
    {
        switch (GetParam())
        {
        case Thing::graph:
            return format.holds == "graph"; // others need robots, too
        case Thing::instance:
            return format.holds.ends_with("instance");
        default:
            return format.holds == "solution" || format.holds == "animation";
        }
    }

    /// The name of a scenario of the tracker, which is asked for it.
    [[nodiscard]] std::filesystem::path instanceFile() const { return folder_ / "case-even-1.scen"; }

    ConversionRequest request(const std::filesystem::path &in, const std::filesystem::path &out,
                              const std::string &format) const
    {
        ConversionRequest result{in, out, std::nullopt, std::nullopt, format};
        if (GetParam() == Thing::solution)
            result.instance = instanceFile();
        return result;
    }

    [[nodiscard]] Read read(const std::filesystem::path &file) const
    {
        if (GetParam() == Thing::graph)
            return {loadGraph(file).graph, std::nullopt, std::nullopt};
        const LoadedInstance loaded =
            loadInstance({GetParam() == Thing::instance ? file : instanceFile(), std::nullopt, std::nullopt});
        if (GetParam() == Thing::instance)
            return {loaded.instance.graph, loaded.instance, std::nullopt};
        return {nullptr, std::nullopt, scheduleOf(loadSolution(file, loaded), loaded.instance)};
    }

    /// Expects the same but for what the notes say.
    static void expectSame(const Read &a, const Read &b, const std::vector<std::string> &notes)
    {
        if (has(notes, "lost: the vertices' numbers"))
            return; // a map's cells have their order; ConversionTest looks at them
        if (a.graph)
            expectSameGraph(*a.graph, *b.graph, notes);
        if (a.instance)
        {
            EXPECT_EQ(a.instance->starts, b.instance->starts);
            EXPECT_EQ(a.instance->goals, b.instance->goals);
        }
        if (!a.schedule)
            return;
        ASSERT_EQ(a.schedule->makespan(), b.schedule->makespan());
        for (std::size_t step = 0; step < a.schedule->makespan(); ++step)
            EXPECT_TRUE(std::ranges::is_permutation(a.schedule->step(step), b.schedule->step(step)));
    }

    static void expectSameGraph(const Graph &a, const Graph &b, const std::vector<std::string> &notes)
    {
        const bool weights = !has(notes, "lost: the edges' weights");
        ASSERT_EQ(a.vertexCount(), b.vertexCount());
        const auto before = a.edges();
        const auto after = b.edges();
        ASSERT_EQ(before.size(), after.size());
        for (std::size_t i = 0; i < before.size(); ++i)
        {
            EXPECT_EQ(std::pair(before[i].a, before[i].b), std::pair(after[i].a, after[i].b));
            EXPECT_EQ(weights ? before[i].weight : 1, after[i].weight);
        }
        const bool coordinates = a.hasCoordinates() && !has(notes, "lost: the vertices' coordinates");
        ASSERT_EQ(coordinates, b.hasCoordinates());
        if (!coordinates)
            return;
        for (Vertex v = 0; v < a.vertexCount(); ++v)
        {
            Point point = a.coordinate(v);
            point.z = has(notes, "lost: the vertices' heights") ? 0 : point.z;
            EXPECT_EQ(point, b.coordinate(v)) << v;
        }
        EXPECT_EQ(a.yAxis() == b.yAxis(), !has(notes, "changed: the direction of y"));
    }

    /// Writes the case in the program's own formats; gives the file that holds the thing.
    std::filesystem::path writeCase(std::shared_ptr<const Graph> graph, Random &random)
    {
        std::filesystem::remove_all(folder_);
        std::filesystem::create_directories(folder_);
        const auto graphFile = folder_ / "case.graphml";
        saveGraph(graphFile, *graph);
        if (GetParam() == Thing::graph)
            return graphFile;
        const std::size_t robots = 1 + random.below(std::max<std::size_t>(graph->vertexCount() / 2, 1));
        const auto rule = random.below(2) == 0 ? MotionRule::rotation : MotionRule::parallel;
        const auto made = test::randomScheduledCase(std::move(graph), robots, 6, rule, random.below(1000000));
        // instance text whatever the name says: it is the contents that count
        saveInstance(instanceFile(), made.instance, graphFile, InstanceForm::text);
        if (GetParam() == Thing::instance)
            return instanceFile();
        FileSet files;
        saveSolution(files, folder_ / "case.csv", made.schedule);
        files.commit();
        return folder_ / "case.csv";
    }

    /// Through every pair of formats; counts the formats that were written and read again.
    void goThroughAll(const std::filesystem::path &file, bool allExpressIt)
    {
        const Read first = read(file);
        for (const FileFormat &from : fileFormats())
        {
            if (!holdsThing(from) || !from.writes)
                continue;
            SCOPED_TRACE(from.name);
            const auto source = folder_ / (from.name + "-1.scen");
            const auto made = convert(request(file, source, from.name), allExpressIt);
            if (!made || !from.reads)
                continue;
            Read read1;
            ASSERT_NO_FATAL_FAILURE(check(first, source, made->notes, read1));
            tested_.insert(from.name);
            const bool lossless = allExpressIt && (!read1.graph || read1.graph->hasCoordinates());
            for (const FileFormat &to : fileFormats())
            {
                if (!holdsThing(to) || !to.writes || !to.reads)
                    continue;
                SCOPED_TRACE("to " + to.name);
                const auto target = folder_ / (from.name + "." + to.name + "-2.scen");
                const auto again = convert(request(source, target, to.name), lossless);
                Read read2;
                if (again)
                {
                    ASSERT_NO_FATAL_FAILURE(check(read1, target, again->notes, read2));
                }
            }
        }
    }

    void check(const Read &before, const std::filesystem::path &file, const std::vector<std::string> &notes,
               Read &after)
    {
        try
        {
            after = read(file);
        }
        catch (const InputError &error)
        {
            FAIL() << "what was written is not read: " << error.what();
        }
        expectSame(before, after, notes);
    }

    static std::optional<Conversion> convert(const ConversionRequest &request, bool expressible)
    {
        try
        {
            return convertFile(request);
        }
        catch (const InputError &error)
        {
            EXPECT_FALSE(expressible) << error.what();
            EXPECT_THAT(error.what(), HasSubstr("cannot hold this"));
            return std::nullopt;
        }
    }

    std::filesystem::path folder_;
    std::set<std::string> tested_;
};

TEST_P(RoundTrip, ReadsWhatItWrites)
{
    Random random(static_cast<Seed>(GetParam()) + 1);
    for (std::size_t i = 0; i < 2; ++i)
    {
        const auto map = cells(random); // which every format can express
        ASSERT_NO_FATAL_FAILURE(goThroughAll(writeCase(map, random), true));
        ASSERT_NO_FATAL_FAILURE(goThroughAll(writeCase(shuffled(*map, random), random), true));
        for (std::size_t kind = 0; kind < 3; ++kind)
            ASSERT_NO_FATAL_FAILURE(goThroughAll(writeCase(anyGraph(random, kind), random), false));
    }
    for (const FileFormat &format : fileFormats())
        if (holdsThing(format) && format.reads && format.writes)
        {
            EXPECT_TRUE(tested_.contains(format.name)) << format.name;
        }
}

INSTANTIATE_TEST_SUITE_P(Of, RoundTrip, testing::Values(Thing::graph, Thing::instance, Thing::solution),
                         [](const auto &row) {
                             return row.param == Thing::graph      ? "Graphs"
                                    : row.param == Thing::instance ? "Instances"
                                                                   : "Solutions";
                         });

} // namespace
} // namespace mrpp

#pragma once
/// \file
/// Puts a GraphRec file together from what its text or XML says. Internal to the two readers.

#include "problems/formats/GraphRec.h"

#include <map>
#include <optional>
#include <unordered_map>

namespace mrpp
{

class GraphRecBuilder
{
public:
    explicit GraphRecBuilder(std::string file) { result_.file = std::move(file); }

    /// Each says what is wrong, in words; nothing where all is well. Numbers are the file's.
    [[nodiscard]] std::optional<std::string> addVertex(std::int64_t id);
    [[nodiscard]] std::optional<std::string> setStart(std::int64_t vertex, std::int64_t robot);
    [[nodiscard]] std::optional<std::string> setGoal(std::int64_t vertex, std::int64_t robot);
    [[nodiscard]] std::optional<std::string> setPosition(std::int64_t vertex, double x, double y);
    [[nodiscard]] std::optional<std::string> addEdge(std::int64_t a, std::int64_t b);
    [[nodiscard]] std::optional<std::string> addMove(std::int64_t step, std::int64_t from, std::int64_t to,
                                                     std::size_t line);

    [[nodiscard]] GraphRecFile take();

private:
    [[nodiscard]] std::optional<Vertex> vertex(std::int64_t id) const;
    static std::string missing(std::int64_t id);

    GraphRecFile result_;
    std::unordered_map<std::int64_t, Vertex> vertices_;
    std::map<std::int64_t, Vertex> starts_; ///< by robot, as are the goals
    std::map<std::int64_t, Vertex> goals_;
    std::vector<Graph::Edge> edges_;
    std::vector<Point> points_;
    std::vector<bool> hasPoint_;
    std::size_t pointCount_ = 0;
};

} // namespace mrpp

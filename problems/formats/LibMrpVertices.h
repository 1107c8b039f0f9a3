#pragma once
/// \file
/// How libMultiRobotPlanning's YAML calls vertices and robots. Internal to its readers and writers.

#include "framework/support/Config.h"
#include "problems/formats/MovingAiMap.h"

#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <unordered_map>

namespace mrpp
{

/// A word as YAML; a text of JSON is one of YAML.
inline std::string asYaml(const std::string &text)
{
    return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

/// The name of a robot, as YAML: its own, or agent0, agent1, ….
inline std::string libMrpRobot(std::size_t robot, std::span<const std::string> names)
{
    return names.empty() ? "agent" + std::to_string(robot) : asYaml(names[robot]);
}

/// How a roadmap's vertices are called: by names, or by their numbers where there are none.
class LibMrpVertices
{
public:
    LibMrpVertices(std::size_t count, std::span<const std::string> names) : count_(count), names_(names)
    {
        for (const std::string &name : names)
            vertices_.emplace(name, static_cast<Vertex>(vertices_.size()));
    }

    /// kNoVertex where none is called so.
    [[nodiscard]] Vertex vertex(const std::string &name) const
    {
        if (!names_.empty())
        {
            const auto found = vertices_.find(name);
            return found == vertices_.end() ? kNoVertex : found->second;
        }
        const auto number = parseInteger(name);
        const bool isVertex = number && *number >= 0 && static_cast<std::uint64_t>(*number) < count_;
        return isVertex ? static_cast<Vertex>(*number) : kNoVertex;
    }

    [[nodiscard]] std::string text(Vertex v) const
    {
        return names_.empty() ? std::to_string(v) : asYaml(names_[v]);
    }

private:
    std::size_t count_;
    std::span<const std::string> names_;
    std::unordered_map<std::string, Vertex> vertices_;
};

} // namespace mrpp

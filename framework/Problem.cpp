#include "framework/Problem.h"

#include "framework/analysis/Components.h"
#include "framework/support/CanonicalSettings.h"
#include "framework/support/Error.h"
#include "framework/support/Suggestion.h"

#include <cmath>

namespace mrpp
{

std::filesystem::path ProblemContext::resolve(const std::filesystem::path &file) const
{
    if (file.is_absolute())
        return file;
    for (const std::filesystem::path &folder : searchPaths)
    {
        std::error_code error;
        if (std::filesystem::exists(folder / file, error))
            return (folder / file).lexically_normal();
    }
    return searchPaths.empty() ? file : (searchPaths.front() / file).lexically_normal();
}

std::optional<RobotCount::By> RobotCount::key(std::string_view name)
{
    if (name == "robots")
        return By::robots;
    if (name == "free")
        return By::free;
    if (name == "occupancy")
        return By::occupancy;
    return std::nullopt;
}

std::size_t RobotCount::resolve(std::size_t vertices) const
{
    const auto capacity = static_cast<double>(vertices);
    double count = value;
    if (by == By::free)
        count = capacity - value;
    else if (by == By::occupancy)
        count = std::floor(value * capacity + 1e-9); // 0.98 · 50 is 49, not 48.999…
    if (value < 0 || count < 0 || count > capacity || (by != By::occupancy && value != std::floor(value)))
    {
        const char *name = by == By::robots ? "robots" : by == By::free ? "free" : "occupancy";
        throw DoesNotFit(std::string(name) + " = " + formatNumber(value) + " does not fit a graph of " +
                         std::to_string(vertices) + " vertices");
    }
    return static_cast<std::size_t>(count);
}

void Problem::configure(const Config &settings, const ProblemContext &context)
{
    context_ = context;
    robots_.reset();
    std::vector<Config::Entry> own;
    const auto setParameter =
        [this](const std::string &name, const SourceLocation &nameWhere, const Config &value)
    {
        if (parameters_.find(name) == nullptr)
        {
            auto known = parameters_.names();
            if (takesRobotCount())
                known.insert(known.end(), {"robots", "free", "occupancy"});
            throw PlanError(nameWhere, "unknown key '" + name + "'" + suggestion(name, known));
        }
        if (value.isMap() && configureMap(name, value))
            return;
        if (!value.isScalar())
            throw PlanError(value.where(), "'" + name + "' takes one value");
        try
        {
            parameters_.set(name, value.text());
        }
        catch (const ParamError &error)
        {
            throw PlanError(value.where(), error.complaint());
        }
    };

    if (settings.isScalar() && !parameters_.all().empty())
    {
        const std::string &name = parameters_.all().front().name;
        setParameter(name, settings.where(), settings);
        own.push_back({name, settings.where(), settings});
    }
    else if (settings.isMap())
    {
        for (const Config::Entry &entry : settings.entries())
        {
            const auto by = takesRobotCount() ? RobotCount::key(entry.key) : std::nullopt;
            if (!by)
            {
                setParameter(entry.key, entry.where, entry.value);
                own.push_back(entry);
                continue;
            }
            if (robots_)
                throw PlanError(entry.where,
                                "'" + entry.key +
                                    "' says a second time how many robots there are; give one of "
                                    "robots, free, occupancy");
            robots_ = RobotCount{*by, entry.value.number()};
            if (robots_->value < 0 || (*by == RobotCount::By::occupancy && robots_->value > 1))
                throw PlanError(entry.value.where(), *by == RobotCount::By::occupancy
                                                         ? "an occupancy lies between 0 and 1"
                                                         : "'" + entry.key + "' cannot be negative");
            if (*by != RobotCount::By::occupancy && robots_->value != std::floor(robots_->value))
                throw PlanError(entry.value.where(), "'" + entry.key + "' takes a whole number");
        }
    }
    else
    {
        throw PlanError(settings.where(), "a problem takes a map of settings");
    }
    identity_ = canonicalSettings(Config::map(std::move(own)), parameters_);
}

std::string Problem::defaults() const
{
    std::string text = "version " + std::to_string(version());
    for (const ParameterSet::Parameter &parameter : parameters_.all())
        if (const std::string value = parameter.value(); value == parameter.defaultValue)
            text.append(", ").append(parameter.name).append("=").append(value);
    return text;
}

std::size_t Problem::robotCount(const Graph &graph) const
{
    if (!robots_)
        throw InputError("problem '" + name() +
                         "' does not say how many robots there are; give robots, free or "
                         "occupancy");
    return robots_->resolve(graph.vertexCount());
}

Instance Problem::makeInstance(std::shared_ptr<const Graph> graph, std::size_t robots, Seed seed) const
{
    return randomInstance(std::move(graph), robots, seed);
}

Instance randomInstance(std::shared_ptr<const Graph> graph, std::size_t robots, Seed seed)
{
    const Components components(*graph);
    std::vector<Vertex> vertices = components.vertices(components.largest());
    if (robots > vertices.size())
        throw DoesNotFit(std::to_string(robots) + " robots do not fit the largest component, which has " +
                         std::to_string(vertices.size()) + " of the graph's " +
                         std::to_string(graph->vertexCount()) + " vertices");
    const auto draw = [&](std::string_view role)
    {
        std::vector<Vertex> drawn = vertices;
        Random random(deriveSeed(seed, role));
        random.shuffleFront(std::span(drawn), robots);
        drawn.resize(robots);
        return drawn;
    };
    return {std::move(graph), draw("starts"), draw("goals")};
}

} // namespace mrpp

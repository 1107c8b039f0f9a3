/// \file
/// `map_check`: the whole run, whose result stands in docs/maps.md.

#include "framework/Problem.h"
#include "framework/analysis/Components.h"
#include "framework/support/Config.h"
#include "problems/formats/MovingAiMap.h"
#include "tests/contract/EverythingRegistered.h"
#include "tests/maps/MapCheck.h"

#include <fmt/core.h>

#include <cstdio>
#include <iostream>
#include <optional>

namespace
{

using namespace mrpp;

constexpr const char *kUsage =
    R"(map_check [--maps FOLDER] [--filter TEXT] [--robots N]... [--planner NAME]... [--seeds N] [--first N]
          [--least 9000] [--limit 120] [--paths 300]
Planners with random robots on every map of at least so many vertices below the folder whose path contains the text, and the path
search alone. Times are multiples of one breadth-first search of the map in the same run.
)";

struct Settings
{
    std::filesystem::path maps = std::filesystem::path(MRPP_SHARED_DATA) / "movingai";
    std::string filter;
    std::vector<std::size_t> robots;
    std::vector<std::string> planners;
    std::uint64_t seeds = 1;
    std::uint64_t first = 1;
    std::size_t least = 9000;
    std::size_t limit = 120;
    std::size_t paths = 300;
};

std::optional<Settings> parse(int count, char **words)
{
    Settings settings;
    for (int i = 1; i + 1 < count; i += 2)
    {
        const std::string option = words[i];
        const std::string text = words[i + 1];
        const auto number = static_cast<std::uint64_t>(parseInteger(text).value_or(0));
        if (option == "--maps")
            settings.maps = text;
        else if (option == "--filter")
            settings.filter = text;
        else if (option == "--planner")
            settings.planners.push_back(text);
        else if (option == "--robots")
            settings.robots.push_back(number);
        else if (option == "--seeds")
            settings.seeds = number;
        else if (option == "--first")
            settings.first = number;
        else if (option == "--least")
            settings.least = number;
        else if (option == "--limit")
            settings.limit = number;
        else if (option == "--paths")
            settings.paths = number;
        else
            return std::nullopt;
    }
    if (count % 2 == 0)
        return std::nullopt;
    if (settings.planners.empty())
        settings.planners = {"push_and_rotate", "push_and_swap"};
    return settings;
}

} // namespace

int main(int count, char **words)
{
    const auto settings = parse(count, words);
    if (!settings)
    {
        std::cerr << kUsage;
        return 2;
    }
    const Catalog catalog = test::everythingRegistered();
    for (const auto &file : test::mapsBelow(settings->maps))
    {
        const std::string name = file.lexically_relative(settings->maps).string();
        if (name.find(settings->filter) == std::string::npos)
            continue;
        const auto graph = readMovingAiMap(file).graph;
        if (graph->vertexCount() < settings->least)
            continue;
        for (std::uint64_t seed = settings->first; seed < settings->first + settings->seeds; ++seed)
        {
            for (const std::size_t robots : settings->robots)
            {
                const auto instance = std::make_shared<const Instance>(randomInstance(graph, robots, seed));
                for (const std::string &name2 : settings->planners)
                {
                    const auto planner = catalog.planners.create(name2);
                    const auto f =
                        test::measurePlanning(*planner, instance, static_cast<double>(settings->limit));
                    fmt::print("{:42} {:5} {:3} {:16} {:8} {:8.4f} {:8.0f} {:5.0f} {}\n", name, robots, seed,
                               name2, toString(f.status), f.ratio, f.searches, f.setupSearches, f.complaint);
                    std::fflush(stdout);
                }
            }
            if (settings->paths > 0)
            {
                const Instance instance = randomInstance(graph, settings->paths, seed);
                for (const double weight : {0.0, 1.0, 1.25, 1.5, 2.0})
                {
                    const auto f = test::measurePaths(instance, weight);
                    fmt::print("{:42} paths {:3} {:5} {:8.4f} {:10} visits {:6.2f} a step {:8.1f} BFS {}\n",
                               name, seed, weight,
                               static_cast<double>(f.length) / static_cast<double>(f.distance), f.visits,
                               static_cast<double>(f.visits) / static_cast<double>(f.distance), f.searches,
                               f.broken);
                    std::fflush(stdout);
                }
            }
        }
    }
}

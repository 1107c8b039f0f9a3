#include "cli/Commands.h"
#include "cli/Interruption.h"
#include "cli/WorkLine.h"
#include "problems/SolvableInstance.h"
#include "problems/WellFormedInstance.h"
#include "problems/formats/Formats.h"
#include "problems/formats/GraphMl.h"
#include "problems/generators/Generator.h"

#include <iostream>

namespace mrpp
{

namespace
{

Config settingsOf(const GenerateArguments &arguments)
{
    std::vector<Config::Entry> entries;
    for (const auto &[name, value] : arguments.settings)
    {
        Config::Entry &entry = entries.emplace_back();
        entry.key = name;
        entry.value = Config::scalar(value);
    }
    return Config::map(std::move(entries));
}

} // namespace

ExitCode generate(const GenerateArguments &arguments, const Catalog &catalog)
{
    FileSet files;
    WorkLine line;
    Interruption interruption(std::chrono::milliseconds(0), [&files] { files.abandon(); });
    const auto generator = makeGenerator(catalog, arguments.family);
    generator->configure(settingsOf(arguments), {.catalog = &catalog});
    const auto graph = generator->makeGraph(arguments.seed);
    std::optional<Instance> instance;
    if (arguments.instance)
    {
        const auto robots = static_cast<std::size_t>(*arguments.robots);
        instance = arguments.wellFormed ? wellFormedInstance(graph, robots, arguments.seed)
                   : arguments.solvable ? solvableInstance(graph, robots, arguments.seed)
                                        : generator->makeInstance(graph, robots, arguments.seed);
    }
    if (!arguments.graph)
    {
        std::cout << formatGraphMl(*graph);
        return ExitCode::done;
    }
    saveGraph(files, *arguments.graph, *graph);
    if (instance)
        saveInstance(files, *arguments.instance, *instance, *arguments.graph, std::nullopt, line.listener());
    files.commit();
    interruption.waitFromNowOn();
    line.clear();
    std::cout << generator->name() << ": " << graph->vertexCount() << " vertices, " << graph->edgeCount()
              << " edges" << (instance ? ", " + std::to_string(instance->robotCount()) + " robots" : "")
              << '\n';
    return ExitCode::done;
}

} // namespace mrpp

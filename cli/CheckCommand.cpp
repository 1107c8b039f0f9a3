#include "cli/Commands.h"
#include "framework/analysis/Solvability.h"
#include "problems/formats/Formats.h"

#include <nlohmann/json.hpp>

#include <iostream>

namespace mrpp
{

ExitCode check(const CheckArguments &arguments)
{
    const auto robots =
        arguments.robots ? std::optional(static_cast<std::size_t>(*arguments.robots)) : std::nullopt;
    const LoadedInstance loaded =
        loadInstance({arguments.instance, arguments.graph, robots, arguments.passability});
    for (const std::string &warning : loaded.warnings)
        std::cerr << "warning: " << warning << '\n';
    const Instance &instance = loaded.instance;
    const Solvability answer = solvability(instance, *motionRule(arguments.motion));
    if (arguments.json)
    {
        nlohmann::ordered_json object;
        object["solvable"] = answer.solvable;
        object["reason"] = answer.reason;
        object["motion"] = arguments.motion;
        object["vertices"] = instance.graph->vertexCount();
        object["edges"] = instance.graph->edgeCount();
        object["robots"] = instance.robotCount();
        object["free"] = instance.freeCount();
        std::cout << object.dump(2) << '\n';
    }
    else
    {
        std::cout << (answer.solvable ? "solvable" : "unsolvable: " + answer.reason) << '\n';
    }
    return answer.solvable ? ExitCode::done : ExitCode::no;
}

} // namespace mrpp

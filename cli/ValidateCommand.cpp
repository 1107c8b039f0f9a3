#include "cli/Commands.h"
#include "framework/evaluation/Validator.h"
#include "framework/support/Error.h"
#include "problems/formats/Formats.h"

#include <iostream>

namespace mrpp
{

ExitCode validate(const ValidateArguments &arguments)
{
    const auto robots =
        arguments.robots ? std::optional(static_cast<std::size_t>(*arguments.robots)) : std::nullopt;
    const LoadedInstance loaded =
        loadInstance({arguments.instance, arguments.graph, robots, arguments.passability});
    for (const std::string &warning : loaded.warnings)
        std::cerr << "warning: " << warning << '\n';
    const SolutionRows rows = loadSolution(arguments.solution, loaded);
    for (const std::string &warning : rows.warnings)
        std::cerr << "warning: " << warning << '\n';
    const Verdict verdict = validate(loaded.instance, rows.moves, *motionRule(arguments.motion));
    if (verdict.valid())
    {
        const std::int64_t steps = rows.moves.empty() ? 0 : rows.moves.back().step + 1;
        std::cout << "valid: " << rows.moves.size() << " moves in " << steps << " steps take all "
                  << loaded.instance.robotCount() << " robots to their goals (" << arguments.motion << ")\n";
        return ExitCode::done;
    }
    const SourceLocation where{rows.file, verdict.legal ? 0 : rows.lineOf(verdict.badMove), 0};
    std::cout << "invalid: " << where.toString() << ": " << verdict.violation << '\n';
    return ExitCode::no;
}

} // namespace mrpp

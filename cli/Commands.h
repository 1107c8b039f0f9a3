#pragma once
/// \file
/// The commands, one source each. They throw InputError for what the user can mend (exit code 2), and any
/// other exception for defects (3). Those that read a plan load its plugins into the catalog.

#include "cli/Arguments.h"
#include "cli/ExitCode.h"
#include "framework/Catalog.h"

#include <string>
#include <vector>

namespace mrpp
{

[[nodiscard]] ExitCode run(const RunArguments &arguments, Catalog &catalog);
[[nodiscard]] ExitCode report(const ReportArguments &arguments, Catalog &catalog);
[[nodiscard]] ExitCode compare(const CompareArguments &arguments, Catalog &catalog);
[[nodiscard]] ExitCode merge(const MergeArguments &arguments, Catalog &catalog);
[[nodiscard]] ExitCode replay(const ReplayArguments &arguments, Catalog &catalog);
[[nodiscard]] ExitCode slurm(const SlurmArguments &arguments, Catalog &catalog);
[[nodiscard]] ExitCode solve(const SolveArguments &arguments, const Catalog &catalog);
[[nodiscard]] ExitCode check(const CheckArguments &arguments);
[[nodiscard]] ExitCode validate(const ValidateArguments &arguments);
[[nodiscard]] ExitCode view(const ViewArguments &arguments);
[[nodiscard]] ExitCode convert(const ConvertArguments &arguments);
[[nodiscard]] ExitCode generate(const GenerateArguments &arguments, const Catalog &catalog);
[[nodiscard]] ExitCode list(const ListArguments &arguments, const Catalog &catalog);
/// What `run` starts for isolation `process`; not for people.
[[nodiscard]] ExitCode worker(Catalog &catalog);
/// How a campaign starts one, with the same plugins.
[[nodiscard]] std::vector<std::string> workerCommand(const Catalog &catalog);

} // namespace mrpp

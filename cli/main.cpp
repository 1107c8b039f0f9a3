#include "algorithms/Algorithms.h"
#include "cli/Arguments.h"
#include "cli/Commands.h"
#include "cli/Plugins.h"
#include "cli/SearchPaths.h"
#include "cli/StandardOutput.h"
#include "framework/Catalog.h"
#include "framework/support/Error.h"
#include "framework/support/ReadableText.h"
#include "problems/Problems.h"
#include "reports/Reports.h"

#include <csignal>
#include <iostream>
#include <new>
#include <system_error>
#include <unistd.h>
#include <variant>

namespace mrpp
{

namespace
{

/// One command with everything that it can name.
struct Dispatch
{
    Catalog &catalog;

    ExitCode operator()(const Answered &answered) const { return answered.code; }
    ExitCode operator()(const RunArguments &arguments) const { return run(arguments, catalog); }
    ExitCode operator()(const ReportArguments &arguments) const { return report(arguments, catalog); }
    ExitCode operator()(const CompareArguments &arguments) const { return compare(arguments, catalog); }
    ExitCode operator()(const MergeArguments &arguments) const { return merge(arguments, catalog); }
    ExitCode operator()(const ReplayArguments &arguments) const { return replay(arguments, catalog); }
    ExitCode operator()(const SlurmArguments &arguments) const { return slurm(arguments, catalog); }
    ExitCode operator()(const SolveArguments &arguments) const { return solve(arguments, catalog); }
    ExitCode operator()(const CheckArguments &arguments) const { return check(arguments); }
    ExitCode operator()(const ValidateArguments &arguments) const { return validate(arguments); }
    ExitCode operator()(const ViewArguments &arguments) const { return view(arguments); }
    ExitCode operator()(const ConvertArguments &arguments) const { return convert(arguments); }
    ExitCode operator()(const GenerateArguments &arguments) const { return generate(arguments, catalog); }
    ExitCode operator()(const ListArguments &arguments) const { return list(arguments, catalog); }
    ExitCode operator()(const WorkerArguments &) const { return worker(catalog); }
};

ExitCode dispatch(int count, const char *const *words)
{
    try
    {
        Catalog catalog;
        registerAlgorithms(catalog);
        registerProblems(catalog);
        registerReports(catalog);
        const std::vector<const char *> rest = takePlugins(count, words, catalog);
        return std::visit(Dispatch{catalog},
                          parseArguments(static_cast<int>(rest.size()), rest.data(), catalog));
    }
    catch (const InputError &error)
    {
        std::cerr << (error.where().file.empty() ? "mrppsim: " : "") << oneLine(error.what()) << '\n';
        return ExitCode::wrongUse;
    }
    catch (const std::bad_alloc &)
    {
        std::cerr << "mrppsim: there is not enough memory\n";
        return ExitCode::wrongUse;
    }
    catch (const std::system_error &error) // a name too long, no descriptor or thread left: the system's word
    {
        std::cerr << "mrppsim: " << oneLine(error.what()) << '\n';
        return ExitCode::wrongUse;
    }
    catch (const std::exception &error)
    {
        std::cerr << "mrppsim: a defect of the program: " << oneLine(error.what()) << '\n';
        return ExitCode::defect;
    }
}

} // namespace

} // namespace mrpp

int main(int count, char **words)
{
    // Where no Interruption listens, nothing has to be ended cleanly.
    for (const int signal : {SIGINT, SIGTERM})
        std::signal(signal, [](int) { ::_exit(static_cast<int>(mrpp::ExitCode::interrupted)); });
    std::signal(SIGPIPE, SIG_IGN); // gnuplot and pagers may go away; writes then fail and say so
    std::signal(SIGXFSZ, SIG_IGN); // so do those beyond the limit of a file's size
    mrpp::makeSearchPathsAbsolute();
    mrpp::StandardOutput output;
    return static_cast<int>(output.finish(mrpp::dispatch(count, words)));
}

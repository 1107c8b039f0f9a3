#include "cli/Commands.h"
#include "framework/worker/Worker.h"
#include "yaml/PlanReader.h"

#include <csignal>
#include <iostream>

namespace mrpp
{

ExitCode worker(Catalog &catalog)
{
    for (const int signal : {SIGINT, SIGTERM})
        std::signal(signal, SIG_DFL); // its campaign ends it
    const int code = serveRuns(catalog, [&catalog](const PlanSource &source)
                               { return parsePlan(source.text, source.file, catalog, source.mapFolders); });
    if (code == 3)
        std::cerr << "mrppsim: a worker is started by a campaign: mrppsim run PLAN\n";
    return code == 0 ? ExitCode::done : ExitCode::wrongUse;
}

std::vector<std::string> workerCommand(const Catalog &catalog)
{
    std::vector<std::string> words = {"/proc/self/exe",
                                      "worker"}; // this very program, even if its file is replaced
    for (const std::filesystem::path &plugin : catalog.plugins)
        words.insert(words.end(), {"--plugin", plugin.string()});
    return words;
}

} // namespace mrpp

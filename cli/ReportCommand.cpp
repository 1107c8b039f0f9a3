#include "cli/Commands.h"
#include "cli/Reporting.h"

namespace mrpp
{

ExitCode report(const ReportArguments &arguments, Catalog &catalog)
{
    const BenchmarkPlan plan = campaignPlan(arguments.folder, catalog);
    const std::vector<std::string> &kinds = arguments.only.empty() ? plan.reports : arguments.only;
    sayWhere(writeReports(plan, kinds, arguments.folder, catalog), arguments.folder);
    return ExitCode::done;
}

} // namespace mrpp

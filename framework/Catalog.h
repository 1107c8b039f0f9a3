#pragma once
/// \file
/// Everything that a plan or a command line can name. Filled by registerAlgorithms(), registerProblems() and
/// registerReports(); outside code adds its own classes the same way.

#include "framework/Optimizer.h"
#include "framework/Planner.h"
#include "framework/Problem.h"
#include "framework/Report.h"
#include "framework/support/Registry.h"

#include <string>
#include <vector>

namespace mrpp
{

/// A file format, for `mrppsim list formats`.
struct FileFormat
{
    std::string name;
    std::string extensions; ///< ".map", ".graphml .xml", …
    std::string holds;      ///< "graph", "instance", "graph and instance", "solution", …
    bool reads = false;
    bool writes = false;
    std::string description;
};

struct Catalog
{
    Registry<Planner> planners{"planner"};
    Registry<Optimizer> optimizers{"optimizer"};
    Registry<Problem> problems{"problem"};
    Registry<Report> reports{"report"};
    std::vector<FileFormat> formats;
};

} // namespace mrpp

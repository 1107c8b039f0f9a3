#pragma once
/// \file
/// Everything that a plan or a command line can name. Filled by registerAlgorithms(), registerProblems() and
/// registerReports(); outside code adds its own classes the same way.

#include "framework/FileExchange.h"
#include "framework/Optimizer.h"
#include "framework/Planner.h"
#include "framework/Problem.h"
#include "framework/Report.h"
#include "framework/support/Registry.h"

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
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

/// A measure of solutions that somebody adds: a column of every record that has a solution.
struct AddedMetric
{
    std::string name; ///< of the column: "turns"
    std::string title;
    std::string unit;
    bool higherIsBetter = false;
    std::string description; ///< one sentence

    /// Of the planner's solution, which has been checked; nothing where it does not exist. May be called from
    /// several threads at once.
    std::function<std::optional<double>(const Instance &, const Solution &)> measure;
};

struct Catalog
{
    Registry<Planner> planners{"planner"};
    Registry<Optimizer> optimizers{"optimizer"};
    Registry<Problem> problems{"problem"};
    Registry<Report> reports{"report"};
    std::vector<FileFormat> formats;
    std::shared_ptr<const FileExchange> files;  ///< that knows the formats; null where nobody does
    std::vector<AddedMetric> metrics;           ///< besides metrics()
    std::vector<std::filesystem::path> plugins; ///< that have been loaded, see loadPlugin()
};

} // namespace mrpp

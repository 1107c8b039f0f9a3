#pragma once
/// \file
/// The command line as plain structs, one a command. The only source that knows the parsing library is
/// Arguments.cpp.

#include "cli/ExitCode.h"
#include "framework/Catalog.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace mrpp
{

struct RunArguments
{
    std::filesystem::path plan;
    std::optional<std::filesystem::path> folder; ///< results/CAMPAIGN where not given
    std::vector<std::filesystem::path> maps;     ///< where the plan's files are looked for besides
    std::optional<std::int64_t> jobs;            ///< the plan's where not given
    std::int64_t shard = 1;
    std::int64_t shards = 1;
    bool dryRun = false;
    bool why = false; ///< say which runs would be made and why, and run nothing
    bool noReport = false;
    bool quiet = false;
};

struct ReportArguments
{
    std::filesystem::path folder;
    std::vector<std::string> only; ///< the plan's reports where empty
};

struct MergeArguments
{
    std::filesystem::path out;
    std::vector<std::filesystem::path> folders;
};

struct CompareArguments
{
    std::filesystem::path first;
    std::filesystem::path second;
    double timeTolerance = 0.1; ///< ratio of median times, minus one
    double flappingFrom = 0.5;  ///< share of the time limit
    std::optional<std::filesystem::path> out;
};

struct ReplayArguments
{
    std::filesystem::path folder;
    std::string key;        ///< or how it begins
    bool inProcess = false; ///< for debuggers
    std::optional<std::filesystem::path> graph;
    std::optional<std::filesystem::path> instance;
    std::optional<std::filesystem::path> solution;
    std::optional<std::filesystem::path> json;
};

struct SlurmArguments
{
    std::filesystem::path plan;
    std::filesystem::path folder;
    std::vector<std::filesystem::path> maps;
    std::int64_t shards = 1;
    std::optional<std::int64_t> jobs; ///< the plan's where not given
    std::optional<std::string> partition;
    std::optional<std::string> account;
    std::optional<std::string> time; ///< from the plan's limits where not given
    std::optional<std::int64_t> atOnce;
    std::vector<std::string> lines; ///< further options of sbatch
    bool submit = false;
};

struct SolveArguments
{
    std::optional<std::filesystem::path> graph;
    std::filesystem::path instance;
    std::optional<std::int64_t> robots;
    std::string planner;
    std::vector<std::pair<std::string, std::string>> settings;
    std::vector<std::string> optimizers;
    std::string motion;
    double timeLimit = 60;     ///< seconds
    double memoryLimit = 4096; ///< MB
    std::uint64_t seed = 1;
    std::optional<std::filesystem::path> solution;
    std::optional<std::filesystem::path> optimizedSolution;
    std::optional<std::filesystem::path> schedule;
    std::optional<std::filesystem::path> animation;
    std::optional<std::filesystem::path> json;
    std::string passability = "movingai"; ///< which symbols of a map robots may stand on
};

struct CheckArguments
{
    std::optional<std::filesystem::path> graph;
    std::filesystem::path instance;
    std::optional<std::int64_t> robots;
    std::string motion;
    bool json = false;
    std::string passability = "movingai"; ///< which symbols of a map robots may stand on
};

struct ValidateArguments
{
    std::optional<std::filesystem::path> graph;
    std::filesystem::path instance;
    std::optional<std::int64_t> robots;
    std::filesystem::path solution;
    std::string motion;
    std::string passability = "movingai"; ///< which symbols of a map robots may stand on
};

struct ViewArguments
{
    std::optional<std::filesystem::path> graph;
    std::optional<std::filesystem::path> instance; ///< the moves say it themselves where not given
    std::optional<std::int64_t> robots;
    std::vector<std::filesystem::path> solutions; ///< one or more
    std::string motion;
    std::filesystem::path output;
    std::string passability = "movingai"; ///< which symbols of a map robots may stand on
};

struct ConvertArguments
{
    std::filesystem::path in;
    std::filesystem::path out;
    std::optional<std::filesystem::path> graph;
    std::optional<std::filesystem::path> instance; ///< of a solution
    std::optional<std::string> format;             ///< of `out`; by its extension where not given
    std::string passability = "movingai";          ///< which symbols of a map robots may stand on
};

struct GenerateArguments
{
    std::string family;
    std::vector<std::pair<std::string, std::string>> settings; ///< of the family
    std::uint64_t seed = 1;
    std::optional<std::int64_t> robots;
    bool solvable = false;
    bool wellFormed = false;
    std::optional<std::filesystem::path> graph; ///< standard output where not given
    std::optional<std::filesystem::path> instance;
};

struct ListArguments
{
    std::string what; ///< planners, optimizers, problems, reports, metrics, formats
    bool json = false;
};

/// Serve a campaign's runs; started by `run`.
struct WorkerArguments
{};

/// The command line was a question about the program (--help, --version), answered already, or wrong, said
/// already.
struct Answered
{
    ExitCode code = ExitCode::done;
};

using Arguments =
    std::variant<Answered, RunArguments, ReportArguments, MergeArguments, CompareArguments, ReplayArguments,
                 SlurmArguments, SolveArguments, CheckArguments, ValidateArguments, ViewArguments,
                 ConvertArguments, GenerateArguments, ListArguments, WorkerArguments>;

/// Prints help to the standard output, complaints to the standard error.
/// \param catalog whose generators have an option for each of their parameters
[[nodiscard]] Arguments parseArguments(int count, const char *const *words, const Catalog &catalog);

} // namespace mrpp

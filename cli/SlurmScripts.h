#pragma once
/// \file
/// The scripts by which a Slurm cluster runs a campaign: an array of shards, and a job that merges them and
/// writes the reports.

#include "framework/plan/BenchmarkPlan.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace mrpp
{

struct SlurmRequest
{
    std::filesystem::path folder;     ///< where everything goes; absolute
    std::filesystem::path plan;       ///< its file; absolute
    std::vector<std::string> program; ///< how this program is started: its path, and options of every command
    std::vector<std::string> options; ///< of `run`, for the plan's files
    std::int64_t shards = 1;
    std::int64_t jobs = 1; ///< runs at once in a shard
    std::optional<std::string> partition = {};
    std::optional<std::string> account = {};
    std::optional<std::string> time = {};    ///< of a shard, as Slurm writes it; else from the plan's limits
    std::optional<std::int64_t> atOnce = {}; ///< shards at once; else as many as Slurm gives
    std::vector<std::string> lines = {};     ///< further options of both jobs: "--qos=long"
};

struct SlurmScripts
{
    std::string array;
    std::string merge;
    std::string submit;
};

/// What a shard needs at most, from the plan's limits.
struct ShardNeeds
{
    std::int64_t minutes = 0;
    std::int64_t memory = 0; ///< MiB
};

/// The time of the largest shard if every run of it reaches its time limit, and ten minutes; the memory of as
/// many runs as there are at once, and 1 GB for the program and its graphs.
[[nodiscard]] ShardNeeds shardNeeds(const BenchmarkPlan &plan, std::int64_t shards, std::int64_t jobs);

[[nodiscard]] SlurmScripts slurmScripts(const BenchmarkPlan &plan, const SlurmRequest &request);

} // namespace mrpp

#pragma once
/// \file
/// Input files as they were when the runs got their keys. Files may be edited while a campaign runs: what is
/// read then must not be recorded under the key of what was there before.

#include <cstdint>
#include <filesystem>
#include <map>
#include <mutex>
#include <span>
#include <string>
#include <vector>

namespace mrpp
{

struct BenchmarkPlan;
struct Configured;

/// Every file that a planner's command reads; none where it has no command.
[[nodiscard]] std::vector<std::filesystem::path> inputFilesOf(const Configured &planner);

/// Every file that the plan's problems and commands read.
[[nodiscard]] std::vector<std::filesystem::path> inputFilesOf(const BenchmarkPlan &plan);

class InputWatch
{
public:
    /// Path and hash of the contents.
    using Hashes = std::map<std::string, std::string>;

    /// Notes what these files hold now; those that cannot be read are left out.
    explicit InputWatch(std::span<const std::filesystem::path> files);

    /// As another process noted it.
    explicit InputWatch(Hashes hashes) : hashes_(std::move(hashes)) {}

    [[nodiscard]] const Hashes &hashes() const { return hashes_; }

    /// Throws HarnessError where one of the files holds something else now, is gone, or was not noted. Before
    /// and after a file is read, this tells whether it was the right one. Costs a system call a file, unless
    /// the file was touched. Several threads may call it at once.
    void check(std::span<const std::filesystem::path> files);

private:
    /// What a file system says of a file; where nothing of it changed, the contents did not.
    struct Version
    {
        std::uint64_t device = 0;
        std::uint64_t number = 0;
        std::uint64_t size = 0;
        std::int64_t modified = 0; ///< nanoseconds
        std::int64_t changed = 0;

        bool operator==(const Version &) const = default;
    };
    [[nodiscard]] static Version versionOf(const std::filesystem::path &file);

    Hashes hashes_;
    std::mutex mutex_;                       // guards what follows
    std::map<std::string, Version> checked_; ///< versions that hold what was noted
};

} // namespace mrpp

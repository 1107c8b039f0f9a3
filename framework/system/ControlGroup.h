#pragma once
/// \file
/// A control group (cgroup) of its own for a process and everything that it starts: the kernel counts their
/// CPU time, bounds and measures their memory together, and ends all of them at once.
///
/// Version 2 is used where this process's own group may be written (a delegated one, as `systemd-run --user
/// --scope -p Delegate=yes` makes it), version 1 where its hierarchies are mounted and may be written. What
/// cannot be had is left out; cpuMeans() and memoryMeans() say what there is.

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <sys/types.h>

namespace mrpp
{

class ControlGroup
{
public:
    /// Makes a group below the one in which this process is; null where the system allows none.
    [[nodiscard]] static std::unique_ptr<ControlGroup> make();

    /// Ends what is in it and removes it.
    ~ControlGroup();
    ControlGroup(const ControlGroup &) = delete;
    ControlGroup &operator=(const ControlGroup &) = delete;

    /// Puts a process into it; what that starts from then on is in it too. False where that is refused.
    bool add(pid_t process);

    /// CPU seconds of all that was ever in it.
    [[nodiscard]] std::optional<double> cpuTime() const;

    /// Forgets the peak so far: growth counts from now on.
    void watchMemory();

    /// Lets memory grow by so many MB since watchMemory(); beyond that the kernel kills the largest process.
    /// False where it has grown further already. Further calls change nothing until unlimitMemory().
    bool limitMemory(double growth);
    void unlimitMemory();

    /// MB by which memory grew since watchMemory(), at most.
    [[nodiscard]] std::optional<double> memoryGrowth() const;

    /// Whether a process was killed for memory since limitMemory().
    [[nodiscard]] bool ranOutOfMemory() const;

    /// "cgroup2", "cgroup1", or empty.
    [[nodiscard]] std::string cpuMeans() const;
    [[nodiscard]] std::string memoryMeans() const;

private:
    ControlGroup() = default;

    /// A group in one hierarchy.
    struct Place
    {
        std::filesystem::path folder; ///< empty where there is none
        bool second = false;          ///< of version 2
    };
    [[nodiscard]] static Place makePlace(const std::string &controller);

    [[nodiscard]] std::optional<std::uint64_t> memoryNow() const;
    [[nodiscard]] std::uint64_t memoryKills() const;

    Place cpu_;
    Place memory_;
    std::uint64_t memoryAtStart_ = 0; ///< bytes, at watchMemory()
    std::uint64_t killsAtStart_ = 0;  ///< at limitMemory()
    bool isLimited_ = false;
    bool peakIsFresh_ = false; ///< the kernel's peak is that since watchMemory()
};

} // namespace mrpp

#include "framework/system/ControlGroup.h"

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <thread>
#include <unistd.h>
#include <vector>

namespace mrpp
{

namespace
{

namespace fs = std::filesystem;

bool put(const fs::path &file, const std::string &text)
{
    std::ofstream stream(file);
    stream << text << std::flush;
    return static_cast<bool>(stream);
}

std::optional<std::uint64_t> number(const fs::path &file)
{
    std::ifstream stream(file);
    std::uint64_t value = 0;
    return stream >> value ? std::optional(value) : std::nullopt;
}

/// The number behind a word, as in "oom_kill 3".
std::optional<std::uint64_t> number(const fs::path &file, const std::string &word)
{
    std::ifstream stream(file);
    std::string name;
    for (std::uint64_t value = 0; stream >> name >> value;)
        if (name == word)
            return value;
    return std::nullopt;
}

bool holds(const std::string &list, char separator, const std::string &word)
{
    std::istringstream items(list);
    for (std::string item; std::getline(items, item, separator);)
        if (item == word)
            return true;
    return false;
}

/// Where this process is in a hierarchy: that of a controller (version 1), or of version 2 where it is empty.
fs::path ownGroup(const std::string &controller)
{
    fs::path mount;
    std::ifstream mounts("/proc/self/mounts");
    for (std::string line; std::getline(mounts, line);)
    {
        std::istringstream fields(line);
        std::string device;
        std::string where;
        std::string type;
        std::string options;
        fields >> device >> where >> type >> options;
        if (controller.empty() ? type == "cgroup2" : type == "cgroup" && holds(options, ',', controller))
            mount = where;
    }
    if (mount.empty())
        return {};
    std::ifstream groups("/proc/self/cgroup"); // "4:memory:/a/b", "0::/a/b"
    for (std::string line; std::getline(groups, line);)
    {
        const std::size_t first = line.find(':');
        const std::size_t second = line.find(':', first + 1);
        if (second == std::string::npos)
            continue;
        const std::string controllers = line.substr(first + 1, second - first - 1);
        if (controller.empty() ? controllers.empty() : holds(controllers, ',', controller))
        {
            const fs::path group = mount / fs::path(line.substr(second + 1)).relative_path();
            std::error_code error;
            return fs::exists(group, error) ? group : mount;
        }
    }
    return {};
}

/// Version 2 gives controllers to groups below only where no process is in the group itself: this process
/// steps down, if it is alone there.
bool delegate(const fs::path &group, const std::string &controller)
{
    const auto listed = [&](const char *file)
    {
        std::ifstream stream(group / file);
        std::string list;
        std::getline(stream, list);
        return holds(list, ' ', controller);
    };
    if (!listed("cgroup.controllers"))
        return false;
    if (listed("cgroup.subtree_control") || put(group / "cgroup.subtree_control", "+" + controller))
        return true;
    std::ifstream stream(group / "cgroup.procs");
    const std::string self = std::to_string(::getpid());
    for (std::string process; std::getline(stream, process);)
        if (process != self)
            return false;
    const fs::path below = group / ("mrppsim-" + self + "-campaign");
    std::error_code error;
    fs::create_directory(below, error);
    return put(below / "cgroup.procs", self) && put(group / "cgroup.subtree_control", "+" + controller);
}

void endAll(const fs::path &folder, bool second)
{
    constexpr int kPatience = 100; // rounds of a few milliseconds
    if (second)
        put(folder / "cgroup.kill", "1");
    std::error_code error;
    for (int round = 0; round < kPatience && !fs::remove(folder, error); ++round)
    {
        if (!fs::exists(folder, error))
            return;
        std::ifstream processes(folder / "cgroup.procs");
        for (pid_t process = 0; processes >> process;)
            ::kill(process, SIGKILL);
        std::this_thread::sleep_for(std::chrono::milliseconds(1 + round / 10));
    }
}

constexpr const char *kPrefix = "mrppsim-"; // and the campaign's process id, and a number

/// Removes the groups of campaigns that were killed.
void clean(const fs::path &parent)
{
    std::error_code error;
    std::vector<fs::path> stale;
    for (const auto &entry : fs::directory_iterator(parent, error))
    {
        const std::string name = entry.path().filename();
        if (!name.starts_with(kPrefix))
            continue;
        const pid_t owner = std::atoi(name.c_str() + std::string_view(kPrefix).size());
        if (owner > 0 && ::kill(owner, 0) != 0 && errno == ESRCH)
            stale.push_back(entry.path());
    }
    for (const fs::path &group : stale)
        fs::remove(group, error); // the kernel keeps those that are in use
}

/// A new group; empty where that is refused.
fs::path makeBelow(const fs::path &parent)
{
    constexpr int kMost = 100'000;
    if (parent.empty())
        return {};
    clean(parent);
    for (int i = 1; i < kMost; ++i)
    {
        fs::path group = parent / (kPrefix + std::to_string(::getpid()) + "-" + std::to_string(i));
        std::error_code error;
        if (fs::create_directory(group, error))
            return group;
        if (error)
            return {};
    }
    return {};
}

} // namespace

ControlGroup::Place ControlGroup::makePlace(const std::string &controller)
{
    const bool countsAlways = controller == "cpuacct"; // version 2 counts CPU time without a controller
    const fs::path second = ownGroup("");
    if (!second.empty() && (countsAlways || delegate(second, controller)))
        if (const fs::path group = makeBelow(second); !group.empty())
            return {group, true};
    return {makeBelow(ownGroup(controller)), false};
}

std::unique_ptr<ControlGroup> ControlGroup::make()
{
    std::unique_ptr<ControlGroup> group(new ControlGroup);
    group->memory_ = makePlace("memory");
    if (group->memory_.second) // one group is in both
        group->cpu_ = group->memory_;
    else
        group->cpu_ = makePlace("cpuacct");
    return group->cpu_.folder.empty() && group->memory_.folder.empty() ? nullptr : std::move(group);
}

ControlGroup::~ControlGroup()
{
    for (const Place &place : {cpu_, memory_})
        if (!place.folder.empty())
            endAll(place.folder, place.second);
}

bool ControlGroup::add(pid_t process)
{
    bool added = true;
    for (const Place &place : {cpu_, memory_})
        added &= place.folder.empty() || put(place.folder / "cgroup.procs", std::to_string(process));
    return added;
}

std::optional<double> ControlGroup::cpuTime() const
{
    if (cpu_.folder.empty())
        return std::nullopt;
    const auto time =
        cpu_.second ? number(cpu_.folder / "cpu.stat", "usage_usec") : number(cpu_.folder / "cpuacct.usage");
    const double unit = cpu_.second ? 1e-6 : 1e-9;
    return time ? std::optional(static_cast<double>(*time) * unit) : std::nullopt;
}

std::optional<std::uint64_t> ControlGroup::memoryNow() const
{
    return number(memory_.folder / (memory_.second ? "memory.current" : "memory.usage_in_bytes"));
}

std::uint64_t ControlGroup::memoryKills() const
{
    return number(memory_.folder / (memory_.second ? "memory.events" : "memory.oom_control"), "oom_kill")
        .value_or(0);
}

void ControlGroup::watchMemory()
{
    if (memory_.folder.empty())
        return;
    memoryAtStart_ = memoryNow().value_or(0);
    // Version 2 resets its peak only for the descriptor through which it was asked to.
    peakIsFresh_ = !memory_.second && put(memory_.folder / "memory.max_usage_in_bytes", "0");
}

bool ControlGroup::limitMemory(double growth)
{
    if (memory_.folder.empty() || isLimited_)
        return true;
    killsAtStart_ = memoryKills();
    isLimited_ = put(memory_.folder / (memory_.second ? "memory.max" : "memory.limit_in_bytes"),
                     std::to_string(memoryAtStart_ + static_cast<std::uint64_t>(growth * 1e6)));
    return isLimited_ || memoryNow().value_or(0) <= memoryAtStart_ + static_cast<std::uint64_t>(growth * 1e6);
}

void ControlGroup::unlimitMemory()
{
    if (isLimited_)
        put(memory_.folder / (memory_.second ? "memory.max" : "memory.limit_in_bytes"),
            memory_.second ? "max" : "-1");
    isLimited_ = false;
}

std::optional<double> ControlGroup::memoryGrowth() const
{
    if (memory_.folder.empty() || !peakIsFresh_)
        return std::nullopt;
    const auto peak = number(memory_.folder / "memory.max_usage_in_bytes");
    if (!peak)
        return std::nullopt;
    return *peak > memoryAtStart_ ? static_cast<double>(*peak - memoryAtStart_) / 1e6 : 0.0;
}

bool ControlGroup::ranOutOfMemory() const
{
    return isLimited_ && memoryKills() > killsAtStart_;
}

std::string ControlGroup::cpuMeans() const
{
    return cpu_.folder.empty() ? "" : cpu_.second ? "cgroup2" : "cgroup1";
}

std::string ControlGroup::memoryMeans() const
{
    return memory_.folder.empty() ? "" : memory_.second ? "cgroup2" : "cgroup1";
}

} // namespace mrpp

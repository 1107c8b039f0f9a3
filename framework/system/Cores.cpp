#include "framework/system/Cores.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <sched.h>
#include <tuple>

namespace mrpp
{

namespace
{

/// A number of /sys/devices/system/cpu/cpuN/topology/; −1 where it is unknown.
int topology(int core, const char *name)
{
    std::ifstream file("/sys/devices/system/cpu/cpu" + std::to_string(core) + "/topology/" + name);
    int value = -1;
    return file >> value ? value : -1;
}

} // namespace

CoreSet allowedCores()
{
    cpu_set_t set;
    CPU_ZERO(&set);
    if (::sched_getaffinity(0, sizeof set, &set) != 0)
        return {};
    std::vector<std::tuple<int, int, int>> places;
    for (int core = 0; core < CPU_SETSIZE; ++core)
        if (CPU_ISSET(core, &set))
            places.emplace_back(topology(core, "physical_package_id"), topology(core, "core_id"), core);
    std::sort(places.begin(), places.end());
    CoreSet cores;
    for (const auto &[package, physical, core] : places)
        cores.push_back(core);
    return cores;
}

std::vector<CoreSet> shareCores(const CoreSet &cores, std::size_t parts)
{
    const std::size_t size = parts == 0 ? 0 : cores.size() / parts;
    std::vector<CoreSet> shares;
    for (std::size_t i = 0; size > 0 && i < parts; ++i)
    {
        const auto begin = cores.begin() + static_cast<std::ptrdiff_t>(i * size);
        shares.emplace_back(begin, begin + static_cast<std::ptrdiff_t>(size));
    }
    return shares;
}

bool confine(pid_t process, const CoreSet &cores)
{
    cpu_set_t set;
    CPU_ZERO(&set);
    for (const int core : cores)
        CPU_SET(core, &set);
    return ::sched_setaffinity(process, sizeof set, &set) == 0;
}

std::string toString(const CoreSet &cores)
{
    CoreSet sorted = cores;
    std::sort(sorted.begin(), sorted.end());
    std::string text;
    for (std::size_t i = 0; i < sorted.size();)
    {
        std::size_t last = i;
        while (last + 1 < sorted.size() && sorted[last + 1] == sorted[last] + 1)
            ++last;
        text += (text.empty() ? "" : ",") + std::to_string(sorted[i]);
        if (last > i)
            text += "-" + std::to_string(sorted[last]);
        i = last + 1;
    }
    return text;
}

double machineCores()
{
    cpu_set_t set;
    CPU_ZERO(&set);
    return ::sched_getaffinity(0, sizeof set, &set) == 0 ? std::max(1, CPU_COUNT(&set)) : 1;
}

std::optional<double> machineLoad()
{
    double load = 0;
    return ::getloadavg(&load, 1) == 1 ? std::optional(load) : std::nullopt;
}

} // namespace mrpp

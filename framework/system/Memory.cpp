#include "framework/system/Memory.h"

#include <fstream>
#include <malloc.h>
#include <string>
#include <string_view>

namespace mrpp
{

namespace
{

/// A line of /proc/self/status, which is in kB; 0 where it is missing.
std::uint64_t statusBytes(std::string_view name)
{
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);)
        if (line.starts_with(name))
            return std::stoull(line.substr(name.size())) * 1024;
    return 0;
}

} // namespace

bool resetPeakMemory()
{
    std::ofstream file("/proc/self/clear_refs");
    file << "5" << std::flush;
    return static_cast<bool>(file);
}

double peakMemory()
{
    return static_cast<double>(statusBytes("VmHWM:")) / 1e6;
}

void releaseFreeMemory()
{
    ::malloc_trim(0);
}

std::uint64_t dataMemory()
{
    return statusBytes("VmData:");
}

} // namespace mrpp

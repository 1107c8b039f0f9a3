#include "framework/system/ProcessTree.h"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace mrpp
{

namespace
{

std::string procFile(pid_t process, const char *name)
{
    return "/proc/" + std::to_string(process) + "/" + name;
}

/// What /proc/…/stat says behind the name, which may hold anything; begins with the state.
std::istringstream statFields(pid_t process)
{
    std::ifstream file(procFile(process, "stat"));
    std::string line;
    std::getline(file, line);
    return std::istringstream(line.substr(std::min(line.size(), line.rfind(')') + 1)));
}

/// Of one process and of the children that it waited for.
double cpuTime(pid_t process)
{
    constexpr int kBetween = 11; // fields between the name and the first of the four times
    std::istringstream fields = statFields(process);
    std::string skipped;
    for (int i = 0; i < kBetween; ++i)
        fields >> skipped;
    double sum = 0;
    double ticks = 0; // user and system, its own and its children's
    for (int i = 0; i < 4 && fields >> ticks; ++i)
        sum += ticks;
    return sum / static_cast<double>(::sysconf(_SC_CLK_TCK));
}

} // namespace

std::vector<pid_t> childrenOf(pid_t process)
{
    std::vector<pid_t> found;
    std::error_code error;
    for (const auto &thread : std::filesystem::directory_iterator(procFile(process, "task"), error))
    {
        std::ifstream list(thread.path() / "children");
        for (pid_t child = 0; list >> child;)
            found.push_back(child);
    }
    return found;
}

std::vector<pid_t> descendantsOf(pid_t process)
{
    std::vector<pid_t> found = childrenOf(process);
    for (std::size_t i = 0; i < found.size(); ++i)
        for (const pid_t child : childrenOf(found[i]))
            found.push_back(child);
    return found;
}

double treeCpuTime(pid_t process)
{
    double sum = cpuTime(process);
    for (const pid_t descendant : descendantsOf(process))
        sum += cpuTime(descendant);
    return sum;
}

double ownMemory(pid_t process)
{
    constexpr std::string_view kName = "Pss_Anon:";
    std::ifstream file(procFile(process, "smaps_rollup"));
    for (std::string line; std::getline(file, line);)
        if (line.starts_with(kName))
            return std::stod(line.substr(kName.size())) * 1024e-6;
    return 0;
}

bool isStopped(pid_t process)
{
    char state = ' ';
    return (statFields(process) >> state) && (state == 'T' || state == 't');
}

void endChildren()
{
    constexpr int kPatience = 200; // rounds of a few milliseconds
    for (int round = 0; round < kPatience; ++round)
    {
        pid_t ended = 0;
        do
            ended = ::waitpid(-1, nullptr, WNOHANG);
        while (ended > 0);
        if (ended < 0)
            return; // nobody is left
        for (const pid_t child : childrenOf(::getpid()))
            ::kill(child, SIGKILL);
        std::this_thread::sleep_for(std::chrono::milliseconds(1 + round / 10));
    }
}

} // namespace mrpp

#pragma once

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <sys/types.h>
#include <vector>

namespace mrpp::fixtures
{

/// Processes whose command line holds that word.
inline std::vector<pid_t> processes(const std::string &word)
{
    std::vector<pid_t> found;
    std::error_code error;
    for (const auto &entry : std::filesystem::directory_iterator("/proc", error))
    {
        const std::string name = entry.path().filename();
        if (name.find_first_not_of("0123456789") != std::string::npos)
            continue;
        std::ifstream file(entry.path() / "cmdline");
        std::stringstream line;
        line << file.rdbuf();
        if (line.str().find(word) != std::string::npos)
            found.push_back(std::stoi(name));
    }
    return found;
}

} // namespace mrpp::fixtures

#pragma once
/// \file
/// Another program, run without a shell.

#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

namespace mrpp
{

struct ProcessResult
{
    bool started = false;  ///< false: there is no such program, or it cannot be executed
    bool timedOut = false; ///< the limit came first; the program and its children were killed
    int exitCode = -1;     ///< −1 where a signal ended it
    std::string output;    ///< standard output and error, the first 64 KiB

    [[nodiscard]] bool succeeded() const { return started && !timedOut && exitCode == 0; }
};

/// Runs `arguments[0]`, looked up in PATH, in that folder, with nothing on its standard input. No argument is
/// ever seen by a shell. The program forms its own process group, which is killed at the wall limit.
/// Nothing is written to it, so no SIGPIPE can arise.
[[nodiscard]] ProcessResult runProcess(const std::vector<std::string> &arguments,
                                       const std::filesystem::path &folder, std::chrono::milliseconds limit);

} // namespace mrpp

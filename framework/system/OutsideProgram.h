#pragma once
/// \file
/// Runs a program in a process group of its own until it ends or has to be ended.

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace mrpp
{

struct ProgramRequest
{
    std::vector<std::string> words;                ///< the first is looked up in PATH; no shell sees them
    std::filesystem::path folder = {};             ///< where it starts; here if empty
    std::filesystem::path output = {};             ///< gets its standard output; if empty, its end is kept
    std::function<bool()> stop = {};               ///< asked every few milliseconds
    std::chrono::milliseconds grace{1000};         ///< how long it may go on after that
    std::filesystem::path watched = {};            ///< a file that it writes
    std::uintmax_t mostBytes = ~std::uintmax_t{0}; ///< that this file may have
};

struct ProgramEnd
{
    std::string failure = {};    ///< why it could not be started; empty where it was
    int exitCode = -1;           ///< −1 where a signal ended it
    int signal = 0;              ///< 0 where it ended by itself
    bool stopped = false;        ///< killed here, as it did not end in time
    bool tooMuch = false;        ///< killed here, as it wrote too much
    std::string outputTail = {}; ///< the last 2 KiB of its standard output, where no file got it
    std::string errorTail = {};  ///< and of its standard error
};

/// Its standard input is empty; its standard error reaches the caller's, too. When it has ended, what is left
/// of its group is killed.
[[nodiscard]] ProgramEnd runProgram(const ProgramRequest &request);

} // namespace mrpp

#pragma once
/// \file
/// How far a long computation is: after two seconds one line on a terminal, which is rewritten, and goes away
/// when it is over.

#include "framework/system/Supervision.h"

#include <chrono>
#include <ostream>

namespace mrpp
{

class WorkLine
{
public:
    /// Shows nothing where standard error is no terminal.
    WorkLine();
    WorkLine(std::ostream &out, bool isTerminal) : out_(out), isTerminal_(isTerminal) {}
    ~WorkLine() { clear(); }
    WorkLine(const WorkLine &) = delete;
    WorkLine &operator=(const WorkLine &) = delete;

    /// What tells it; must not outlive it.
    [[nodiscard]] Supervision::Listener listener();

    /// Takes the line away, so that other text may follow.
    void clear();

private:
    using Clock = std::chrono::steady_clock;
    void update(std::string_view work, std::size_t done, std::size_t total);

    static constexpr std::chrono::seconds kSilence{2};

    std::ostream &out_;
    bool isTerminal_;
    Clock::time_point next_ = Clock::now() + kSilence;
    std::size_t width_ = 0; ///< of what stands on the terminal
};

} // namespace mrpp

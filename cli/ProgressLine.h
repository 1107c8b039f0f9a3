#pragma once
/// \file
/// How far a campaign is: one line that is rewritten on a terminal, a line every few seconds elsewhere.

#include "framework/run/RunRecord.h"

#include <chrono>
#include <map>
#include <ostream>
#include <string>

namespace mrpp
{

class ProgressLine
{
public:
    enum class Mode
    {
        terminal, ///< rewrites its line, at most 10 times a second
        lines,    ///< a line every 10 seconds
        quiet,
    };

    /// Terminal mode where standard error is one.
    [[nodiscard]] static Mode detect();

    ProgressLine(std::ostream &out, Mode mode) : out_(out), mode_(mode) {}
    ~ProgressLine();
    ProgressLine(const ProgressLine &) = delete;
    ProgressLine &operator=(const ProgressLine &) = delete;

    /// A run has finished. \param secondsLeft an estimate
    void update(PlannerStatus status, std::size_t done, std::size_t total, double secondsLeft);

    /// Ends the rewritten line, so that other text may follow.
    void finish();

private:
    std::ostream &out_;
    Mode mode_;
    std::map<PlannerStatus, std::size_t> statuses_; ///< of the runs seen here
    std::chrono::steady_clock::time_point next_{};  ///< when the line may be written again
    std::string line_;                              ///< the latest
    std::size_t shownWidth_ = 0;                    ///< of what stands on the terminal
    bool dirty_ = false;                            ///< the latest line has not been shown

    void show();
};

/// "12/40 runs, solved 10, timeout 2, 1 min 5 s left"
[[nodiscard]] std::string progressText(const std::map<PlannerStatus, std::size_t> &statuses, std::size_t done,
                                       std::size_t total, double secondsLeft);

/// "45 s", "1 min 5 s", "2 h 3 min".
[[nodiscard]] std::string durationText(double seconds);

} // namespace mrpp

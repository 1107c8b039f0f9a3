#include "cli/ProgressLine.h"

#include <algorithm>
#include <cmath>
#include <unistd.h>

namespace mrpp
{

ProgressLine::Mode ProgressLine::detect()
{
    return ::isatty(STDERR_FILENO) == 1 ? Mode::terminal : Mode::lines;
}

ProgressLine::~ProgressLine()
{
    finish();
}

void ProgressLine::update(PlannerStatus status, std::size_t done, std::size_t total, double secondsLeft)
{
    if (mode_ == Mode::quiet)
        return;
    ++statuses_[status];
    line_ = progressText(statuses_, done, total, secondsLeft);
    dirty_ = true;
    const auto now = std::chrono::steady_clock::now();
    const bool first = next_ == std::chrono::steady_clock::time_point{};
    const std::chrono::milliseconds pause(mode_ == Mode::terminal ? 100 : 10'000);
    if (mode_ == Mode::lines && first)
    {
        next_ = now + pause; // a short campaign needs no line
        return;
    }
    if (now < next_)
        return;
    next_ = now + pause;
    show();
}

void ProgressLine::show()
{
    if (mode_ == Mode::lines)
    {
        out_ << line_ << '\n' << std::flush;
    }
    else
    {
        const std::size_t padding = shownWidth_ > line_.size() ? shownWidth_ - line_.size() : 0;
        out_ << '\r' << line_ << std::string(padding, ' ') << std::flush;
        shownWidth_ = line_.size();
    }
    dirty_ = false;
}

void ProgressLine::finish()
{
    if (mode_ != Mode::terminal || line_.empty())
        return;
    if (dirty_)
        show();
    out_ << '\n' << std::flush;
    line_.clear();
    shownWidth_ = 0;
}

std::string progressText(const std::map<PlannerStatus, std::size_t> &statuses, std::size_t done,
                         std::size_t total, double secondsLeft)
{
    std::string text = std::to_string(done) + "/" + std::to_string(total) + " runs";
    for (const auto &[status, count] : statuses)
        text += ", " + std::string(toString(status)) + " " + std::to_string(count);
    if (done < total)
        text += ", " + durationText(secondsLeft) + " left";
    return text;
}

std::string durationText(double seconds)
{
    constexpr double kLongest = 1e9;
    const auto whole = static_cast<long long>(std::ceil(std::clamp(seconds, 0.0, kLongest)));
    if (whole < 60)
        return std::to_string(whole) + " s";
    if (whole < 3600)
        return std::to_string(whole / 60) + " min " + std::to_string(whole % 60) + " s";
    return std::to_string(whole / 3600) + " h " + std::to_string(whole % 3600 / 60) + " min";
}

} // namespace mrpp

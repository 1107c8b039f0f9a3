#include "cli/WorkLine.h"

#include <fmt/format.h>
#include <iostream>
#include <string>
#include <unistd.h>

namespace mrpp
{

WorkLine::WorkLine() : WorkLine(std::cerr, ::isatty(STDERR_FILENO) == 1) {}

Supervision::Listener WorkLine::listener()
{
    if (!isTerminal_)
        return {};
    return [this](std::string_view work, std::size_t done, std::size_t total) { update(work, done, total); };
}

void WorkLine::update(std::string_view work, std::size_t done, std::size_t total)
{
    constexpr std::chrono::milliseconds kPause{100};
    const Clock::time_point now = Clock::now();
    if (now < next_)
        return;
    next_ = now + kPause;
    const std::string text = fmt::format("{}: {} of {}", work, done, total);
    out_ << '\r' << text << std::string(width_ > text.size() ? width_ - text.size() : 0, ' ') << std::flush;
    width_ = text.size();
}

void WorkLine::clear()
{
    if (width_ > 0)
        out_ << '\r' << std::string(width_, ' ') << '\r' << std::flush;
    width_ = 0;
    next_ = Clock::now() + kSilence;
}

} // namespace mrpp

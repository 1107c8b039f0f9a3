#include "framework/system/TailPipe.h"

#include "framework/support/Error.h"
#include "framework/support/ReadableText.h"

#include <array>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <string_view>
#include <utility>

namespace mrpp
{

namespace
{

constexpr std::size_t kMost = 2048;
constexpr std::size_t kWhole = 4; // bytes more than are wanted, so that a cut shows

/// A terminal gets nothing that could steer it. What cannot be written is lost.
void forward(int to, std::string_view text)
{
    const std::string shown = ::isatty(to) == 1 ? readable(text) : std::string(text);
    for (text = shown; !text.empty();)
    {
        const ssize_t written = ::write(to, text.data(), text.size());
        if (written < 0 && errno == EINTR)
            continue;
        if (written <= 0)
            return;
        text.remove_prefix(static_cast<std::size_t>(written));
    }
}

} // namespace

TailPipe::TailPipe(int forwardTo) : forwardTo_(forwardTo)
{
    std::array<int, 2> ends{};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0)
        throw FileError(std::string("no pipe can be made: ") + std::strerror(errno));
    read_ = Descriptor(ends[0]);
    write_ = Descriptor(ends[1]);
    ::fcntl(read_.number(), F_SETFL, O_NONBLOCK);
}

void TailPipe::read()
{
    constexpr int kPiecesAtOnce = 64; // who writes without end must not hold up who reads
    std::array<char, 65536> piece{};
    for (int i = 0; i < kPiecesAtOnce && read_.number() >= 0; ++i)
    {
        const ssize_t count = ::read(read_.number(), piece.data(), piece.size());
        if (count < 0 && errno == EINTR)
            continue;
        if (count == 0)
            read_.close(); // poll() leaves out a descriptor of −1
        if (count <= 0)
            return;
        const std::string_view text(piece.data(), static_cast<std::size_t>(count));
        kept_ += text;
        if (kept_.size() > kMost + kWhole)
            kept_.erase(0, kept_.size() - kMost - kWhole);
        if (forwardTo_ >= 0)
            forward(forwardTo_, text);
    }
}

std::string TailPipe::take()
{
    const std::string kept = std::exchange(kept_, {});
    return std::string(tail(kept, kMost));
}

} // namespace mrpp

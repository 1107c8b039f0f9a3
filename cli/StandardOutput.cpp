#include "cli/StandardOutput.h"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <iostream>
#include <string_view>
#include <unistd.h>

namespace mrpp
{

namespace
{

/// Opens the standard streams that are closed to nothing, so that no file of ours gets their numbers. True
/// where the standard output was.
bool occupyClosedStreams()
{
    bool outputWas = false;
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
        if (::fcntl(stream, F_GETFD) < 0)
        {
            outputWas = outputWas || stream == STDOUT_FILENO;
            (void)::open("/dev/null", O_RDWR); // the lowest number that is free: this one
        }
    return outputWas;
}

} // namespace

StandardOutput::StandardOutput()
    : before_(std::cout.rdbuf()), isClosed_(occupyClosedStreams()), isTerminal_(::isatty(STDOUT_FILENO) == 1)
{
    setp(buffer_.data(), buffer_.data() + buffer_.size());
    std::cout.rdbuf(this);
}

StandardOutput::~StandardOutput()
{
    (void)flush();
    std::cout.rdbuf(before_);
}

ExitCode StandardOutput::finish(ExitCode code)
{
    if (flush())
        return code;
    if (error_ != EPIPE)
        std::cerr << "mrppsim: the standard output cannot be written: " << std::strerror(error_) << '\n';
    return code == ExitCode::done || code == ExitCode::no ? ExitCode::wrongUse : code;
}

StandardOutput::int_type StandardOutput::overflow(int_type c)
{
    if (!flush())
        return traits_type::eof();
    if (!traits_type::eq_int_type(c, traits_type::eof()))
        sputc(traits_type::to_char_type(c));
    return traits_type::not_eof(c);
}

std::streamsize StandardOutput::xsputn(const char *text, std::streamsize size)
{
    const std::streamsize written = std::streambuf::xsputn(text, size);
    const bool endsLine =
        std::string_view(text, static_cast<std::size_t>(written)).find('\n') != std::string_view::npos;
    return isTerminal_ && endsLine && !flush() ? 0 : written;
}

int StandardOutput::sync()
{
    return flush() ? 0 : -1;
}

bool StandardOutput::flush()
{
    const char *from = pbase();
    if (isClosed_ && from < pptr())
        error_ = EBADF;
    while (error_ == 0 && from < pptr())
    {
        const ssize_t written = ::write(STDOUT_FILENO, from, static_cast<std::size_t>(pptr() - from));
        if (written >= 0)
            from += written;
        else if (errno != EINTR)
            error_ = errno;
    }
    setp(buffer_.data(), buffer_.data() + buffer_.size());
    return error_ == 0;
}

} // namespace mrpp

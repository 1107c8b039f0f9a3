#pragma once
/// \file
/// What commands say goes through here, so that a full disk or a closed descriptor behind the standard output
/// is noticed wherever it happens.

#include "cli/ExitCode.h"

#include <array>
#include <streambuf>

namespace mrpp
{

/// Takes std::cout over while it lives. Lines appear at once on a terminal.
class StandardOutput final : public std::streambuf
{
public:
    StandardOutput();
    ~StandardOutput() override;
    StandardOutput(const StandardOutput &) = delete;
    StandardOutput &operator=(const StandardOutput &) = delete;

    /// Writes what is left. Where anything could not be written, a command that had done its work ends as
    /// wrong use, with a message; without one where who was reading has gone away.
    [[nodiscard]] ExitCode finish(ExitCode code);

protected:
    int_type overflow(int_type c) override;
    std::streamsize xsputn(const char *text, std::streamsize size) override;
    int sync() override;

private:
    [[nodiscard]] bool flush();

    std::array<char, 1 << 16> buffer_;
    std::streambuf *before_;
    bool isClosed_; ///< from the beginning
    bool isTerminal_;
    int error_ = 0; ///< errno of the first failure; then nothing more is written
};

} // namespace mrpp

#pragma once
/// \file
/// A pipe that processes write into, of which only the end is kept.

#include "framework/system/Descriptor.h"

#include <string>

namespace mrpp
{

class TailPipe
{
public:
    /// \param forwardTo a descriptor that gets everything, too; −1 for none
    /// Throws FileError where the system has no more descriptors.
    explicit TailPipe(int forwardTo = -1);

    /// −1 once it is closed, and at the end of what is written.
    [[nodiscard]] int readEnd() const { return read_.number(); }
    [[nodiscard]] int writeEnd() const { return write_.number(); }
    /// To be called when those that write have it.
    void closeWriteEnd() { write_.close(); }

    /// Takes what has arrived, without waiting, and without end only as fast as it comes.
    void read();

    /// The last 2 KiB of what was read, without half a character at their beginning.
    [[nodiscard]] std::string take();

private:
    int forwardTo_;
    Descriptor read_;
    Descriptor write_;
    std::string kept_;
};

} // namespace mrpp

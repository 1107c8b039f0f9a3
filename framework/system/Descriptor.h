#pragma once

#include <unistd.h>
#include <utility>

namespace mrpp
{

/// A file descriptor that closes itself.
class Descriptor
{
public:
    Descriptor() = default;
    explicit Descriptor(int number) : number_(number) {}
    ~Descriptor() { close(); }
    Descriptor(Descriptor &&other) noexcept : number_(std::exchange(other.number_, -1)) {}
    Descriptor &operator=(Descriptor &&other) noexcept
    {
        close();
        number_ = std::exchange(other.number_, -1);
        return *this;
    }

    /// −1 where there is none.
    [[nodiscard]] int number() const { return number_; }
    void close()
    {
        if (number_ >= 0)
            ::close(number_);
        number_ = -1;
    }

private:
    int number_ = -1;
};

} // namespace mrpp

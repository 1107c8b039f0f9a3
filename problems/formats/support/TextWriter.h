#pragma once
/// \file
/// Puts text together without streams, locales or temporary strings. Internal to the writers of this folder.

#include <array>
#include <charconv>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

namespace mrpp
{

class TextWriter
{
public:
    /// Appends the parts: text, characters, whole numbers.
    template <class... Parts>
    void add(const Parts &...parts)
    {
        (append(parts), ...);
    }

    /// Appends the parts and a line end.
    template <class... Parts>
    void line(const Parts &...parts)
    {
        (append(parts), ...);
        text_ += '\n';
    }

    /// The shortest digits that read back as the same number.
    void addShortest(double number)
    {
        std::array<char, 32> digits{};
        text_.append(digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr);
    }

    /// Two decimals, never an exponent.
    void addFixed(double number)
    {
        std::array<char, 400> digits{};
        text_.append(digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), number,
                                                  std::chars_format::fixed, 2)
                                        .ptr);
    }

    [[nodiscard]] std::size_t size() const { return text_.size(); }
    [[nodiscard]] const std::string &text() const { return text_; }
    [[nodiscard]] std::string take() { return std::move(text_); }
    void clear() { text_.clear(); }

private:
    void append(std::string_view part) { text_ += part; }
    void append(char part) { text_ += part; }
    void append(std::uint64_t number)
    {
        std::array<char, 20> digits{}; // enough for 2^64
        text_.append(digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr);
    }
    void append(std::uint32_t number) { append(std::uint64_t{number}); }
    void append(double) = delete;

    std::string text_;
};

} // namespace mrpp

#include "reports/picture/Palette.h"

#include <array>
#include <cmath>
#include <fmt/format.h>

namespace mrpp
{

CurveStyle curveStyle(std::size_t index)
{
    // Okabe and Ito's yellow is too pale for thin lines on white; a grey stands in for it.
    constexpr std::array<const char *, 8> kColors = {"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                                     "#e69f00", "#56b4e9", "#000000", "#7f7f7f"};
    constexpr std::array<const char *, 5> kDashes = {"solid", "(12,5)", "(3,4)", "(12,4,3,4)",
                                                     "(18,4,3,4,3,4)"};
    // Circle, square, triangles up and down, diamond, pentagon: gnuplot's 4 … 15 in pairs hollow, filled.
    constexpr std::array<int, 6> kMarkers = {6, 4, 8, 10, 12, 14};
    const int hollow = kMarkers[index % kMarkers.size()];
    return {kColors[index % kColors.size()], hollow + 1, hollow, kDashes[index % kDashes.size()]};
}

std::string robotColor(std::size_t index)
{
    constexpr std::array<const char *, 7> kColors = {"#0072b2", "#e69f00", "#009e73", "#d55e00",
                                                     "#56b4e9", "#cc79a7", "#f0e442"};
    if (index < kColors.size())
        return kColors[index];
    constexpr double kGoldenAngle = 137.50776405003785;
    const double hue = std::fmod(static_cast<double>(index) * kGoldenAngle, 360.0);
    const double lightness = std::array{0.40, 0.55, 0.70}[index % 3];
    const double chroma = (1 - std::abs(2 * lightness - 1)) * 0.75;
    const auto channel = [&](double shift)
    {
        // The hue circle: each channel rises, stays, falls and rests over 360 degrees.
        const double position = std::fmod(hue / 60 + shift, 6.0);
        const double share = std::fmin(1, std::fmax(0, std::fmin(position, 4 - position)));
        return static_cast<int>(std::lround(255 * (lightness - chroma / 2 + chroma * share)));
    };
    return fmt::format("#{:02x}{:02x}{:02x}", channel(2), channel(0), channel(4));
}

Rgb rgb(const std::string &color)
{
    const auto channel = [&color](std::size_t at)
    { return static_cast<double>(std::stoi(color.substr(at, 2), nullptr, 16)) / 255; };
    return {channel(1), channel(3), channel(5)};
}

std::string textColorOn(const std::string &color)
{
    const auto [red, green, blue] = rgb(color);
    constexpr double kBright = 0.55;
    return 0.299 * red + 0.587 * green + 0.114 * blue > kBright ? "#000000" : "#ffffff";
}

} // namespace mrpp

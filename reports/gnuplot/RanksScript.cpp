#include "reports/gnuplot/ScriptKinds.h"
#include "reports/picture/Text.h"

#include <algorithm>
#include <fmt/format.h>

namespace mrpp
{

namespace
{

// Heights in units of a line of text, from the axis at 0 downwards.
constexpr double kLine = 0.55; // centimetres
constexpr double kFirstBar = 0.55;
constexpr double kBarGap = 0.38;
constexpr std::size_t kNameCharacters = 22; // more would leave the axis no room
constexpr double kAbove = 2.6;              // of the axis: its numbers and the critical difference

} // namespace

std::string ranksScript(const Figure &figure)
{
    const std::size_t count = figure.series.size();
    const std::size_t onLeft = (count + 1) / 2;
    const double firstName = kFirstBar + kBarGap * static_cast<double>(figure.groups.size()) + 0.6;
    const double below = firstName + static_cast<double>(onLeft) + 0.2;
    const auto k = static_cast<double>(count);

    Script script(figure.name);
    script.define("title_text", titleText(figure.title));
    script.define("difference_text", fmt::format("critical difference {:.2f}", figure.criticalDifference));
    std::size_t leftName = 0;
    std::size_t rightName = 0;
    for (std::size_t i = 0; i < count; ++i)
    {
        const std::string label = ellipsize(oneLine(figure.series[i].label), kNameCharacters) +
                                  fmt::format("  {:.2f}", figure.series[i].meanRank);
        std::size_t &name = i < onLeft ? leftName : rightName;
        name = std::max(name, characterCount(label));
        script.define(fmt::format("label_{}", i), label);
    }
    Page page = pageFor(0, 1, kLine * (kAbove + below));
    page.bottom -= kAxisHeight;
    page.top -= kAxisHeight;
    page.height -= kAxisHeight;
    page.left = 0.5 + static_cast<double>(leftName) * kCharacter;
    page.right = kFigureWidth - 0.5 - static_cast<double>(rightName) * kCharacter;

    script.beginFormats(page);
    script.panel(page.left, page.right, page.bottom, page.top);
    script << "set title title_text noenhanced font title_font offset 0,-0.2\n"
              "unset key\nunset border\nunset xtics\nunset ytics\nunset grid\n"
           << fmt::format("set xrange [1:{}]\nset yrange [{}:{}]\n", k, below, -kAbove)
           << fmt::format("set arrow from 1,0 to {},0 nohead lw 1 lc rgb '#000000'\n", k);
    for (std::size_t rank = 1; rank <= count; ++rank)
        script << fmt::format("set arrow from {0},0 to {0},-0.25 nohead lw 1 lc rgb '#000000'\n"
                              "set label '{0}' at {0},-0.7 center\n",
                              rank);
    const double end = std::min(k, 1 + figure.criticalDifference);
    script << fmt::format(
        "set arrow from 1,-1.5 to {},-1.5 heads size screen 0.006,90 lw 1.5 lc rgb '#000000'\n"
        "set label difference_text at 1,-2.05 left noenhanced\n",
        end);
    for (std::size_t g = 0; g < figure.groups.size(); ++g)
    {
        constexpr double kOver = 0.03; // beyond the ranks, so that a bar reaches them
        const double height = kFirstBar + kBarGap * static_cast<double>(g);
        script << fmt::format("set arrow from {},{} to {},{} nohead lw 4 lc rgb '#404040'\n",
                              figure.series[figure.groups[g].first].meanRank - kOver, height,
                              figure.series[figure.groups[g].second].meanRank + kOver, height);
    }
    for (std::size_t i = 0; i < count; ++i)
    {
        const bool isLeft = i < onLeft;
        const double line = firstName + static_cast<double>(isLeft ? i : count - 1 - i);
        const double side = isLeft ? 1 : k;
        const double rank = figure.series[i].meanRank;
        const std::string ink = inkOf(curveStyle(figure.series[i].style));
        script << fmt::format("set arrow from {0},0 to {0},{1} nohead lw 1.2 {3}\n"
                              "set arrow from {0},{1} to {2},{1} nohead lw 1.2 {3}\n",
                              rank, line, side, ink)
               << fmt::format("set label label_{} at {},{} {} offset {},0 noenhanced\n", i, side, line,
                              isLeft ? "right" : "left", isLeft ? -0.5 : 0.5);
    }
    script.plot({"NaN"});
    return script.endFormats();
}

} // namespace mrpp

#pragma once
/// \file
/// A gnuplot script while it is written: what the scripts of all kinds of figures share.

#include "reports/figures/Figure.h"
#include "reports/gnuplot/Axis.h"
#include "reports/picture/Palette.h"

#include <memory>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

namespace mrpp
{

// Lengths in centimetres.
inline constexpr double kFigureWidth = 16;
inline constexpr double kFigureMargin = 0.6; ///< right of a panel
inline constexpr double kAxisHeight = 1.35;  ///< tics and title of a horizontal axis
inline constexpr double kCharacter = 0.195;  ///< of the 9 point font, on average

/// Where the parts of a figure lie, in centimetres from the bottom left.
struct Page
{
    double height = 0;
    double left = 0;   ///< of the main panel
    double right = 0;  ///< of the main panel
    double top = 0;    ///< of the main panel
    double bottom = 0; ///< of the main panel
    std::size_t legendRows = 1;
};

class Script
{
public:
    using Row = std::vector<double>;
    using Blocks = std::vector<std::vector<Row>>; ///< lines are drawn through the rows of a block

    /// Begins with what the file is; names no user gave may stand in `name`.
    explicit Script(const std::string &name);
    ~Script();
    Script(const Script &) = delete;
    Script &operator=(const Script &) = delete;

    template <class T>
    Script &operator<<(const T &value)
    {
        out() << value;
        return *this;
    }

    /// A string variable. Whatever a user named goes into one of them, outside the loop over the formats, and
    /// is only ever referred to.
    void define(const std::string &name, std::string_view text);
    /// A data block $name; a name without rows is left out.
    void block(const std::string &name, const Blocks &blocks);

    /// Everything between the two is drawn once for each format. The page must be complete.
    void beginFormats(const Page &page);
    [[nodiscard]] std::string endFormats();

    /// Edges of the panel to come, in centimetres.
    void panel(double left, double right, double bottom, double top);
    /// \param direction "x" or "y" \param named false for tics without names
    void axis(const std::string &direction, const Axis &axis, bool named = true);
    /// The vertical title of the panel between these heights.
    void verticalTitle(const std::string &variable, double bottom, double top,
                       const std::string &options = "");
    void legend();
    void plot(const std::vector<std::string> &items);

    [[nodiscard]] double x(double centimetres) const { return centimetres / kFigureWidth; }
    [[nodiscard]] double y(double centimetres) const { return centimetres / page_.height; }

private:
    struct Stream;
    std::unique_ptr<Stream> stream_;
    Page page_;

    [[nodiscard]] std::ostream &out();
    void writeTerminals();
};

/// The page of a figure whose legend has `entries` entries of at most `characters`, above it a horizontal
/// axis, `below` more room beneath the panel, and above that a panel of that height.
[[nodiscard]] Page pageFor(std::size_t entries, std::size_t characters, double panelHeight, double below = 0);

/// Left edge of a panel with that vertical axis and a title beside it.
[[nodiscard]] double leftOf(const Axis &axis);

/// "push_and_swap (28/30 solved)": the legend never hides how many runs a curve stands for.
[[nodiscard]] std::string legendText(const Figure &figure, const FigureSeries &series);

/// "lc rgb '#0072b2'".
[[nodiscard]] std::string inkOf(const CurveStyle &style);

/// Text fit for a title or a row's name, cut where it is too long.
[[nodiscard]] std::string titleText(std::string_view text);
[[nodiscard]] std::string rowText(std::string_view text);

/// A tic's name, which gnuplot formats: percent signs doubled.
[[nodiscard]] std::string ticText(std::string_view text);

} // namespace mrpp

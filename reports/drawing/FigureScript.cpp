#include "reports/drawing/FigureScript.h"

#include "framework/support/Config.h"
#include "reports/drawing/Axis.h"
#include "reports/drawing/Numbers.h"
#include "reports/drawing/Palette.h"
#include "reports/drawing/Text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <fmt/format.h>
#include <gnuplot-iostream.h>
#include <unistd.h>

namespace mrpp
{

namespace
{

using Row = std::vector<double>;
using Blocks = std::vector<std::vector<Row>>; ///< lines are drawn through the rows of a block

// Lengths in centimetres.
constexpr double kWidth = 16;
constexpr double kTitleHeight = 0.95;
constexpr double kAxisHeight = 1.35;
constexpr double kLegendRow = 0.43;
constexpr double kCharacter = 0.195; ///< of the 9 point font, on average
constexpr std::size_t kLabelCharacters = 48;
constexpr std::size_t kRowCharacters = 34;
constexpr std::size_t kTitleCharacters = 72;

/// Where the parts of a figure lie. Fractions count from the bottom left, as gnuplot's screen coordinates.
struct Page
{
    double height = 0;
    double left = 0;         ///< of the main panel
    double right = 0;        ///< of the main panel
    double top = 0;          ///< of the main panel
    double bottom = 0;       ///< of the main panel
    std::size_t columns = 1; ///< of the legend

    [[nodiscard]] double x(double centimetres) const { return centimetres / kWidth; }
    [[nodiscard]] double y(double centimetres) const { return centimetres / height; }
};

class ScriptWriter
{
public:
    explicit ScriptWriter(const Figure &figure) : figure_(figure), out_(std::tmpfile())
    {
        out_.imbue(std::locale::classic());
        out_ << std::defaultfloat << std::setprecision(12);
    }

    std::string write()
    {
        arrange();
        writeStrings();
        writeData();
        out_ << "do for [format in 'png pdf svg'] {\n";
        writeTerminals();
        out_ << "set output file_name.'.'.format\n"
                "set multiplot\n"
                "set tics nomirror out scale 0.6,0.3\n"
                "set border 3 lc rgb '#404040'\n"
                "set grid xtics ytics lc rgb '#d9d9d9' lw 0.5 dt solid\n";
        if (figure_.kind == Figure::Kind::curves)
            writeCurves();
        else
            writeComparison();
        out_ << "unset multiplot\n"
                "reset\n"
                "}\n"
                "set output\n";
        return contents();
    }

private:
    const Figure &figure_;
    Gnuplot out_;
    Page page_;
    Axis measure_;
    Axis sweep_;
    double unit_ = 1; ///< the axis shows values divided by it
    std::string measureText_;

    [[nodiscard]] bool hasSuccessPanel() const { return !figure_.isPercentage; }
    [[nodiscard]] bool hasBounds() const { return !figure_.bounds.empty(); }

    [[nodiscard]] static bool hasValue(const FigureSeries &series)
    {
        return std::any_of(series.points.begin(), series.points.end(),
                           [](const FigurePoint &point) { return point.value.has_value(); });
    }

    /// "push_and_swap (28/30 solved)": the legend never hides how many runs a curve stands for.
    [[nodiscard]] static std::string legendText(const FigureSeries &series)
    {
        std::size_t solved = 0;
        std::size_t runs = 0;
        for (const FigurePoint &point : series.points)
        {
            solved += point.solved;
            runs += point.runs;
        }
        return ellipsize(oneLine(series.label), kLabelCharacters) +
               fmt::format(" ({}/{} solved)", solved, runs);
    }

    void arrange()
    {
        std::vector<double> values;
        std::vector<double> places;
        std::size_t longest = characterCount(figure_.boundLabel);
        for (const FigureSeries &series : figure_.series)
        {
            longest = std::max(longest, characterCount(legendText(series)));
            for (const FigurePoint &point : series.points)
            {
                places.push_back(point.at);
                if (point.value)
                    values.insert(values.end(), {point.value->q1, point.value->q3});
            }
        }
        for (const FigureBound &bound : figure_.bounds)
            values.push_back(bound.value);
        chooseUnit(values);
        for (double &value : values)
            value /= unit_;
        measure_ = figure_.isPercentage
                       ? Axis{false, -4, 104, {{0, "0"}, {25, "25"}, {50, "50"}, {75, "75"}, {100, "100"}}}
                       : measureAxis(values);
        sweep_ = sweepAxis(std::move(places));

        const std::size_t entries = figure_.series.size() + (hasBounds() ? 1 : 0);
        const double entryWidth = static_cast<double>(longest) * kCharacter + 1.9;
        page_.columns = std::clamp<std::size_t>(static_cast<std::size_t>(kWidth / entryWidth), 1, 4);
        const std::size_t legendRows = (entries + page_.columns - 1) / page_.columns;
        const double legend = static_cast<double>(legendRows) * kLegendRow + 0.25;
        if (figure_.kind == Figure::Kind::curves)
        {
            constexpr double kPanel = 6.6;
            constexpr double kSuccessPanel = 2.0; // with the gap above it
            page_.left = 2.4;
            page_.right = kWidth - 0.6;
            page_.bottom = legend + kAxisHeight + (hasSuccessPanel() ? kSuccessPanel : 0);
            page_.top = page_.bottom + kPanel;
        }
        else
        {
            constexpr double kSuccessPanel = 2.9; // with the gap beside it
            std::size_t name = 0;
            for (const std::string &row : figure_.rows)
                name = std::max(name, std::min(kRowCharacters, characterCount(row)));
            page_.left = std::max(2.2, 0.7 + static_cast<double>(name) * kCharacter);
            page_.right = kWidth - 0.6 - (hasSuccessPanel() ? kSuccessPanel : 0);
            page_.bottom = legend + kAxisHeight;
            page_.top = page_.bottom + std::max(2.0, rowHeight() * static_cast<double>(figure_.rows.size()));
        }
        page_.height = page_.top + kTitleHeight;
    }

    /// Times are shown in a unit that keeps the axis free of tiny numbers; the .csv keeps seconds.
    void chooseUnit(const std::vector<double> &values)
    {
        constexpr std::string_view kSeconds = " (s)";
        measureText_ = figure_.measure;
        if (values.empty() || !figure_.measure.ends_with(kSeconds))
            return;
        const TimeUnit unit = measureAxis(values).logarithmic
                                  ? timeUnit(values)
                                  : timeUnit(*std::max_element(values.begin(), values.end()));
        unit_ = unit.seconds;
        measureText_.resize(measureText_.size() - kSeconds.size());
        measureText_ += fmt::format(" ({})", unit.name);
    }

    [[nodiscard]] double rowHeight() const
    {
        return std::max(0.6, 0.2 * static_cast<double>(figure_.series.size()) + 0.2);
    }

    /// Whatever a user named goes into string variables here, outside the loop, and is only ever referred to.
    void writeStrings()
    {
        out_ << "# Written by mrppsim. `gnuplot -d " << figure_.name
             << ".gp`, run in this file's folder, draws it again.\n"
                "reset\n"
                "set encoding utf8\n";
        const auto define = [this](const std::string &name, const std::string &text)
        { out_ << name << " = " << gnuplotString(text) << "\n"; };
        define("file_name", figure_.name);
        define("title_text", ellipsize(oneLine(figure_.title), kTitleCharacters));
        define("measure_text", measureText_);
        if (figure_.kind == Figure::Kind::curves)
            define("variable_text", ellipsize(oneLine(figure_.variable), kTitleCharacters));
        for (std::size_t i = 0; i < figure_.series.size(); ++i)
            define(fmt::format("label_{}", i), legendText(figure_.series[i]));
        if (hasBounds())
            define("bound_text", figure_.boundLabel);
        for (std::size_t i = 0; i < figure_.rows.size(); ++i)
        {
            std::string row; // gnuplot formats the names of tics
            for (const char c : ellipsize(oneLine(figure_.rows[i]), kRowCharacters))
                row += c == '%' ? std::string("%%") : std::string(1, c);
            define(fmt::format("row_{}", i), row);
        }
    }

    /// A data block: gnuplot-iostream ends what it sends with a line "e", which is the block's end here.
    void writeBlock(const std::string &name, const Blocks &blocks)
    {
        out_ << "$" << name << " << e\n";
        out_.send2d(blocks);
    }

    /// Where the i-th series stands within its row of a comparison, −0.4 … 0.4.
    [[nodiscard]] double lane(std::size_t index) const
    {
        const auto lanes = static_cast<double>(figure_.series.size());
        return ((static_cast<double>(index) + 0.5) / lanes - 0.5) * 0.8;
    }

    void writeData()
    {
        for (std::size_t i = 0; i < figure_.series.size(); ++i)
        {
            const FigureSeries &series = figure_.series[i];
            const double shift = figure_.kind == Figure::Kind::comparison ? lane(i) : 0;
            Blocks values(1);
            Blocks success(1);
            for (const FigurePoint &point : series.points)
            {
                const auto solved = static_cast<double>(point.solved);
                const auto runs = static_cast<double>(point.runs);
                success[0].push_back({point.at + shift, runs > 0 ? 100 * solved / runs : 0});
                if (point.value)
                    values.back().push_back({point.at + shift, point.value->median / unit_,
                                             point.value->q1 / unit_, point.value->q3 / unit_, solved, runs,
                                             0});
                else if (!values.back().empty())
                    values.emplace_back();
            }
            if (values.back().empty())
                values.pop_back();
            for (std::vector<Row> &piece : values) // a band of one point is nothing to see; it gets a bar
                if (piece.size() == 1)
                    piece.front().back() = 1;
            if (!values.empty())
                writeBlock(fmt::format("values_{}", i), values);
            if (!success[0].empty() && hasSuccessPanel())
                writeBlock(fmt::format("success_{}", i), success);
        }
        Blocks bounds(1);
        for (const FigureBound &bound : figure_.bounds)
            if (figure_.kind == Figure::Kind::comparison)
                bounds[0].push_back({bound.value / unit_, bound.at - 0.42, 0, 0.84});
            else
                bounds[0].push_back({bound.at, bound.value / unit_});
        if (hasBounds())
            writeBlock("bounds", bounds);
    }

    void writeTerminals()
    {
        constexpr double kInch = 2.54;
        constexpr double kPrintResolution = 300; // dots per inch; gnuplot's points are 1/72 inch
        constexpr double kScreenResolution = 96;
        const auto pixels = [](double centimetres, double resolution)
        { return static_cast<int>(std::lround(centimetres / kInch * resolution)); };
        // gnuplot's cairo terminals count 96 pixels of text an inch and 72 of everything else.
        const std::string scale = fmt::format("{:.4f}", kPrintResolution / 72);
        const std::string fontScale = fmt::format("{:.4f}", kPrintResolution / 96);
        out_ << "if (format eq 'png') { set terminal pngcairo noenhanced size "
             << pixels(kWidth, kPrintResolution) << "," << pixels(page_.height, kPrintResolution)
             << " font 'DejaVu Sans,9' fontscale " << fontScale << " linewidth " << scale << " pointscale "
             << scale << " }\n"
             << "if (format eq 'pdf') { set terminal pdfcairo noenhanced size "
             << fmt::format("{:.2f}", kWidth) << "cm," << fmt::format("{:.2f}", page_.height)
             << "cm font 'DejaVu Sans,9' fontscale 0.75 }\n"
             << "if (format eq 'svg') { set terminal svg noenhanced size "
             << pixels(kWidth, kScreenResolution) << "," << pixels(page_.height, kScreenResolution)
             << " font 'DejaVu Sans,12' background '#ffffff' }\n"
             << "title_font = 'DejaVu Sans Bold,'.(format eq 'svg' ? '13.3' : '10')\n"
             << "small_font = 'DejaVu Sans,'.(format eq 'svg' ? '10.6' : '8')\n";
    }

    void writePanel(double left, double right, double bottom, double top)
    {
        out_ << fmt::format("set lmargin at screen {:.5f}\nset rmargin at screen {:.5f}\n"
                            "set bmargin at screen {:.5f}\nset tmargin at screen {:.5f}\n",
                            page_.x(left), page_.x(right), page_.y(bottom), page_.y(top));
    }

    /// \param name "x" or "y"
    void writeAxis(const std::string &name, const Axis &axis, bool named = true)
    {
        out_ << (axis.logarithmic ? "set" : "unset") << " logscale " << name << "\n"
             << "set " << name << "range [" << axis.least << ":" << axis.most << "]\n";
        if (!axis.tics.empty())
        {
            out_ << "set " << name << "tics (";
            for (std::size_t i = 0; i < axis.tics.size(); ++i)
                out_ << (i == 0 ? "" : ", ") << (named ? gnuplotString(axis.tics[i].label) : "''") << " "
                     << axis.tics[i].at << (axis.tics[i].label.empty() ? " 1" : "");
            out_ << ")\n";
        }
        else
        {
            out_ << "set " << name << "tics autofreq\nset format " << name
                 << (named ? " '%.10g'\n" : " ''\n");
        }
    }

    void writeLegendPlace()
    {
        out_ << fmt::format("set key at screen 0.04,{:.5f} left bottom horizontal Left reverse noenhanced "
                            "samplen 3 spacing 1.1 width 1 maxcols {}\n",
                            page_.y(0.15), page_.columns);
    }

    void writeItems(const std::vector<std::string> &items)
    {
        out_ << "plot ";
        for (std::size_t i = 0; i < items.size(); ++i)
            out_ << (i == 0 ? "" : ", \\\n     ") << items[i];
        out_ << "\n";
    }

    [[nodiscard]] static std::string color(const CurveStyle &style)
    {
        return fmt::format("lc rgb '{}'", style.color);
    }

    /// Filled markers where every run was solved, hollow ones where only some were.
    static void addMarkers(std::vector<std::string> &items, const std::string &data,
                           const std::string &columns, const CurveStyle &style)
    {
        const auto add = [&](const char *condition, int marker, const std::string &ink)
        {
            items.push_back(fmt::format("{} using {} with points pt {} ps 0.7 {} notitle", data,
                                        fmt::format(fmt::runtime(columns), condition), marker, ink));
        };
        add("$5==$6", style.filledMarker, color(style));
        add("$5<$6", style.filledMarker, "lc rgb '#ffffff'");
        add("$5<$6", style.hollowMarker, color(style));
    }

    void writeCurves()
    {
        writePanel(page_.left, page_.right, page_.bottom, page_.top);
        writeAxis("x", sweep_, !hasSuccessPanel());
        writeAxis("y", measure_);
        const double labelShift = 0.55;
        out_ << fmt::format("set label 1 measure_text at screen {:.5f},{:.5f} center rotate noenhanced\n",
                            page_.x(labelShift), page_.y((page_.top + page_.bottom) / 2))
             << "set title title_text noenhanced font title_font offset 0,-0.2\n";
        if (!hasSuccessPanel())
            out_ << "set xlabel variable_text noenhanced\n";
        writeLegendPlace();
        std::vector<std::string> items;
        for (std::size_t i = 0; i < figure_.series.size() && !figure_.isPercentage; ++i)
            if (hasValue(figure_.series[i]))
                items.push_back(
                    fmt::format("$values_{} using 1:3:4 with filledcurves fs transparent solid 0.15 "
                                "noborder {} notitle",
                                i, color(curveStyle(figure_.series[i].style))));
        if (hasBounds())
        {
            items.emplace_back("$bounds using 1:2 with lines lw 1.2 dt (4,4) lc rgb '#606060' notitle");
            items.emplace_back("keyentry with lines lw 1.2 dt (4,4) lc rgb '#606060' title bound_text");
        }
        for (std::size_t i = 0; i < figure_.series.size(); ++i)
        {
            const CurveStyle style = curveStyle(figure_.series[i].style);
            const std::string data = fmt::format("$values_{}", i);
            if (hasValue(figure_.series[i]))
            {
                items.push_back(
                    fmt::format("{} using 1:($7==1?$2:NaN):3:4 with yerrorbars ps 0 lw 1 {} notitle", data,
                                color(style)));
                items.push_back(fmt::format("{} using 1:2 with lines lw 1.5 dt {} {} notitle", data,
                                            style.dashes, color(style)));
                addMarkers(items, data, "1:({}?$2:NaN)", style);
            }
            items.push_back(
                fmt::format("keyentry with linespoints pt {} ps 0.7 lw 1.5 dt {} {} title label_{}",
                            style.filledMarker, style.dashes, color(style), i));
        }
        writeItems(items);
        if (hasSuccessPanel())
            writeSuccessBeneath();
    }

    void writeSuccessBeneath()
    {
        constexpr double kGap = 0.35;
        const double bottom = page_.bottom - 2.0;
        const double top = page_.bottom - kGap;
        writePanel(page_.left, page_.right, bottom, top);
        writeAxis("x", sweep_);
        writeAxis("y", {false, -12, 112, {{0, "0"}, {50, "50"}, {100, "100"}}});
        out_ << fmt::format("set label 1 'Solved (%)' at screen {:.5f},{:.5f} center rotate noenhanced font "
                            "small_font\n",
                            page_.x(0.55), page_.y((top + bottom) / 2))
             << "unset title\nunset key\nset xlabel variable_text noenhanced\n";
        std::vector<std::string> items;
        for (std::size_t i = 0; i < figure_.series.size(); ++i)
        {
            const CurveStyle style = curveStyle(figure_.series[i].style);
            if (!figure_.series[i].points.empty())
                items.push_back(
                    fmt::format("$success_{} using 1:2 with linespoints pt {} ps 0.45 lw 1.2 dt {} {}", i,
                                style.filledMarker, style.dashes, color(style)));
        }
        writeItems(items);
    }

    void writeComparison()
    {
        const auto rows = static_cast<double>(figure_.rows.size());
        for (std::size_t row = 1; row < figure_.rows.size(); row += 2)
            out_ << fmt::format(
                "set object {0} rectangle from graph 0, first {1} to graph 1, first {2} behind "
                "fc rgb '#f0f0f0' fs solid noborder\n",
                row, static_cast<double>(row) - 0.5, static_cast<double>(row) + 0.5);
        writePanel(page_.left, page_.right, page_.bottom, page_.top);
        writeAxis("x", measure_);
        out_ << "set yrange [" << rows - 0.5 << ":-0.5]\nset ytics (";
        for (std::size_t row = 0; row < figure_.rows.size(); ++row)
            out_ << (row == 0 ? "" : ", ") << "row_" << row << " " << row;
        out_ << ") scale 0\n"
                "set grid noytics\n"
                "set xlabel measure_text noenhanced\n"
                "set title title_text noenhanced font title_font offset 0,-0.2\n";
        writeLegendPlace();
        std::vector<std::string> items;
        if (hasBounds())
        {
            items.emplace_back("$bounds using 1:2:3:4 with vectors nohead lw 1.5 lc rgb '#303030' notitle");
            items.emplace_back("keyentry with vectors nohead lw 1.5 lc rgb '#303030' title bound_text");
        }
        for (std::size_t i = 0; i < figure_.series.size(); ++i)
        {
            const CurveStyle style = curveStyle(figure_.series[i].style);
            const std::string data = fmt::format("$values_{}", i);
            if (hasValue(figure_.series[i]))
            {
                items.push_back(
                    fmt::format("{} using 2:1:3:4 with xerrorbars ps 0 lw 1 {} notitle", data, color(style)));
                addMarkers(items, data, "({}?$2:NaN):1", style);
            }
            items.push_back(fmt::format("keyentry with points pt {} ps 0.7 {} title label_{}",
                                        style.filledMarker, color(style), i));
        }
        writeItems(items);
        if (hasSuccessPanel())
            writeSuccessBeside();
    }

    void writeSuccessBeside()
    {
        constexpr double kGap = 0.4;
        writePanel(page_.right + kGap, kWidth - 0.6, page_.bottom, page_.top);
        writeAxis("x", {false, -12, 112, {{0, "0"}, {50, "50"}, {100, "100"}}});
        out_ << "set format y ''\nset ytics () scale 0\nset xlabel 'Solved (%)' noenhanced\nunset "
                "title\nunset key\n";
        std::vector<std::string> items;
        for (std::size_t i = 0; i < figure_.series.size(); ++i)
        {
            const CurveStyle style = curveStyle(figure_.series[i].style);
            if (!figure_.series[i].points.empty())
                items.push_back(fmt::format("$success_{} using 2:1 with points pt {} ps 0.55 {}", i,
                                            style.filledMarker, color(style)));
        }
        writeItems(items);
    }

    /// What was written so far, read back from the anonymous file behind the stream.
    std::string contents()
    {
        out_ << std::flush;
        const int file = out_->handle();
        std::string text;
        std::array<char, 65536> buffer{};
        for (ssize_t size = 0;
             (size = ::pread(file, buffer.data(), buffer.size(), static_cast<off_t>(text.size()))) > 0;)
            text.append(buffer.data(), static_cast<std::size_t>(size));
        return text;
    }
};

} // namespace

std::string gnuplotString(std::string_view text)
{
    std::string quoted = "'";
    for (const char c : oneLine(text))
        quoted += c == '\'' ? std::string("'.\"'\".'") : std::string(1, c);
    return quoted + "'";
}

std::string gnuplotScript(const Figure &figure)
{
    return ScriptWriter(figure).write();
}

} // namespace mrpp

#include "reports/gnuplot/Script.h"

#include "reports/gnuplot/FigureScript.h"
#include "reports/picture/Text.h"

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

constexpr double kTitleHeight = 0.95; // centimetres
constexpr double kLegendRow = 0.43;   // centimetres
constexpr double kTitleCentre = 0.55; // centimetres from the left, of a vertical title
constexpr std::size_t kLabelCharacters = 48;
constexpr std::size_t kRowCharacters = 34;
constexpr std::size_t kTitleCharacters = 72;

} // namespace

/// gnuplot-iostream encodes the data; it writes into an anonymous file.
struct Script::Stream
{
    Gnuplot gnuplot{std::tmpfile()};
};

Script::Script(const std::string &name) : stream_(std::make_unique<Stream>())
{
    out().imbue(std::locale::classic());
    out() << std::defaultfloat << std::setprecision(12) << "# Written by mrppsim. `gnuplot -d " << name
          << ".gp`, run in this file's folder, draws it again.\nreset\nset encoding utf8\n";
    define("file_name", name);
}

Script::~Script() = default;

std::ostream &Script::out()
{
    return stream_->gnuplot;
}

void Script::define(const std::string &name, std::string_view text)
{
    out() << name << " = " << gnuplotString(text) << "\n";
}

void Script::block(const std::string &name, const Blocks &blocks)
{
    if (blocks.empty() || blocks.front().empty())
        return;
    out() << "$" << name << " << e\n"; // gnuplot-iostream ends what it sends with a line "e"
    stream_->gnuplot.send2d(blocks);
}

void Script::beginFormats(const Page &page)
{
    page_ = page;
    out() << "do for [format in 'png pdf svg'] {\n";
    writeTerminals();
    out() << "set output file_name.'.'.format\n"
             "set multiplot\n"
             "set tics nomirror out scale 0.6,0.3\n"
             "set border 3 lc rgb '#404040'\n"
             "set grid xtics ytics lc rgb '#d9d9d9' lw 0.5 dt solid\n";
}

std::string Script::endFormats()
{
    out() << "unset multiplot\nreset\n}\nset output\n" << std::flush;
    std::string text;
    std::array<char, 65536> buffer{};
    for (ssize_t size = 0; (size = ::pread(stream_->gnuplot->handle(), buffer.data(), buffer.size(),
                                           static_cast<off_t>(text.size()))) > 0;)
        text.append(buffer.data(), static_cast<std::size_t>(size));
    return text;
}

void Script::writeTerminals()
{
    constexpr double kInch = 2.54;
    constexpr double kPrintResolution = 300; // dots per inch; gnuplot's points are 1/72 inch
    constexpr double kScreenResolution = 96;
    const auto pixels = [](double centimetres, double resolution)
    { return static_cast<int>(std::lround(centimetres / kInch * resolution)); };
    // gnuplot's cairo terminals count 96 pixels of text an inch and 72 of everything else.
    const std::string scale = fmt::format("{:.4f}", kPrintResolution / 72);
    const std::string fontScale = fmt::format("{:.4f}", kPrintResolution / 96);
    out() << "if (format eq 'png') { set terminal pngcairo noenhanced size "
          << pixels(kFigureWidth, kPrintResolution) << "," << pixels(page_.height, kPrintResolution)
          << " font 'DejaVu Sans,9' fontscale " << fontScale << " linewidth " << scale << " pointscale "
          << scale << " }\n"
          << "if (format eq 'pdf') { set terminal pdfcairo noenhanced size "
          << fmt::format("{:.2f}", kFigureWidth) << "cm," << fmt::format("{:.2f}", page_.height)
          << "cm font 'DejaVu Sans,9' fontscale 0.75 }\n"
          << "if (format eq 'svg') { set terminal svg noenhanced size "
          << pixels(kFigureWidth, kScreenResolution) << "," << pixels(page_.height, kScreenResolution)
          << " font 'DejaVu Sans,12' background '#ffffff' }\n"
          << "title_font = 'DejaVu Sans Bold,'.(format eq 'svg' ? '13.3' : '10')\n"
          << "small_font = 'DejaVu Sans,'.(format eq 'svg' ? '10.6' : '8')\n";
}

void Script::panel(double left, double right, double bottom, double top)
{
    out() << fmt::format("set lmargin at screen {:.5f}\nset rmargin at screen {:.5f}\n"
                         "set bmargin at screen {:.5f}\nset tmargin at screen {:.5f}\n",
                         x(left), x(right), y(bottom), y(top));
}

void Script::axis(const std::string &direction, const Axis &axis, bool named)
{
    out() << (axis.logarithmic ? "set" : "unset") << " logscale " << direction << "\n"
          << "set " << direction << "range [" << axis.least << ":" << axis.most << "]\n";
    if (axis.tics.empty())
    {
        out() << "set " << direction << "tics autofreq\nset format " << direction
              << (named ? " '%.10g'\n" : " ''\n");
        return;
    }
    out() << "set " << direction << "tics (";
    for (std::size_t i = 0; i < axis.tics.size(); ++i)
        out() << (i == 0 ? "" : ", ") << (named ? gnuplotString(axis.tics[i].label) : "''") << " "
              << axis.tics[i].at << (axis.tics[i].label.empty() ? " 1" : "");
    out() << ")\n";
}

void Script::verticalTitle(const std::string &variable, double bottom, double top, const std::string &options)
{
    out() << fmt::format("set label 1 {} at screen {:.5f},{:.5f} center rotate noenhanced{}\n", variable,
                         x(kTitleCentre), y((top + bottom) / 2), options);
}

void Script::legend()
{
    out() << fmt::format("set key at screen 0.04,{:.5f} left bottom vertical Left reverse noenhanced "
                         "samplen 3 spacing 1.1 width -1 maxrows {}\n",
                         y(0.15), page_.legendRows);
}

void Script::plot(const std::vector<std::string> &items)
{
    out() << "plot ";
    for (std::size_t i = 0; i < items.size(); ++i)
        out() << (i == 0 ? "" : ", \\\n     ") << items[i];
    out() << "\n";
}

Page pageFor(std::size_t entries, std::size_t characters, double panelHeight, double below)
{
    Page page;
    const double entryWidth = static_cast<double>(characters) * kCharacter + 1.9;
    const std::size_t columns =
        std::clamp<std::size_t>(static_cast<std::size_t>(kFigureWidth / entryWidth), 1, 4);
    page.legendRows = std::max<std::size_t>(1, (entries + columns - 1) / columns);
    const double legend = entries == 0 ? 0.1 : static_cast<double>(page.legendRows) * kLegendRow + 0.25;
    page.left = 2.4;
    page.right = kFigureWidth - kFigureMargin;
    page.bottom = legend + kAxisHeight + below;
    // gnuplot begins another column where a legend is higher than its panel.
    page.top = page.bottom + std::max(panelHeight, static_cast<double>(page.legendRows + 1) * kLegendRow);
    page.height = page.top + kTitleHeight;
    return page;
}

double leftOf(const Axis &axis)
{
    constexpr double kDigit = 0.205;
    constexpr double kBesides = 1.25; // the title, half its height, the tics, and gaps
    std::size_t longest = axis.tics.empty() ? 7 : 0;
    for (const Tic &tic : axis.tics)
        longest = std::max(longest, characterCount(tic.label));
    return std::max(2.4, kBesides + static_cast<double>(longest) * kDigit);
}

std::string legendText(const Figure &figure, const FigureSeries &series)
{
    std::size_t solved = series.solved;
    std::size_t runs = series.runs;
    for (const FigurePoint &point : series.points)
    {
        solved += point.solved;
        runs += point.runs;
    }
    return ellipsize(oneLine(series.label), kLabelCharacters) +
           (runs == 0 || !figure.countsSolved
                ? series.remark
                : fmt::format(" ({}/{} solved){}", solved, runs, series.remark));
}

std::string inkOf(const CurveStyle &style)
{
    return fmt::format("lc rgb '{}'", style.color);
}

std::string titleText(std::string_view text)
{
    return ellipsize(oneLine(text), kTitleCharacters);
}

std::string rowText(std::string_view text)
{
    return ellipsize(oneLine(text), kRowCharacters);
}

std::string ticText(std::string_view text)
{
    std::string tic;
    for (const char c : text)
        tic += c == '%' ? std::string("%%") : std::string(1, c);
    return tic;
}

} // namespace mrpp

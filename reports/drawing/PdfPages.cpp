#include "reports/drawing/PdfPages.h"

#include "reports/drawing/CairoCanvas.h"
#include "reports/drawing/PdfFile.h"
#include "reports/drawing/Picture.h"
#include "reports/drawing/Text.h"

#include <algorithm>
#include <cairo-pdf.h>
#include <fmt/format.h>
#include <list>
#include <numeric>

namespace mrpp
{

namespace
{

// Points of 1/72 inch.
constexpr double kPageWidth = 595.276;
constexpr double kPageHeight = 841.89;
constexpr double kMargin = 56;
constexpr double kTextWidth = kPageWidth - 2 * kMargin;
constexpr double kBottom = kPageHeight - kMargin - 12;
constexpr double kCellGap = 7;
constexpr double kTableFont = 7.5;
constexpr double kSmallestTableFont = 5;

double heightOf(const TextLayout &text)
{
    return sizeOf(text).height;
}

} // namespace

struct PdfPages::State
{
    std::string bytes;
    std::string title;
    std::string footer;
    CairoSurface surface;
    CairoContext context;
    std::size_t page = 0; ///< from 0
    double y = kMargin;
    int chapterOutline = CAIRO_PDF_OUTLINE_ROOT;
    std::size_t drawings = 0;
    std::list<std::string> sources; ///< the placed drawings' bytes
    std::vector<PdfPlacement> placements;

    [[nodiscard]] cairo_t *cairo() const { return context.get(); }

    /// As wide as the page unless the style says otherwise.
    [[nodiscard]] TextLayout layout(const std::string &text, TextStyle style) const
    {
        if (style.width < 0)
            style.width = kTextWidth;
        return layText(cairo(), text, style);
    }

    void show(const TextLayout &text, double x, double top) const { showText(cairo(), text, x, top); }

    void setColor(double red, double green, double blue) const
    {
        cairo_set_source_rgb(cairo(), red, green, blue);
    }
    void setBlack() const { setColor(0.1, 0.1, 0.1); }
    void setGrey() const { setColor(0.42, 0.42, 0.42); }

    void line(double top, double width, double grey) const
    {
        setColor(grey, grey, grey);
        cairo_set_line_width(cairo(), width);
        cairo_move_to(cairo(), kMargin, top);
        cairo_line_to(cairo(), kMargin + kTextWidth, top);
        cairo_stroke(cairo());
        setBlack();
    }

    void drawFooter() const
    {
        setGrey();
        const double top = kPageHeight - kMargin + 8;
        show(layout(footer, {"DejaVu Sans 7.5", kTextWidth * 0.8, PANGO_ALIGN_LEFT, 1}), kMargin, top);
        show(layout(std::to_string(page + 1), {"DejaVu Sans 7.5", kTextWidth * 0.15, PANGO_ALIGN_RIGHT}),
             kMargin + kTextWidth * 0.85, top);
        setBlack();
    }

    void newPage()
    {
        drawFooter();
        cairo_show_page(cairo());
        ++page;
        y = kMargin;
    }

    /// A new page unless so many points are left on this one.
    void need(double height)
    {
        if (y + height > kBottom && y > kMargin)
            newPage();
    }

    int outline(int parent, const std::string &text) const
    {
        const std::string target = fmt::format("page={} pos=[{:.1f} {:.1f}]", page + 1, kMargin, y);
        return cairo_pdf_surface_add_outline(surface.get(), parent, text.c_str(), target.c_str(),
                                             static_cast<cairo_pdf_outline_flags_t>(0));
    }

    void text(const std::string &words, const TextStyle &style, double after)
    {
        const TextLayout made = layout(words, style);
        const double height = heightOf(made);
        need(height);
        show(made, kMargin, y);
        y += height + after;
    }
};

namespace
{

/// A table row laid out.
struct LaidRow
{
    std::vector<TextLayout> cells;
    double height = 0;
};

/// What a table's column asks for, in points.
struct ColumnNeed
{
    double least = 0;   ///< numbers in full, the words of headings
    double natural = 0; ///< with nothing wrapped
};

std::vector<ColumnNeed> columnNeeds(const PdfPages::State &state, const std::vector<PdfTableColumn> &columns,
                                    const std::vector<std::vector<PdfTableCell>> &rows, double fontSize)
{
    constexpr double kLeastText = 60; // points, for text that wraps
    constexpr double kRoom = 0.5;     // against rounding
    const TextLayout ruler = layText(state.cairo(), "", {fmt::format("DejaVu Sans Bold {}", fontSize)});
    const auto widthOf = [&](std::string_view text)
    {
        pango_layout_set_text(ruler.get(), text.data(), static_cast<int>(text.size()));
        return sizeOf(ruler).width + kRoom;
    };
    std::vector<ColumnNeed> needs;
    for (std::size_t c = 0; c < columns.size(); ++c)
    {
        ColumnNeed need;
        const std::string title = oneLine(columns[c].title);
        for (std::size_t begin = 0; begin < title.size();)
        {
            const std::size_t end = std::min(title.find(' ', begin), title.size());
            need.least = std::max(need.least, widthOf(std::string_view(title).substr(begin, end - begin)));
            begin = end + 1;
        }
        double widest = 0;
        for (const std::vector<PdfTableCell> &row : rows)
            widest = std::max(widest, widthOf(oneLine(row[c].text)));
        need.natural = std::max(need.least, widest);
        need.least = std::max(need.least, columns[c].isRight ? widest : std::min(widest, kLeastText));
        needs.push_back(need);
    }
    return needs;
}

/// Widths that fill the page with the gaps between them. Every column gets the least it needs, and of the
/// rest first those that want little more. Nothing where the least does not fit, unless `mayFail` is false.
std::vector<double> shareWidth(const std::vector<ColumnNeed> &needs, bool mayFail)
{
    std::vector<double> widths;
    double rest = kTextWidth - kCellGap * static_cast<double>(needs.size() - 1);
    for (const ColumnNeed &need : needs)
    {
        widths.push_back(need.least);
        rest -= need.least;
    }
    if (rest < 0)
    {
        if (mayFail)
            return {};
        const double sum = std::accumulate(widths.begin(), widths.end(), 0.0);
        for (double &width : widths)
            width *= (sum + rest) / sum;
        return widths;
    }
    std::vector<std::size_t> order(needs.size());
    std::iota(order.begin(), order.end(), 0);
    const auto wish = [&](std::size_t c) { return needs[c].natural - needs[c].least; };
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return wish(a) < wish(b); });
    for (std::size_t i = 0; i < order.size(); ++i)
    {
        const double given = std::min(wish(order[i]), rest / static_cast<double>(order.size() - i));
        widths[order[i]] += given;
        rest -= given;
    }
    for (double &width : widths)
        width += rest / static_cast<double>(widths.size());
    return widths;
}

/// Lets a name that is too long for its cell go on in the next line behind an underscore.
std::string breakable(const std::string &text, bool isLong)
{
    if (!isLong)
        return text;
    std::string result;
    for (const char c : text)
        result += c == '_' ? std::string("_\u200B") : std::string(1, c);
    return result;
}

} // namespace

PdfPages::PdfPages(const std::string &title, const std::string &footer) : state_(std::make_unique<State>())
{
    State &s = *state_;
    s.title = oneLine(title);
    s.footer = oneLine(footer);
    s.surface.reset(cairo_pdf_surface_create_for_stream(appendToString, &s.bytes, kPageWidth, kPageHeight));
    s.context.reset(cairo_create(s.surface.get()));
    s.setBlack();
}

PdfPages::~PdfPages() = default;

void PdfPages::title(const std::string &text, const std::string &subtitle)
{
    State &s = *state_;
    s.outline(CAIRO_PDF_OUTLINE_ROOT, oneLine(text));
    s.setGrey();
    s.text(oneLine(subtitle), {"DejaVu Sans 11"}, 6);
    s.setBlack();
    s.text(oneLine(text), {"DejaVu Sans Bold 26", kTextWidth, PANGO_ALIGN_LEFT, 4}, 10);
    s.line(s.y, 1.2, 0.1);
    s.y += 16;
}

void PdfPages::chapter(const std::string &text)
{
    State &s = *state_;
    if (s.y > kMargin)
        s.newPage();
    s.chapterOutline = s.outline(CAIRO_PDF_OUTLINE_ROOT, oneLine(text));
    s.text(oneLine(text), {"DejaVu Sans Bold 18", kTextWidth, PANGO_ALIGN_LEFT, 2}, 10);
}

void PdfPages::section(const std::string &text)
{
    State &s = *state_;
    constexpr double kWithWhatFollows = 90;
    s.need(kWithWhatFollows);
    s.y += s.y > kMargin ? 8 : 0;
    s.outline(s.chapterOutline, oneLine(text));
    s.text(oneLine(text), {"DejaVu Sans Bold 11", kTextWidth, PANGO_ALIGN_LEFT, 2}, 5);
}

void PdfPages::paragraph(const std::string &text)
{
    state_->text(manyLines(text), {"DejaVu Sans 9"}, 8);
}

void PdfPages::facts(const std::vector<std::pair<std::string, std::string>> &pairs)
{
    State &s = *state_;
    constexpr double kNames = 105;
    for (const auto &[name, value] : pairs)
    {
        const TextLayout left = s.layout(oneLine(name), {"DejaVu Sans 9", kNames - kCellGap});
        const TextLayout right =
            s.layout(oneLine(value), {"DejaVu Sans 9", kTextWidth - kNames, PANGO_ALIGN_LEFT, 6});
        const double height = std::max(heightOf(left), heightOf(right));
        s.need(height);
        s.setGrey();
        s.show(left, kMargin, s.y);
        s.setBlack();
        s.show(right, kMargin + kNames, s.y);
        s.y += height + 2.5;
    }
    s.y += 10;
}

void PdfPages::verbatim(const std::string &text)
{
    State &s = *state_;
    const std::string clean = manyLines(text);
    for (std::size_t begin = 0; begin < clean.size();)
    {
        const std::size_t end = std::min(clean.find('\n', begin), clean.size());
        const std::string line = clean.substr(begin, end - begin);
        constexpr double kCharacter = 7 * 0.602; // width of this font
        constexpr std::size_t kDeepest = 40;
        const std::size_t blanks = std::min({line.find_first_not_of(' '), line.size(), kDeepest});
        s.text(line.empty() ? " " : line,
               {"DejaVu Sans Mono 7", kTextWidth, PANGO_ALIGN_LEFT, 0,
                static_cast<double>(blanks + 4) * kCharacter},
               0.5);
        begin = end + 1;
    }
    s.y += 8;
}

void PdfPages::table(const std::vector<PdfTableColumn> &columns,
                     const std::vector<std::vector<PdfTableCell>> &rows)
{
    State &s = *state_;
    constexpr int kLinesACell = 2;
    std::vector<double> widths;
    double fontSize = kTableFont;
    for (; widths.empty(); fontSize -= 0.5)
        widths = shareWidth(columnNeeds(s, columns, rows, fontSize), fontSize > kSmallestTableFont);
    fontSize += 0.5;
    const std::string plain = fmt::format("DejaVu Sans {}", fontSize);
    const std::string bold = fmt::format("DejaVu Sans Bold {}", fontSize);
    const std::string headingFont = fmt::format("DejaVu Sans Bold {}", fontSize - 1);
    std::vector<double> lefts;
    double left = kMargin;
    for (const double width : widths)
    {
        lefts.push_back(left);
        left += width + kCellGap;
    }
    const auto lay = [&](std::size_t column, const std::string &text, const std::string &font, int lines)
    {
        return s.layout(
            breakable(oneLine(text),
                      static_cast<double>(characterCount(text)) * fontSize * 0.55 > widths[column]),
            {font, widths[column], columns[column].isRight ? PANGO_ALIGN_RIGHT : PANGO_ALIGN_LEFT, lines});
    };

    const auto drawHeading = [&]
    {
        LaidRow heading;
        for (std::size_t c = 0; c < columns.size(); ++c)
        {
            heading.cells.push_back(lay(c, columns[c].title, headingFont, 3));
            heading.height = std::max(heading.height, heightOf(heading.cells.back()));
        }
        s.line(s.y, 0.9, 0.1);
        s.y += 2;
        for (std::size_t c = 0; c < columns.size(); ++c)
            s.show(heading.cells[c], lefts[c], s.y + heading.height - heightOf(heading.cells[c]));
        s.y += heading.height + 2;
        s.line(s.y, 0.5, 0.1);
        s.y += 2;
    };

    constexpr double kHeadingAndRows = 60;
    s.need(kHeadingAndRows);
    drawHeading();
    const std::string *group = nullptr;
    for (const std::vector<PdfTableCell> &row : rows)
    {
        const bool continuesGroup = columns.size() > 2 && group != nullptr && *group == row.front().text;
        LaidRow laid;
        for (std::size_t c = 0; c < columns.size(); ++c)
        {
            const bool isBold = row[c].emphasis == PdfTableCell::Emphasis::best;
            laid.cells.push_back(
                lay(c, row[c].text, isBold ? bold : plain, columns[c].isRight ? 0 : kLinesACell));
            if (c > 0 || !continuesGroup)
                laid.height = std::max(laid.height, heightOf(laid.cells.back()));
        }
        const bool beginsPage = s.y + laid.height > kBottom;
        if (beginsPage)
        {
            s.line(s.y, 0.5, 0.1);
            s.newPage();
            drawHeading();
            laid.height = std::max(laid.height, heightOf(laid.cells.front()));
        }
        else if (group != nullptr && !continuesGroup)
        {
            s.line(s.y, 0.4, 0.75);
            s.y += 1.5;
        }
        group = &row.front().text;
        for (std::size_t c = 0; c < columns.size(); ++c)
        {
            if (c == 0 && continuesGroup && !beginsPage)
                continue;
            if (row[c].emphasis == PdfTableCell::Emphasis::warning)
                s.setColor(0.75, 0.05, 0.05);
            s.show(laid.cells[c], lefts[c], s.y);
            s.setBlack();
        }
        s.y += laid.height + 1.5;
    }
    s.line(s.y, 0.9, 0.1);
    s.y += 12;
}

void PdfPages::drawings(const std::vector<PdfDrawing> &row, std::size_t columns, double height)
{
    State &s = *state_;
    constexpr double kGutter = 16;
    constexpr double kAboveCaption = 5;
    const auto cells = static_cast<double>(columns);
    const double width = (kTextWidth - (cells - 1) * kGutter) / cells;

    struct Cell
    {
        double width = 0;
        double height = 0;
        TextLayout caption;
    };
    std::vector<Cell> laid;
    double tallestDrawing = 0;
    double tallestCaption = 0;
    for (const PdfDrawing &drawing : row)
    {
        ++s.drawings;
        Cell cell;
        const std::string words =
            fmt::format("Figure {}. {}", s.drawings, oneLine(drawing.caption)) +
            (drawing.missing.empty() ? "" : " [Not drawn: " + oneLine(drawing.missing) + "]");
        cell.caption = s.layout(words, {"DejaVu Sans 8", width, PANGO_ALIGN_LEFT, 14});
        tallestCaption = std::max(tallestCaption, heightOf(cell.caption));
        laid.push_back(std::move(cell));
    }
    const double room = std::min(height, kBottom - kMargin - tallestCaption - kAboveCaption);
    for (std::size_t i = 0; i < row.size(); ++i)
    {
        if (!row[i].missing.empty())
            continue;
        const auto [pageWidth, pageHeight] = pageSize(row[i].pdf);
        const double scale = std::min({1.0, width / pageWidth, room / pageHeight});
        laid[i].width = pageWidth * scale;
        laid[i].height = pageHeight * scale;
        tallestDrawing = std::max(tallestDrawing, laid[i].height);
    }
    s.need(tallestDrawing + kAboveCaption + tallestCaption);
    double left = kMargin;
    for (std::size_t i = 0; i < row.size(); ++i)
    {
        if (row[i].missing.empty())
        {
            s.sources.push_back(row[i].pdf);
            const double top = s.y + (tallestDrawing - laid[i].height) / 2;
            s.placements.push_back({s.page,
                                    {left + (width - laid[i].width) / 2, kPageHeight - top - laid[i].height,
                                     laid[i].width, laid[i].height},
                                    &s.sources.back()});
        }
        s.show(laid[i].caption, left, s.y + tallestDrawing + kAboveCaption);
        left += width + kGutter;
    }
    s.y += tallestDrawing + kAboveCaption + tallestCaption + 16;
}

std::string PdfPages::finish(const std::string &created)
{
    State &s = *state_;
    s.drawFooter();
    cairo_show_page(s.cairo());
    const cairo_status_t status = cairo_status(s.cairo());
    s.context.reset();
    cairo_surface_finish(s.surface.get());
    if (status != CAIRO_STATUS_SUCCESS || cairo_surface_status(s.surface.get()) != CAIRO_STATUS_SUCCESS)
        throw DrawingError(std::string("cairo failed: ") + cairo_status_to_string(status));
    return placeDrawings(s.bytes, s.placements, {s.title, created});
}

} // namespace mrpp

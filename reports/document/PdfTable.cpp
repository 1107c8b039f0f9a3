#include "reports/document/PdfSheet.h"

#include "reports/picture/Text.h"

#include <algorithm>
#include <fmt/format.h>
#include <numeric>

namespace mrpp
{

namespace
{

constexpr double kCellGap = 7; // points, as all of these
constexpr double kTableFont = 7.5;
constexpr double kSmallestTableFont = 5;

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

std::vector<ColumnNeed> columnNeeds(const PdfSheet &sheet, const std::vector<PdfTableColumn> &columns,
                                    const std::vector<std::vector<PdfTableCell>> &rows, double fontSize)
{
    constexpr double kLeastText = 60; // points, for text that wraps
    constexpr double kRoom = 0.5;     // against rounding
    const TextLayout ruler = layText(sheet.cairo(), "", {fmt::format("DejaVu Sans Bold {}", fontSize)});
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
    double rest = PdfSheet::kTextWidth - kCellGap * static_cast<double>(needs.size() - 1);
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

void drawTable(PdfSheet &s, const std::vector<PdfTableColumn> &columns,
               const std::vector<std::vector<PdfTableCell>> &rows)
{
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
    double left = PdfSheet::kMargin;
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
        const bool beginsPage = s.y + laid.height > PdfSheet::kBottom;
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
                s.setWarning();
            s.show(laid.cells[c], lefts[c], s.y);
            s.setBlack();
        }
        s.y += laid.height + 1.5;
    }
    s.line(s.y, 0.9, 0.1);
    s.y += 12;
}

} // namespace mrpp

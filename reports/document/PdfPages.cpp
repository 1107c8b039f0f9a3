#include "reports/document/PdfPages.h"

#include "reports/document/PdfSheet.h"
#include "reports/picture/Picture.h"
#include "reports/picture/Text.h"

#include <algorithm>
#include <fmt/format.h>
#include <functional>
#include <map>
#include <set>

namespace mrpp
{

namespace
{

constexpr double kMargin = PdfSheet::kMargin;
constexpr double kTextWidth = PdfSheet::kTextWidth;
constexpr double kGap = 7;

/// A heading as the table of contents lists it.
struct Heading
{
    std::string text;
    std::string anchor;
    bool isChapter = false;
};

/// The document while it is drawn. That happens twice: what leads to a later page needs to know its number.
struct Drawing
{
    PdfSheet sheet;
    const std::map<std::string, PdfPosition> &known; ///< where anchors were the first time
    std::map<std::string, PdfPosition> met;          ///< where they are this time
    int chapterOutline = CAIRO_PDF_OUTLINE_ROOT;
    std::vector<PdfPlacement> placements;

    void anchor(const std::string &name)
    {
        if (!name.empty())
            met.try_emplace(name, sheet.position());
    }

    [[nodiscard]] PdfPosition target(const std::string &name) const
    {
        const auto found = known.find(name);
        return found == known.end() ? PdfPosition() : found->second;
    }
};

} // namespace

struct PdfPages::State
{
    std::string title;
    std::string footer;
    std::vector<std::function<void(Drawing &)>> content;
    std::vector<Heading> headings;
    std::set<std::string> anchors;
    std::size_t drawings = 0;

    void add(std::function<void(Drawing &)> part) { content.push_back(std::move(part)); }

    /// The anchor of a heading that is new.
    std::string heading(const std::string &text, const std::string &anchor, bool isChapter)
    {
        std::string name = anchor.empty() ? fmt::format("heading {}", headings.size()) : anchor;
        anchors.insert(name);
        headings.push_back({text, name, isChapter});
        return name;
    }

    [[nodiscard]] Drawing draw(const std::map<std::string, PdfPosition> &known) const
    {
        Drawing drawing{PdfSheet(footer), known, {}, CAIRO_PDF_OUTLINE_ROOT, {}};
        for (const auto &part : content)
            part(drawing);
        return drawing;
    }
};

PdfPages::PdfPages(const std::string &title, const std::string &footer) : state_(std::make_unique<State>())
{
    state_->title = oneLine(title);
    state_->footer = oneLine(footer);
}

PdfPages::~PdfPages() = default;

void PdfPages::title(const std::string &text, const std::string &subtitle)
{
    state_->add(
        [text = oneLine(text), subtitle = oneLine(subtitle)](Drawing &drawing)
        {
            PdfSheet &sheet = drawing.sheet;
            sheet.outline(CAIRO_PDF_OUTLINE_ROOT, text);
            sheet.setGrey();
            sheet.text(subtitle, {"DejaVu Sans 11"}, 6);
            sheet.setBlack();
            sheet.text(text, {"DejaVu Sans Bold 26", kTextWidth, PANGO_ALIGN_LEFT, 4}, 10);
            sheet.line(sheet.y, 1.2, 0.1);
            sheet.y += 16;
        });
}

void PdfPages::contents()
{
    state_->add(
        [state = state_.get(), first = state_->headings.size()](Drawing &drawing)
        {
            constexpr double kNumber = 28;
            constexpr double kIndent = 10;
            constexpr double kAfter = 1.5;
            PdfSheet &sheet = drawing.sheet;
            for (std::size_t i = first; i < state->headings.size(); ++i)
            {
                const Heading &heading = state->headings[i];
                const double indent = heading.isChapter ? 0 : kIndent;
                const PdfPosition target = drawing.target(heading.anchor);
                const TextLayout text =
                    sheet.layout(heading.text, {heading.isChapter ? "DejaVu Sans Bold 8" : "DejaVu Sans 8",
                                                kTextWidth - indent - kNumber, PANGO_ALIGN_LEFT, 1});
                const TextLayout number = sheet.layout(std::to_string(target.page + 1),
                                                       {"DejaVu Sans 8", kNumber, PANGO_ALIGN_RIGHT});
                const double height = heightOf(text);
                sheet.need(height);
                sheet.show(text, kMargin + indent, sheet.y);
                sheet.show(number, kMargin + kTextWidth - kNumber, sheet.y);
                sheet.link(kMargin, sheet.y, {kTextWidth, height}, target);
                sheet.y += height + kAfter;
            }
            sheet.y += 8;
        });
}

void PdfPages::chapter(const std::string &text, double room)
{
    const std::string title = oneLine(text);
    state_->add(
        [title, room, anchor = state_->heading(title, "", true)](Drawing &drawing)
        {
            PdfSheet &sheet = drawing.sheet;
            sheet.need(room);
            sheet.y += sheet.y > kMargin ? 22 : 0;
            drawing.anchor(anchor);
            drawing.chapterOutline = sheet.outline(CAIRO_PDF_OUTLINE_ROOT, title);
            sheet.text(title, {"DejaVu Sans Bold 18", kTextWidth, PANGO_ALIGN_LEFT, 2}, 10);
        });
}

void PdfPages::section(const std::string &text, const std::string &anchor)
{
    const std::string title = oneLine(text);
    state_->add(
        [title, name = state_->heading(title, anchor, false)](Drawing &drawing)
        {
            constexpr double kWithWhatFollows = 90;
            PdfSheet &sheet = drawing.sheet;
            sheet.need(kWithWhatFollows);
            sheet.y += sheet.y > kMargin ? 8 : 0;
            drawing.anchor(name);
            sheet.outline(drawing.chapterOutline, title);
            sheet.text(title, {"DejaVu Sans Bold 11", kTextWidth, PANGO_ALIGN_LEFT, 2}, 5);
        });
}

void PdfPages::paragraph(const std::string &text)
{
    state_->add([text = manyLines(text)](Drawing &drawing)
                { drawing.sheet.text(text, {"DejaVu Sans 9"}, 8); });
}

void PdfPages::reference(const std::string &text, const std::string &anchor, double room)
{
    state_->add(
        [state = state_.get(), text = oneLine(text), anchor, room](Drawing &drawing)
        {
            if (!state->anchors.contains(anchor))
                return;
            PdfSheet &sheet = drawing.sheet;
            const PdfPosition target = drawing.target(anchor);
            const TextLayout made =
                sheet.layout(fmt::format("→ {}, page {}", text, target.page + 1), {"DejaVu Sans 8"});
            sheet.need(heightOf(made) + room);
            sheet.setLink();
            sheet.show(made, kMargin, sheet.y);
            sheet.setBlack();
            sheet.link(kMargin, sheet.y, sizeOf(made), target);
            sheet.y += heightOf(made) + 4;
        });
}

void PdfPages::facts(const std::vector<PdfFact> &facts)
{
    state_->add(
        [facts](Drawing &drawing)
        {
            constexpr double kNames = 105;
            PdfSheet &sheet = drawing.sheet;
            for (const PdfFact &fact : facts)
            {
                const TextLayout left = sheet.layout(oneLine(fact.name), {"DejaVu Sans 9", kNames - kGap});
                const TextLayout right = sheet.layout(
                    oneLine(fact.value), {"DejaVu Sans 9", kTextWidth - kNames, PANGO_ALIGN_LEFT, 6});
                const double height = std::max(heightOf(left), heightOf(right));
                sheet.need(height);
                sheet.setGrey();
                sheet.show(left, kMargin, sheet.y);
                sheet.setBlack();
                if (!fact.file.empty())
                {
                    sheet.setLink();
                    sheet.link(kMargin + kNames, sheet.y, {kTextWidth - kNames, height}, fact.file);
                }
                sheet.show(right, kMargin + kNames, sheet.y);
                sheet.setBlack();
                sheet.y += height + 2.5;
            }
            sheet.y += 10;
        });
}

void PdfPages::verbatim(const std::string &text)
{
    state_->add(
        [text = manyLines(text)](Drawing &drawing)
        {
            for (std::size_t begin = 0; begin < text.size();)
            {
                const std::size_t end = std::min(text.find('\n', begin), text.size());
                const std::string line = text.substr(begin, end - begin);
                constexpr double kCharacter = 7 * 0.602; // width of this font
                constexpr std::size_t kDeepest = 40;
                const std::size_t blanks = std::min({line.find_first_not_of(' '), line.size(), kDeepest});
                drawing.sheet.text(line.empty() ? " " : line,
                                   {"DejaVu Sans Mono 7", kTextWidth, PANGO_ALIGN_LEFT, 0,
                                    static_cast<double>(blanks + 4) * kCharacter},
                                   0.5);
                begin = end + 1;
            }
            drawing.sheet.y += 8;
        });
}

void PdfPages::table(const std::vector<PdfTableColumn> &columns,
                     const std::vector<std::vector<PdfTableCell>> &rows)
{
    state_->add([columns, rows](Drawing &drawing) { drawTable(drawing.sheet, columns, rows); });
}

namespace
{

/// Drawings side by side, and where they come in the document.
struct DrawingRow
{
    std::vector<PdfDrawing> drawings;
    std::size_t columns = 1;
    double height = 0;
    std::size_t number = 0; ///< of the first
};

void place(const DrawingRow &row, Drawing &drawing)
{
    PdfSheet &sheet = drawing.sheet;
    constexpr double kGutter = 16;
    constexpr double kAboveCaption = 5;
    const auto cells = static_cast<double>(row.columns);
    const double width = (kTextWidth - (cells - 1) * kGutter) / cells;

    struct Cell
    {
        TextSize size; ///< of the drawing
        TextLayout caption;
        TextLayout file;
    };
    std::vector<Cell> laid;
    double tallestDrawing = 0;
    double tallestText = 0;
    for (std::size_t i = 0; i < row.drawings.size(); ++i)
    {
        const PdfDrawing &one = row.drawings[i];
        const std::string words = fmt::format("Figure {}. {}", row.number + i, oneLine(one.caption)) +
                                  (one.missing.empty() ? "" : " [Not drawn: " + oneLine(one.missing) + "]");
        laid.push_back({{},
                        sheet.layout(words, {"DejaVu Sans 8", width, PANGO_ALIGN_LEFT, 14}),
                        sheet.layout(one.file, {"DejaVu Sans 7", width, PANGO_ALIGN_LEFT, 1})});
        tallestText = std::max(tallestText, heightOf(laid.back().caption) +
                                                (one.file.empty() ? 0 : heightOf(laid.back().file)));
    }
    const double room = std::min(row.height, PdfSheet::kBottom - kMargin - tallestText - kAboveCaption);
    for (std::size_t i = 0; i < row.drawings.size(); ++i)
    {
        if (!row.drawings[i].missing.empty())
            continue;
        const auto [pageWidth, pageHeight] = pageSize(row.drawings[i].pdf);
        const double scale = std::min({1.0, width / pageWidth, room / pageHeight});
        laid[i].size = {pageWidth * scale, pageHeight * scale};
        tallestDrawing = std::max(tallestDrawing, laid[i].size.height);
    }
    sheet.need(tallestDrawing + kAboveCaption + tallestText);
    double left = kMargin;
    for (std::size_t i = 0; i < row.drawings.size(); ++i)
    {
        const PdfDrawing &one = row.drawings[i];
        const Cell &cell = laid[i];
        drawing.anchor(one.anchor);
        sheet.outline(
            drawing.chapterOutline,
            fmt::format("{}. {}", row.number + i, oneLine(one.caption.substr(0, one.caption.find(": ")))));
        if (one.missing.empty())
        {
            const double top = sheet.y + (tallestDrawing - cell.size.height) / 2;
            drawing.placements.push_back(
                {sheet.position().page,
                 {left + (width - cell.size.width) / 2, PdfSheet::kPageHeight - top - cell.size.height,
                  cell.size.width, cell.size.height},
                 &one.pdf});
        }
        const double below = sheet.y + tallestDrawing + kAboveCaption;
        sheet.show(cell.caption, left, below);
        if (!one.file.empty() && one.missing.empty())
        {
            const double top = below + heightOf(cell.caption);
            sheet.setLink();
            sheet.show(cell.file, left, top);
            sheet.setBlack();
            sheet.link(left, top, sizeOf(cell.file), one.file);
        }
        left += width + kGutter;
    }
    sheet.y += tallestDrawing + kAboveCaption + tallestText + 16;
}

} // namespace

void PdfPages::drawings(std::vector<PdfDrawing> row, std::size_t columns, double height)
{
    for (const PdfDrawing &drawing : row)
        if (!drawing.anchor.empty())
            state_->anchors.insert(drawing.anchor);
    const std::size_t number = state_->drawings + 1;
    state_->drawings += row.size();
    state_->add([placed = DrawingRow{std::move(row), columns, height, number}](Drawing &drawing)
                { place(placed, drawing); });
}

std::string PdfPages::finish(const std::string &created)
{
    const std::map<std::string, PdfPosition> places = state_->draw({}).met;
    Drawing drawing = state_->draw(places);
    return placeDrawings(drawing.sheet.finish(), drawing.placements, {state_->title, created});
}

} // namespace mrpp

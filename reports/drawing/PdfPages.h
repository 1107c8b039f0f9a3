#pragma once
/// \file
/// A4 pages that fill from top to bottom: headings, text, tables that go on over pages, drawings with
/// captions, page numbers and an outline. Text is never markup: whatever a user named something, it is shown
/// as it is. Long text wraps or ends in "…", nothing runs over the margins.

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace mrpp
{

struct PdfTableColumn
{
    std::string title;
    bool isRight = false; ///< numbers: never cut or broken; other cells wrap
};

struct PdfTableCell
{
    enum class Emphasis
    {
        none,
        best,    ///< bold
        warning, ///< red
    };
    std::string text;
    Emphasis emphasis = Emphasis::none;
};

/// A drawing to be placed: a one-page PDF, or words where it could not be drawn.
struct PdfDrawing
{
    std::string pdf;
    std::string missing; ///< why there is no drawing; empty where there is one
    std::string caption;
};

class PdfPages
{
public:
    /// \param footer on every page beside its number
    PdfPages(const std::string &title, const std::string &footer);
    ~PdfPages();
    PdfPages(const PdfPages &) = delete;
    PdfPages &operator=(const PdfPages &) = delete;

    void title(const std::string &text, const std::string &subtitle);
    /// A chapter begins a new page and is in the outline; a section is in the outline beneath it.
    void chapter(const std::string &text);
    void section(const std::string &text);
    void paragraph(const std::string &text);
    /// Names and values in two columns.
    void facts(const std::vector<std::pair<std::string, std::string>> &pairs);
    /// Verbatim, in a font of fixed width; more than 110 characters wrap at a blank, indented.
    void verbatim(const std::string &text);
    /// Columns are as wide as their contents want; where that is too much, text wraps and numbers keep their
    /// room, if need be in a smaller font. The heading is repeated on every page. A row whose first cell
    /// begins with a text other than the row's before it gets a line above.
    void table(const std::vector<PdfTableColumn> &columns,
               const std::vector<std::vector<PdfTableCell>> &rows);
    /// Side by side in so many columns (\pre at least row.size()), at most `height` points high, with
    /// numbered captions.
    void drawings(const std::vector<PdfDrawing> &row, std::size_t columns, double height);

    /// The document with every drawing in place. The same calls give the same bytes.
    /// \param created "2026-07-31T12:00:00Z", or empty for no date
    [[nodiscard]] std::string finish(const std::string &created);

    struct State; ///< of the implementation alone

private:
    std::unique_ptr<State> state_;
};

} // namespace mrpp

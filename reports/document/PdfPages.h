#pragma once
/// \file
/// A4 pages that fill from top to bottom: headings, text, tables that go on over pages, drawings with
/// captions, page numbers, an outline and links. Text is never markup: whatever a user named something, it is
/// shown as it is. Long text wraps or ends in "…", nothing runs over the margins.
///
/// Links lead to files beside the document, or to anchors: names that sections and drawings may have.

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
    std::string caption; ///< up to its first ": " also in the outline
    std::string file;    ///< beside the document, with more about it; may be empty
    std::string anchor;  ///< may be empty, as all anchors
};

struct PdfFact
{
    std::string name;
    std::string value;
    std::string file = {}; ///< that it leads to; may be empty
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
    /// The chapters and sections that follow with their pages, each a link.
    void contents();
    /// Chapters are in the outline, sections and drawings beneath theirs.
    /// \param room points that must be left on the page for it, else it begins a new one
    void chapter(const std::string &text, double room = 200);
    void section(const std::string &text, const std::string &anchor = {});
    void paragraph(const std::string &text);
    /// "→ text, page 7", a link; nothing where the document has no such anchor.
    /// \param room points that what follows needs on the same page
    void reference(const std::string &text, const std::string &anchor, double room = 0);
    /// Names and values in two columns.
    void facts(const std::vector<PdfFact> &facts);
    /// Verbatim, in a font of fixed width; more than 110 characters wrap at a blank, indented.
    void verbatim(const std::string &text);
    /// Columns are as wide as their contents want; where that is too much, text wraps and numbers keep their
    /// room, if need be in a smaller font. The heading is repeated on every page. A row whose first cell
    /// begins with a text other than the row's before it gets a line above.
    void table(const std::vector<PdfTableColumn> &columns,
               const std::vector<std::vector<PdfTableCell>> &rows);
    /// Side by side in so many columns (\pre at least row.size()), at most `height` points high, with
    /// numbered captions.
    void drawings(std::vector<PdfDrawing> row, std::size_t columns, double height);

    /// The document with every drawing in place. The same calls give the same bytes.
    /// \param created "2026-07-31T12:00:00Z", or empty for no date
    [[nodiscard]] std::string finish(const std::string &created);

private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace mrpp

#pragma once
/// \file
/// The A4 pages of a document while they are drawn from top to bottom. Places are points of 1/72 inch from
/// the top left of their page.

#include "reports/document/PdfPages.h"
#include "reports/picture/CairoCanvas.h"
#include "reports/picture/PdfFile.h"

#include <cairo-pdf.h>
#include <cstddef>
#include <string>
#include <vector>

namespace mrpp
{

/// Where something stands.
struct PdfPosition
{
    std::size_t page = 0; ///< from 0
    double y = 0;
};

class PdfSheet
{
public:
    static constexpr double kPageWidth = 595.276;
    static constexpr double kPageHeight = 841.89;
    static constexpr double kMargin = 56;
    static constexpr double kTextWidth = kPageWidth - 2 * kMargin;
    static constexpr double kBottom = kPageHeight - kMargin - 12;

    double y = kMargin; ///< where the next thing goes

    /// \param footer on every page beside its number
    explicit PdfSheet(std::string footer);

    [[nodiscard]] cairo_t *cairo() const { return context_.get(); }
    [[nodiscard]] PdfPosition position() const { return {page_, y}; }

    /// As wide as the page unless the style says otherwise.
    [[nodiscard]] TextLayout layout(const std::string &text, TextStyle style) const;
    void show(const TextLayout &text, double x, double top) const { showText(cairo(), text, x, top); }
    /// Lays text out, shows it and leaves some room behind it.
    void text(const std::string &words, const TextStyle &style, double after);

    void setBlack() const { setColor(0.1, 0.1, 0.1); }
    void setGrey() const { setColor(0.42, 0.42, 0.42); }
    void setWarning() const { setColor(0.75, 0.05, 0.05); }
    void setLink() const { setColor(0.05, 0.25, 0.55); }
    void line(double top, double width, double grey) const;

    void newPage();
    /// A new page unless so many points are left on this one.
    void need(double height);

    /// An entry of the outline that leads here; returns what its children need as `parent`.
    int outline(int parent, const std::string &text) const;

    /// Makes an area of this page lead elsewhere: to a place of the document, or to a file beside it.
    void link(double x, double top, const TextSize &size, const PdfPosition &target) const;
    void link(double x, double top, const TextSize &size, const std::string &file) const;

    /// The document, whose pages end here.
    [[nodiscard]] std::string finish();

private:
    std::string bytes_;
    std::string footer_;
    CairoSurface surface_;
    CairoContext context_;
    std::size_t page_ = 0; ///< from 0

    void setColor(double red, double green, double blue) const;
    void drawFooter() const;
    void addLink(double x, double top, const TextSize &size, const std::string &target) const;
};

[[nodiscard]] inline double heightOf(const TextLayout &text)
{
    return sizeOf(text).height;
}

/// A table from here on (see PdfPages::table).
void drawTable(PdfSheet &sheet, const std::vector<PdfTableColumn> &columns,
               const std::vector<std::vector<PdfTableCell>> &rows);

} // namespace mrpp

#include "reports/document/PdfSheet.h"

#include <fmt/format.h>
#include <utility>

namespace mrpp
{

PdfSheet::PdfSheet(std::string footer)
    : footer_(std::move(footer)),
      surface_(cairo_pdf_surface_create_for_stream(appendToString, &bytes_, kPageWidth, kPageHeight)),
      context_(cairo_create(surface_.get()))
{
    setBlack();
}

TextLayout PdfSheet::layout(const std::string &text, TextStyle style) const
{
    if (style.width < 0)
        style.width = kTextWidth;
    return layText(cairo(), text, style);
}

void PdfSheet::text(const std::string &words, const TextStyle &style, double after)
{
    const TextLayout made = layout(words, style);
    const double height = heightOf(made);
    need(height);
    show(made, kMargin, y);
    y += height + after;
}

void PdfSheet::setColor(double red, double green, double blue) const
{
    cairo_set_source_rgb(cairo(), red, green, blue);
}

void PdfSheet::line(double top, double width, double grey) const
{
    setColor(grey, grey, grey);
    cairo_set_line_width(cairo(), width);
    cairo_move_to(cairo(), kMargin, top);
    cairo_line_to(cairo(), kMargin + kTextWidth, top);
    cairo_stroke(cairo());
    setBlack();
}

void PdfSheet::drawFooter() const
{
    setGrey();
    const double top = kPageHeight - kMargin + 8;
    show(layout(footer_, {"DejaVu Sans 7.5", kTextWidth * 0.8, PANGO_ALIGN_LEFT, 1}), kMargin, top);
    show(layout(std::to_string(page_ + 1), {"DejaVu Sans 7.5", kTextWidth * 0.15, PANGO_ALIGN_RIGHT}),
         kMargin + kTextWidth * 0.85, top);
    setBlack();
}

void PdfSheet::newPage()
{
    drawFooter();
    cairo_show_page(cairo());
    ++page_;
    y = kMargin;
}

void PdfSheet::need(double height)
{
    if (y + height > kBottom && y > kMargin)
        newPage();
}

int PdfSheet::outline(int parent, const std::string &text) const
{
    const std::string target = fmt::format("page={} pos=[{:.1f} {:.1f}]", page_ + 1, kMargin, y);
    return cairo_pdf_surface_add_outline(surface_.get(), parent, text.c_str(), target.c_str(),
                                         static_cast<cairo_pdf_outline_flags_t>(0));
}

void PdfSheet::link(double x, double top, const TextSize &size, const PdfPosition &target) const
{
    addLink(x, top, size, fmt::format("page={} pos=[{:.1f} {:.1f}]", target.page + 1, kMargin, target.y));
}

void PdfSheet::link(double x, double top, const TextSize &size, const std::string &file) const
{
    std::string escaped;
    for (const char c : file)
        escaped += (c == '\'' || c == '\\' ? "\\" : "") + std::string(1, c);
    addLink(x, top, size, "uri='" + escaped + "'");
}

void PdfSheet::addLink(double x, double top, const TextSize &size, const std::string &target) const
{
    const std::string attributes =
        fmt::format("rect=[{:.2f} {:.2f} {:.2f} {:.2f}] {}", x, top, size.width, size.height, target);
    cairo_tag_begin(cairo(), CAIRO_TAG_LINK, attributes.c_str());
    cairo_tag_end(cairo(), CAIRO_TAG_LINK);
}

std::string PdfSheet::finish()
{
    drawFooter();
    cairo_show_page(cairo());
    const cairo_status_t status = cairo_status(cairo());
    context_.reset();
    cairo_surface_finish(surface_.get());
    if (status != CAIRO_STATUS_SUCCESS || cairo_surface_status(surface_.get()) != CAIRO_STATUS_SUCCESS)
        throw DrawingError(std::string("cairo failed: ") + cairo_status_to_string(status));
    return std::move(bytes_);
}

} // namespace mrpp

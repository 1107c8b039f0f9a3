#include "reports/picture/CairoCanvas.h"

#include "reports/picture/PdfFile.h"

#include <algorithm>
#include <cairo-pdf.h>
#include <cairo-svg.h>
#include <string_view>

namespace mrpp
{

namespace
{

/// Cairo numbers its surfaces over the whole process; the same picture shall have the same bytes.
std::string withoutSurfaceNumbers(const std::string &svg)
{
    constexpr std::string_view kMark = "surface";
    std::string result;
    for (std::size_t i = 0; i < svg.size();)
    {
        result += svg[i];
        ++i;
        if (std::string_view(result).ends_with(kMark))
            while (i < svg.size() && svg[i] >= '0' && svg[i] <= '9')
                ++i;
    }
    return result;
}

/// Cairo gives places six decimals, of which a picture needs two.
std::string withShortPaths(const std::string &svg)
{
    constexpr std::string_view kPath = " d=\"";
    constexpr std::size_t kDecimals = 2;
    std::string result;
    result.reserve(svg.size());
    for (std::size_t at = 0; at < svg.size();)
    {
        const std::size_t path = std::min(svg.find(kPath, at), svg.size());
        const std::size_t begin = std::min(path + kPath.size(), svg.size());
        const std::size_t end = std::min(svg.find('"', begin), svg.size());
        result.append(svg, at, begin - at);
        std::size_t decimals = 0; // of the number so far, with its point
        for (const char c : std::string_view(svg).substr(begin, end - begin))
        {
            const bool isDigit = c >= '0' && c <= '9';
            decimals = c == '.' || (isDigit && decimals > 0) ? decimals + 1 : 0;
            if (decimals <= 1 + kDecimals)
                result += c;
        }
        at = end;
    }
    return result;
}

} // namespace

cairo_status_t appendToString(void *closure, const unsigned char *data, unsigned int length)
{
    static_cast<std::string *>(closure)->append(reinterpret_cast<const char *>(data), length);
    return CAIRO_STATUS_SUCCESS;
}

Picture drawPicture(double width, double height, const std::function<void(cairo_t *)> &draw)
{
    constexpr double kPixelsAPoint = 3;
    const auto drawOn = [&](cairo_surface_t *surface, double unitsAPoint)
    {
        const CairoContext context(cairo_create(surface));
        cairo_t *cairo = context.get();
        cairo_scale(cairo, unitsAPoint, unitsAPoint);
        cairo_set_source_rgb(cairo, 1, 1, 1);
        cairo_paint(cairo);
        draw(cairo);
        if (cairo_status(cairo) != CAIRO_STATUS_SUCCESS)
            throw DrawingError(std::string("cairo failed: ") + cairo_status_to_string(cairo_status(cairo)));
    };
    Picture picture;
    const CairoSurface image(cairo_image_surface_create(CAIRO_FORMAT_RGB24,
                                                        static_cast<int>(width * kPixelsAPoint),
                                                        static_cast<int>(height * kPixelsAPoint)));
    drawOn(image.get(), kPixelsAPoint);
    cairo_surface_write_to_png_stream(image.get(), appendToString, &picture.png);

    const CairoSurface pdf(cairo_pdf_surface_create_for_stream(appendToString, &picture.pdf, width, height));
    drawOn(pdf.get(), 1);
    cairo_surface_finish(pdf.get());

    const CairoSurface svg(cairo_svg_surface_create_for_stream(appendToString, &picture.svg, width, height));
    drawOn(svg.get(), 1);
    cairo_surface_finish(svg.get());

    verify(picture);
    picture.pdf = withoutTimes(picture.pdf);
    picture.svg = withShortPaths(withoutSurfaceNumbers(picture.svg));
    return picture;
}

TextLayout layText(cairo_t *cairo, const std::string &text, const TextStyle &style)
{
    TextLayout made(pango_cairo_create_layout(cairo));
    constexpr double kPointsAnInch = 72; // one unit of the page is a point
    pango_cairo_context_set_resolution(pango_layout_get_context(made.get()), kPointsAnInch);
    pango_context_set_round_glyph_positions(pango_layout_get_context(made.get()), FALSE);
    cairo_font_options_t *unhinted = cairo_font_options_create(); // letters stand as the font says
    cairo_font_options_set_hint_style(unhinted, CAIRO_HINT_STYLE_NONE);
    cairo_font_options_set_hint_metrics(unhinted, CAIRO_HINT_METRICS_OFF);
    pango_cairo_context_set_font_options(pango_layout_get_context(made.get()), unhinted);
    cairo_font_options_destroy(unhinted);
    pango_layout_context_changed(made.get());
    PangoAttrList *attributes = pango_attr_list_new(); // names are not hyphenated
    pango_attr_list_insert(attributes, pango_attr_insert_hyphens_new(FALSE));
    pango_layout_set_attributes(made.get(), attributes);
    pango_attr_list_unref(attributes);
    PangoFontDescription *font = pango_font_description_from_string(style.font.c_str());
    pango_layout_set_font_description(made.get(), font);
    pango_font_description_free(font);
    pango_layout_set_width(made.get(), style.width < 0 ? -1 : static_cast<int>(style.width * PANGO_SCALE));
    pango_layout_set_wrap(made.get(), PANGO_WRAP_WORD_CHAR);
    pango_layout_set_indent(made.get(), -static_cast<int>(style.hang * PANGO_SCALE));
    pango_layout_set_alignment(made.get(), style.alignment);
    if (style.lines > 0)
    {
        pango_layout_set_height(made.get(), -style.lines);
        pango_layout_set_ellipsize(made.get(), PANGO_ELLIPSIZE_END);
    }
    pango_layout_set_text(made.get(), text.data(), static_cast<int>(text.size()));
    return made;
}

TextSize sizeOf(const TextLayout &text)
{
    PangoRectangle size;
    pango_layout_get_extents(text.get(), nullptr, &size);
    return {static_cast<double>(size.width) / PANGO_SCALE, static_cast<double>(size.height) / PANGO_SCALE};
}

void showText(cairo_t *cairo, const TextLayout &text, double left, double top)
{
    cairo_move_to(cairo, left, top);
    pango_cairo_show_layout(cairo, text.get());
}

} // namespace mrpp

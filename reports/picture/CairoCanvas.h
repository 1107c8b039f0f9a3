#pragma once
/// \file
/// Cairo surfaces that draw into memory, and text on them. Text is never markup, and any script that some
/// installed font has is shown.

#include "reports/picture/Picture.h"

#include <cairo.h>
#include <functional>
#include <memory>
#include <pango/pangocairo.h>
#include <string>

namespace mrpp
{

struct CairoDeleter
{
    void operator()(cairo_t *context) const { cairo_destroy(context); }
    void operator()(cairo_surface_t *surface) const { cairo_surface_destroy(surface); }
    void operator()(PangoLayout *layout) const { g_object_unref(layout); }
};
using CairoContext = std::unique_ptr<cairo_t, CairoDeleter>;
using CairoSurface = std::unique_ptr<cairo_surface_t, CairoDeleter>;
using TextLayout = std::unique_ptr<PangoLayout, CairoDeleter>;

/// A cairo_write_func_t whose closure is a std::string.
cairo_status_t appendToString(void *closure, const unsigned char *data, unsigned int length);

/// The same drawing as PDF, SVG and PNG (three pixels a point) on white. The same drawing gives the same
/// bytes. \param width, height in points. Throws DrawingError where cairo fails.
[[nodiscard]] Picture drawPicture(double width, double height, const std::function<void(cairo_t *)> &draw);

struct TextStyle
{
    std::string font = "DejaVu Sans 9"; ///< family and size in points
    double width = -1;                  ///< points, where lines wrap; negative: they do not
    PangoAlignment alignment = PANGO_ALIGN_LEFT;
    int lines = 0;   ///< at most so many, the last ending in "…"; 0: any number
    double hang = 0; ///< points, indentation of all lines but the first
};

/// Text laid out, \pre valid UTF-8.
[[nodiscard]] TextLayout layText(cairo_t *cairo, const std::string &text, const TextStyle &style);

struct TextSize
{
    double width = 0; ///< points
    double height = 0;
};
[[nodiscard]] TextSize sizeOf(const TextLayout &text);

/// Shows it with its top left corner there.
void showText(cairo_t *cairo, const TextLayout &text, double left, double top);

} // namespace mrpp

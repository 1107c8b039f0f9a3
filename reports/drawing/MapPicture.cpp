#include "reports/drawing/CairoCanvas.h"
#include "reports/drawing/LayoutPicture.h"
#include "reports/drawing/Palette.h"
#include "reports/drawing/PdfFile.h"
#include "reports/drawing/Text.h"

#include <algorithm>
#include <cairo-pdf.h>
#include <cairo-svg.h>
#include <cmath>
#include <numbers>
#include <numeric>

namespace mrpp
{

namespace
{

constexpr double kLongSide = 600; // points
constexpr double kMargin = 10;
constexpr double kTitle = 44;
constexpr std::size_t kStrokeAtOnce = 2000; // longer paths cost memory, shorter ones size

class MapDrawing
{
public:
    MapDrawing(const Instance &instance, const Solution *solution, const Placement &placement,
               const std::string &title)
        : instance_(instance), solution_(solution), placement_(placement), title_(title)
    {
        double width = 0;
        double height = 0;
        for (const Point &position : placement.positions)
        {
            width = std::max(width, position.x);
            height = std::max(height, position.y);
        }
        width += placement.spacing;
        height += placement.spacing;
        scale_ = kLongSide / std::max(width, height);
        unit_ = placement.spacing * scale_;
        width_ = std::max(width * scale_, 300.0) + 2 * kMargin;
        bottom_ = height * scale_ + kMargin;
        height_ = bottom_ + kTitle + kMargin;
    }

    [[nodiscard]] Picture draw() const
    {
        Picture picture;
        constexpr double kPixelsAPoint = 3;
        const CairoSurface image(cairo_image_surface_create(CAIRO_FORMAT_RGB24,
                                                            static_cast<int>(width_ * kPixelsAPoint),
                                                            static_cast<int>(height_ * kPixelsAPoint)));
        drawOn(image.get(), kPixelsAPoint);
        cairo_surface_write_to_png_stream(image.get(), appendToString, &picture.png);

        const CairoSurface pdf(
            cairo_pdf_surface_create_for_stream(appendToString, &picture.pdf, width_, height_));
        drawOn(pdf.get(), 1);
        cairo_surface_finish(pdf.get());

        const CairoSurface svg(
            cairo_svg_surface_create_for_stream(appendToString, &picture.svg, width_, height_));
        drawOn(svg.get(), 1);
        cairo_surface_finish(svg.get());

        verify(picture);
        picture.pdf = withoutTimes(picture.pdf);
        picture.svg = withoutSurfaceNumbers(picture.svg);
        return picture;
    }

private:
    const Instance &instance_;
    const Solution *solution_;
    const Placement &placement_;
    const std::string &title_;
    double scale_ = 1;  ///< from the placement to paper
    double unit_ = 1;   ///< points between neighbours
    double width_ = 0;  ///< points
    double height_ = 0; ///< points
    double bottom_ = 0; ///< of the map

    [[nodiscard]] double x(Vertex v) const
    {
        return kMargin + unit_ / 2 + placement_.positions[v].x * scale_;
    }
    [[nodiscard]] double y(Vertex v) const
    {
        return bottom_ - unit_ / 2 - placement_.positions[v].y * scale_;
    }

    /// Cairo numbers its surfaces over the whole process; the same picture shall have the same bytes.
    static std::string withoutSurfaceNumbers(const std::string &svg)
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

    void drawOn(cairo_surface_t *surface, double pixelsAPoint) const
    {
        const CairoContext context(cairo_create(surface));
        cairo_t *cairo = context.get();
        cairo_scale(cairo, pixelsAPoint, pixelsAPoint);
        cairo_set_source_rgb(cairo, 1, 1, 1);
        cairo_paint(cairo);
        if (isGrid())
            drawCells(cairo);
        else
            drawEdges(cairo);
        drawRoutes(cairo);
        drawRobots(cairo);
        drawTitle(cairo);
        if (cairo_status(cairo) != CAIRO_STATUS_SUCCESS)
            throw DrawingError(std::string("cairo failed: ") + cairo_status_to_string(cairo_status(cairo)));
    }

    /// Whether every edge goes along an axis and is as long as all others.
    [[nodiscard]] bool isGrid() const
    {
        constexpr double kTolerance = 1e-6;
        const double unit = placement_.spacing;
        for (const Graph::Edge &edge : instance_.graph->edges())
        {
            const double dx = std::abs(placement_.positions[edge.a].x - placement_.positions[edge.b].x);
            const double dy = std::abs(placement_.positions[edge.a].y - placement_.positions[edge.b].y);
            if (std::min(dx, dy) > kTolerance * unit || std::abs(std::max(dx, dy) - unit) > kTolerance * unit)
                return false;
        }
        return true;
    }

    /// Free cells as squares on a dark ground; cells side by side become one rectangle.
    void drawCells(cairo_t *cairo) const
    {
        cairo_set_source_rgb(cairo, 0.42, 0.42, 0.42);
        cairo_rectangle(cairo, kMargin, kMargin, width_ - 2 * kMargin, bottom_ - kMargin);
        cairo_fill(cairo);
        cairo_set_source_rgb(cairo, 0.95, 0.95, 0.95);
        std::vector<Vertex> order(instance_.graph->vertexCount());
        std::iota(order.begin(), order.end(), Vertex{0});
        const auto &places = placement_.positions;
        std::sort(order.begin(), order.end(),
                  [&](Vertex a, Vertex b)
                  { return std::pair(places[a].y, places[a].x) < std::pair(places[b].y, places[b].x); });
        std::size_t rectangles = 0;
        for (std::size_t first = 0; first < order.size();)
        {
            std::size_t last = first;
            while (last + 1 < order.size() && instance_.graph->hasEdge(order[last], order[last + 1]))
                ++last;
            cairo_rectangle(cairo, x(order[first]) - unit_ / 2, y(order[first]) - unit_ / 2,
                            x(order[last]) - x(order[first]) + unit_, unit_);
            if (++rectangles % kStrokeAtOnce == 0)
                cairo_fill(cairo);
            first = last + 1;
        }
        cairo_fill(cairo);
    }

    void drawEdges(cairo_t *cairo) const
    {
        cairo_set_source_rgb(cairo, 0.7, 0.7, 0.7);
        cairo_set_line_width(cairo, std::min(0.8, unit_ / 6));
        std::size_t lines = 0;
        for (const Graph::Edge &edge : instance_.graph->edges())
        {
            cairo_move_to(cairo, x(edge.a), y(edge.a));
            cairo_line_to(cairo, x(edge.b), y(edge.b));
            if (++lines % kStrokeAtOnce == 0)
                cairo_stroke(cairo);
        }
        cairo_stroke(cairo);
    }

    static void setColor(cairo_t *cairo, Robot robot)
    {
        const auto [red, green, blue] = rgb(robotColor(robot));
        cairo_set_source_rgb(cairo, red, green, blue);
    }

    [[nodiscard]] bool showsRoutes() const
    {
        constexpr std::size_t kRobotsWithRoutes = 60; // more are a tangle
        return solution_ != nullptr && instance_.robotCount() <= kRobotsWithRoutes;
    }

    void drawRoutes(cairo_t *cairo) const
    {
        if (!showsRoutes())
            return;
        const std::vector<Graph::Edge> edges = instance_.graph->edges();
        const auto users = edgeUsers(*instance_.graph, *solution_, 1);
        cairo_set_line_width(cairo, std::clamp(unit_ / 3, 0.5, 2.0));
        cairo_set_line_cap(cairo, CAIRO_LINE_CAP_ROUND);
        std::vector<std::vector<std::size_t>> routes(instance_.robotCount());
        for (std::size_t i = 0; i < users.size(); ++i)
            for (const Robot robot : users[i])
                routes[robot].push_back(i);
        for (Robot robot = 0; robot < routes.size(); ++robot)
        {
            setColor(cairo, robot);
            for (const std::size_t edge : routes[robot])
            {
                cairo_move_to(cairo, x(edges[edge].a), y(edges[edge].a));
                cairo_line_to(cairo, x(edges[edge].b), y(edges[edge].b));
            }
            cairo_stroke(cairo);
        }
    }

    void drawRobots(cairo_t *cairo) const
    {
        const double radius = std::max(unit_ * 0.45, instance_.robotCount() > 200 ? 1.1 : 2.0);
        cairo_set_line_width(cairo, std::max(0.6, radius / 3));
        for (Robot robot = 0; robot < instance_.robotCount(); ++robot)
        {
            setColor(cairo, robot);
            const Vertex goal = instance_.goals[robot];
            cairo_rectangle(cairo, x(goal) - radius, y(goal) - radius, 2 * radius, 2 * radius);
            cairo_stroke(cairo);
        }
        for (Robot robot = 0; robot < instance_.robotCount(); ++robot)
        {
            setColor(cairo, robot);
            cairo_arc(cairo, x(instance_.starts[robot]), y(instance_.starts[robot]), radius, 0,
                      2 * std::numbers::pi);
            cairo_fill(cairo);
        }
    }

    void drawTitle(cairo_t *cairo) const
    {
        constexpr double kFont = 11;
        constexpr double kLine = 14;
        cairo_set_source_rgb(cairo, 0.13, 0.13, 0.13);
        cairo_select_font_face(cairo, "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
        cairo_set_font_size(cairo, kFont);
        double base = bottom_ + kLine + 2;
        std::string text = manyLines(title_) + "\n";
        for (std::size_t end = text.find('\n'); end != std::string::npos; end = text.find('\n'))
        {
            cairo_text_extents_t size;
            cairo_text_extents(cairo, text.substr(0, end).c_str(), &size);
            cairo_move_to(cairo, std::max(kMargin, (width_ - size.width) / 2), base);
            cairo_show_text(cairo, text.substr(0, end).c_str());
            text.erase(0, end + 1);
            base += kLine;
        }
    }
};

} // namespace

Picture drawMap(const Instance &instance, const Solution *solution, const Placement &placement,
                const std::string &title)
{
    return MapDrawing(instance, solution, placement, title).draw();
}

} // namespace mrpp

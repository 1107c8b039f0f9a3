#include "framework/geometry/Outline.h"
#include "reports/drawing/CairoCanvas.h"
#include "reports/drawing/LayoutPicture.h"
#include "reports/drawing/Palette.h"
#include "reports/drawing/PdfFile.h"
#include "reports/drawing/Text.h"

#include <algorithm>
#include <array>
#include <cairo-pdf.h>
#include <cairo-svg.h>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace mrpp
{

namespace
{

constexpr double kLongSide = 600; // points
constexpr double kMargin = 10;
constexpr double kTitle = 52;
constexpr std::size_t kStrokeAtOnce = 2000; // longer paths cost memory, shorter ones size

constexpr std::size_t kRobotsWithBoldRoutes = 60; // more are a tangle: then heat shows where they went
constexpr std::size_t kCornersDrawn = 200'000;    // of routes: beyond that the files outgrow their use

/// Light to dark, so that they keep their order in greyscale: the sequential scheme OrRd of C. Brewer.
constexpr std::array<const char *, 5> kHeat = {"#fee8c8", "#fdbb84", "#fc8d59", "#d7301f", "#7f0000"};

/// What is free, in cells: exact outlines where the geometry library is there, else the rectangles
/// themselves.
std::vector<Outline> freeSpace(const std::vector<Rectangle> &rectangles)
{
#ifdef MRPP_HAS_GEOMETRY
    return outlinesOf(rectangles);
#else
    std::vector<Outline> outlines;
    for (const Rectangle &r : rectangles)
        outlines.push_back(
            {{{r.left, r.bottom, 0}, {r.right, r.bottom, 0}, {r.right, r.top, 0}, {r.left, r.top, 0}}, {}});
    return outlines;
#endif
}

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
        isGrid_ = isGrid();
        if (isGrid_)
            free_ = freeSpace(runs([](Vertex) { return true; }));
        if (solution_ != nullptr && instance_.robotCount() > kRobotsWithBoldRoutes)
            countArrivals();
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
    bool isGrid_ = false;
    std::vector<Outline> free_;         ///< of a grid, in cells
    std::vector<std::size_t> arrivals_; ///< at each vertex; empty where they are not shown
    std::size_t mostArrivals_ = 0;

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
        if (isGrid_)
            drawCells(cairo);
        else
            drawEdges(cairo);
        drawHeat(cairo);
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

    /// Rectangles of cells side by side, in cells from the bottom left, of the vertices that are wanted.
    template <class Wanted>
    [[nodiscard]] std::vector<Rectangle> runs(Wanted &&wanted) const
    {
        const auto cell = [this](Vertex v)
        {
            const Point &place = placement_.positions[v];
            return std::pair(std::round(place.y / placement_.spacing),
                             std::round(place.x / placement_.spacing));
        };
        std::vector<std::pair<double, double>> cells;
        for (Vertex v = 0; v < instance_.graph->vertexCount(); ++v)
            if (wanted(v))
                cells.push_back(cell(v));
        std::sort(cells.begin(), cells.end());
        std::vector<Rectangle> rectangles;
        for (const auto &[row, column] : cells)
            if (!rectangles.empty() && rectangles.back().bottom == row && rectangles.back().right == column)
                rectangles.back().right = column + 1;
            else
                rectangles.push_back({column, row, column + 1, row + 1});
        return rectangles;
    }

    [[nodiscard]] double cellX(double cells) const { return kMargin + cells * unit_; }
    [[nodiscard]] double cellY(double cells) const { return bottom_ - cells * unit_; }

    /// What is free as polygons with holes on a dark ground.
    void drawCells(cairo_t *cairo) const
    {
        cairo_set_source_rgb(cairo, 0.42, 0.42, 0.42);
        cairo_rectangle(cairo, kMargin, kMargin, width_ - 2 * kMargin, bottom_ - kMargin);
        cairo_fill(cairo);
        cairo_set_source_rgb(cairo, 0.95, 0.95, 0.95);
        cairo_set_fill_rule(cairo, CAIRO_FILL_RULE_EVEN_ODD);
        const auto follow = [&](const std::vector<Point> &corners)
        {
            for (const Point &corner : corners)
                cairo_line_to(cairo, cellX(corner.x), cellY(corner.y));
            cairo_close_path(cairo);
            cairo_new_sub_path(cairo);
        };
        for (const Outline &outline : free_)
        {
            follow(outline.boundary);
            for (const std::vector<Point> &hole : outline.holes)
                follow(hole);
            cairo_fill(cairo);
        }
    }

    void countArrivals()
    {
        arrivals_.resize(instance_.graph->vertexCount());
        for (const Move &move : solution_->moves())
            mostArrivals_ = std::max(mostArrivals_, ++arrivals_[move.to]);
    }

    /// 0 … 4: equal steps of the logarithm between one arrival and the most.
    [[nodiscard]] std::size_t heat(std::size_t arrivals) const
    {
        const double share =
            std::log(static_cast<double>(arrivals)) / std::log(static_cast<double>(mostArrivals_) + 1);
        return std::min(kHeat.size() - 1,
                        static_cast<std::size_t>(share * static_cast<double>(kHeat.size())));
    }

    void drawHeat(cairo_t *cairo) const
    {
        if (mostArrivals_ == 0)
            return;
        for (std::size_t level = 0; level < kHeat.size(); ++level)
        {
            const auto [red, green, blue] = rgb(kHeat[level]);
            cairo_set_source_rgb(cairo, red, green, blue);
            const auto isHere = [&](Vertex v) { return arrivals_[v] > 0 && heat(arrivals_[v]) == level; };
            std::size_t shapes = 0;
            const auto filled = [&]
            {
                if (++shapes % kStrokeAtOnce == 0)
                    cairo_fill(cairo);
            };
            if (isGrid_)
                for (const Rectangle &r : runs(isHere))
                {
                    cairo_rectangle(cairo, cellX(r.left), cellY(r.top), (r.right - r.left) * unit_, unit_);
                    filled();
                }
            else
                for (Vertex v = 0; v < instance_.graph->vertexCount(); ++v)
                    if (isHere(v))
                    {
                        cairo_new_sub_path(cairo);
                        cairo_arc(cairo, x(v), y(v), std::max(0.35 * unit_, 0.8), 0, 2 * std::numbers::pi);
                        filled();
                    }
            cairo_fill(cairo);
        }
    }

    /// The scale of heat, at the right end of the title's last line.
    void drawHeatScale(cairo_t *cairo, double base) const
    {
        if (mostArrivals_ == 0)
            return;
        constexpr double kBox = 9;
        constexpr double kFont = 8;
        cairo_set_font_size(cairo, kFont);
        const auto words = [&](double left, const std::string &text)
        {
            cairo_set_source_rgb(cairo, 0.13, 0.13, 0.13);
            cairo_move_to(cairo, left, base);
            cairo_show_text(cairo, text.c_str());
            cairo_text_extents_t size;
            cairo_text_extents(cairo, text.c_str(), &size);
            return left + size.x_advance + 4;
        };
        double left = words(kMargin, "arrivals at a vertex: 1");
        for (const char *color : kHeat)
        {
            const auto [red, green, blue] = rgb(color);
            cairo_set_source_rgb(cairo, red, green, blue);
            cairo_rectangle(cairo, left, base - kBox + 1.5, kBox, kBox);
            cairo_fill(cairo);
            left += kBox;
        }
        words(left + 4, fmt::format("{} (logarithmic)", mostArrivals_));
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

    /// Each robot's way as a line through the corners where it turns; nothing where there are too many.
    [[nodiscard]] std::vector<std::vector<Vertex>> ways() const
    {
        std::vector<std::vector<Vertex>> corners(instance_.robotCount());
        std::size_t count = 0;
        for (const Move &move : solution_->moves())
        {
            std::vector<Vertex> &way = corners[move.robot];
            if (way.empty())
                way.push_back(move.from);
            if (way.size() >= 2 && isStraight(way[way.size() - 2], way.back(), move.to))
                way.back() = move.to;
            else
            {
                way.push_back(move.to);
                ++count;
            }
        }
        if (count > kCornersDrawn)
            corners.clear();
        return corners;
    }

    [[nodiscard]] bool isStraight(Vertex a, Vertex b, Vertex c) const
    {
        const auto &p = placement_.positions;
        const double cross = (p[b].x - p[a].x) * (p[c].y - p[b].y) - (p[b].y - p[a].y) * (p[c].x - p[b].x);
        const double along = (p[b].x - p[a].x) * (p[c].x - p[b].x) + (p[b].y - p[a].y) * (p[c].y - p[b].y);
        constexpr double kTolerance = 1e-9;
        return along > 0 && std::abs(cross) < kTolerance * placement_.spacing * placement_.spacing;
    }

    void drawRoutes(cairo_t *cairo) const
    {
        if (solution_ == nullptr)
            return;
        const bool isBold = instance_.robotCount() <= kRobotsWithBoldRoutes;
        cairo_set_line_width(cairo,
                             isBold ? std::clamp(unit_ / 3, 0.5, 2.0) : std::clamp(unit_ / 8, 0.2, 0.5));
        cairo_set_line_cap(cairo, CAIRO_LINE_CAP_ROUND);
        cairo_set_line_join(cairo, CAIRO_LINE_JOIN_ROUND);
        const auto corners = ways();
        for (Robot robot = 0; robot < corners.size(); ++robot)
        {
            const auto [red, green, blue] = rgb(robotColor(robot));
            cairo_set_source_rgba(cairo, red, green, blue, isBold ? 1 : 0.6);
            for (const Vertex corner : corners[robot])
                cairo_line_to(cairo, x(corner), y(corner));
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
        drawHeatScale(cairo, base);
    }
};

} // namespace

Picture drawMap(const Instance &instance, const Solution *solution, const Placement &placement,
                const std::string &title)
{
    return MapDrawing(instance, solution, placement, title).draw();
}

} // namespace mrpp

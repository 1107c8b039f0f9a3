#include "reports/layouts/LayoutPicture.h"
#include "reports/layouts/MapGround.h"
#include "reports/picture/CairoCanvas.h"
#include "reports/picture/Palette.h"
#include "reports/picture/Text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace mrpp
{

namespace
{

constexpr double kLongSide = 600; // points
constexpr double kLeastWidth = 400;
constexpr double kMargin = 10;
constexpr double kText = 74; // points beneath the map: the title and two lines of legend
constexpr const char *kTitleFont = "DejaVu Sans 11";
constexpr const char *kLegendFont = "DejaVu Sans 9";

constexpr std::size_t kRobotsWithBoldRoutes = 60; // more are a tangle: then heat shows where they went
constexpr std::size_t kCornersDrawn = 200'000;    // of routes: beyond that the files outgrow their use

/// Light to dark, so that they keep their order in greyscale: the sequential scheme OrRd of C. Brewer.
constexpr std::array<const char *, 5> kHeat = {"#fee8c8", "#fdbb84", "#fc8d59", "#d7301f", "#7f0000"};

class MapDrawing
{
public:
    MapDrawing(const Instance &instance, const Solution *solution, const Placement &placement,
               const std::string &title)
        : instance_(instance), solution_(solution), ground_(*instance.graph, placement), title_(title)
    {
        const Extent size = ground_.size();
        area_.unit = kLongSide / std::max(size.width, size.height);
        width_ = std::max(size.width * area_.unit, kLeastWidth) + 2 * kMargin;
        area_.left = (width_ - size.width * area_.unit) / 2;
        area_.bottom = size.height * area_.unit + kMargin;
        height_ = area_.bottom + kText + kMargin;
        if (solution_ == nullptr)
            return;
        if (!isBold())
            countArrivals();
        findWays();
    }

    [[nodiscard]] Picture draw() const
    {
        return drawPicture(width_, height_,
                           [this](cairo_t *cairo)
                           {
                               ground_.draw(cairo, area_);
                               drawHeat(cairo);
                               drawWays(cairo);
                               drawRobots(cairo);
                               drawText(cairo);
                           });
    }

private:
    const Instance &instance_;
    const Solution *solution_;
    MapGround ground_;
    const std::string &title_;
    MapArea area_;
    double width_ = 0;                      ///< points
    double height_ = 0;                     ///< points
    std::vector<std::vector<Vertex>> ways_; ///< of each robot the corners where it turns
    std::vector<std::size_t> arrivals_;     ///< at each vertex; empty where they are not shown
    std::size_t mostArrivals_ = 0;

    [[nodiscard]] bool isBold() const { return instance_.robotCount() <= kRobotsWithBoldRoutes; }

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

    static void setColor(cairo_t *cairo, const std::string &color, double opacity = 1)
    {
        const auto [red, green, blue] = rgb(color);
        cairo_set_source_rgba(cairo, red, green, blue, opacity);
    }

    void drawHeat(cairo_t *cairo) const
    {
        if (mostArrivals_ == 0)
            return;
        for (std::size_t level = 0; level < kHeat.size(); ++level)
        {
            setColor(cairo, kHeat[level]);
            ground_.fill(cairo, area_,
                         [&](Vertex v) { return arrivals_[v] > 0 && heat(arrivals_[v]) == level; });
        }
    }

    /// Nothing where there are too many corners.
    void findWays()
    {
        ways_.resize(instance_.robotCount());
        std::size_t count = 0;
        for (const Move &move : solution_->moves())
        {
            std::vector<Vertex> &way = ways_[move.robot];
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
            ways_.clear();
    }

    [[nodiscard]] bool isStraight(Vertex a, Vertex b, Vertex c) const
    {
        const Point p = ground_.at(a, area_);
        const Point q = ground_.at(b, area_);
        const Point r = ground_.at(c, area_);
        const double cross = (q.x - p.x) * (r.y - q.y) - (q.y - p.y) * (r.x - q.x);
        const double along = (q.x - p.x) * (r.x - q.x) + (q.y - p.y) * (r.y - q.y);
        constexpr double kTolerance = 1e-9;
        return along > 0 && std::abs(cross) < kTolerance * area_.unit * area_.unit;
    }

    [[nodiscard]] double wayWidth() const
    {
        return isBold() ? std::clamp(area_.unit / 3, 0.5, 2.0) : std::clamp(area_.unit / 8, 0.2, 0.5);
    }
    [[nodiscard]] double wayOpacity() const { return isBold() ? 1 : 0.6; }

    void drawWays(cairo_t *cairo) const
    {
        cairo_set_line_width(cairo, wayWidth());
        cairo_set_line_cap(cairo, CAIRO_LINE_CAP_ROUND);
        cairo_set_line_join(cairo, CAIRO_LINE_JOIN_ROUND);
        for (Robot robot = 0; robot < ways_.size(); ++robot)
        {
            setColor(cairo, robotColor(robot), wayOpacity());
            for (const Vertex corner : ways_[robot])
            {
                const Point place = ground_.at(corner, area_);
                cairo_line_to(cairo, place.x, place.y);
            }
            cairo_stroke(cairo);
        }
    }

    static void drawStart(cairo_t *cairo, const Point &place, double radius)
    {
        cairo_arc(cairo, place.x, place.y, radius, 0, 2 * std::numbers::pi);
        cairo_fill(cairo);
    }
    static void drawGoal(cairo_t *cairo, const Point &place, double radius)
    {
        cairo_set_line_width(cairo, std::max(0.6, radius / 3));
        cairo_rectangle(cairo, place.x - radius, place.y - radius, 2 * radius, 2 * radius);
        cairo_stroke(cairo);
    }

    void drawRobots(cairo_t *cairo) const
    {
        const double radius = std::max(area_.unit * 0.45, instance_.robotCount() > 200 ? 1.1 : 2.0);
        for (Robot robot = 0; robot < instance_.robotCount(); ++robot)
        {
            setColor(cairo, robotColor(robot));
            drawGoal(cairo, ground_.at(instance_.goals[robot], area_), radius);
        }
        for (Robot robot = 0; robot < instance_.robotCount(); ++robot)
        {
            setColor(cairo, robotColor(robot));
            drawStart(cairo, ground_.at(instance_.starts[robot], area_), radius);
        }
    }

    void drawText(cairo_t *cairo) const
    {
        constexpr double kGap = 6;
        const auto words = [&](double left, double top, const std::string &text)
        {
            const TextLayout made = layText(cairo, text, {kLegendFont});
            setColor(cairo, "#202020");
            showText(cairo, made, left, top);
            return left + sizeOf(made).width + kGap;
        };
        const TextLayout title =
            layText(cairo, manyLines(title_), {kTitleFont, width_ - 2 * kMargin, PANGO_ALIGN_CENTER});
        setColor(cairo, "#202020");
        showText(cairo, title, kMargin, area_.bottom + kGap);

        constexpr double kSign = 4; // half a sign's size
        double top = area_.bottom + 2 * kGap + sizeOf(title).height;
        double left = kMargin;
        const auto sign = [&] { return Point{left + kSign, top + 1.5 * kSign, 0}; };
        const auto explain = [&](const std::string &text)
        { left = words(left + 2 * kSign + kGap, top, text) + kGap; };
        setColor(cairo, robotColor(0));
        drawStart(cairo, sign(), kSign);
        explain("start");
        setColor(cairo, robotColor(0));
        drawGoal(cairo, sign(), kSign);
        explain("goal, in the robot's colour");
        if (!ways_.empty())
        {
            setColor(cairo, robotColor(0), wayOpacity());
            cairo_set_line_width(cairo, std::max(0.8, wayWidth()));
            cairo_move_to(cairo, left, sign().y);
            cairo_line_to(cairo, left + 2 * kSign, sign().y);
            cairo_stroke(cairo);
            explain("route");
        }
        if (mostArrivals_ == 0)
            return;
        top += 3 * kSign + kGap / 2;
        left = words(kMargin, top, "arrivals at a vertex: 1");
        for (const char *color : kHeat)
        {
            setColor(cairo, color);
            cairo_rectangle(cairo, left, top + kSign / 2, 2 * kSign, 2 * kSign);
            cairo_fill(cairo);
            left += 2 * kSign;
        }
        words(left + kGap, top, fmt::format("{} (logarithmic)", mostArrivals_));
    }
};

} // namespace

Picture drawMap(const Instance &instance, const Solution *solution, const Placement &placement,
                const std::string &title)
{
    return MapDrawing(instance, solution, placement, title).draw();
}

} // namespace mrpp

#include "reports/layouts/FramesPicture.h"

#include "framework/evaluation/Condense.h"
#include "reports/layouts/MapGround.h"
#include "reports/picture/CairoCanvas.h"
#include "reports/picture/Palette.h"
#include "reports/picture/Text.h"

#include <algorithm>
#include <fmt/format.h>
#include <numbers>
#include <numeric>

namespace mrpp
{

namespace
{

constexpr std::size_t kFrames = 6;
constexpr double kWidth = 484;         // points: as wide as a page's text
constexpr double kFramesHeight = 440;  // points, at most, of all frames
constexpr double kCaption = 24;        // points beneath a frame, two lines
constexpr double kGutter = 12;         // points between frames
constexpr double kLargestUnit = 26;    // points between neighbours
constexpr double kGoodUnit = 19;       // points between neighbours, that numbers need
constexpr double kSmallestVertex = 3;  // points between neighbours: closer ones are a map
constexpr double kSmallestNumber = 11; // points, a robot's diameter
constexpr std::size_t kCrowd = 60;     // robots: of more there are neither names nor trails
constexpr const char *kOnItsWay = "#f0a030";
constexpr const char *kArrived = "#0a2a5a";

/// The positions over the steps of a condensed solution.
class Playback
{
public:
    Playback(const Instance &instance, const Solution &solution)
        : instance_(instance), moves_(solution.moves()),
          steps_(moveSteps(instance, solution, ruleOf(solution))), order_(moves_.size()),
          places_(instance.starts)
    {
        std::iota(order_.begin(), order_.end(), std::size_t{0});
        std::stable_sort(order_.begin(), order_.end(),
                         [this](std::size_t a, std::size_t b) { return steps_[a] < steps_[b]; });
    }

    [[nodiscard]] std::size_t makespan() const { return order_.empty() ? 0 : steps_[order_.back()] + 1; }
    [[nodiscard]] const std::vector<Vertex> &places() const { return places_; }
    [[nodiscard]] std::uint32_t atGoal() const
    {
        std::uint32_t count = 0;
        for (Robot robot = 0; robot < places_.size(); ++robot)
            count += isAtGoal(robot) ? 1 : 0;
        return count;
    }
    [[nodiscard]] bool isAtGoal(Robot robot) const { return places_[robot] == instance_.goals[robot]; }

    /// Goes on until so many steps are done; `visit(const Move &)` for each move.
    template <class Visit>
    void advance(std::size_t step, Visit &&visit)
    {
        for (; next_ < order_.size() && steps_[order_[next_]] < step; ++next_)
        {
            const Move &move = moves_[order_[next_]];
            places_[move.robot] = move.to;
            visit(move);
        }
    }

    /// Robots at their goals after each step.
    [[nodiscard]] std::vector<std::uint32_t> progress() const
    {
        Playback replay = *this;
        std::uint32_t count = replay.atGoal();
        std::vector<std::uint32_t> result = {count};
        for (std::size_t step = 1; step <= makespan(); ++step)
        {
            replay.advance(step,
                           [&](const Move &move)
                           {
                               const Vertex goal = instance_.goals[move.robot];
                               count += (move.to == goal ? 1U : 0U) - (move.from == goal ? 1U : 0U);
                           });
            result.push_back(count);
        }
        return result;
    }

private:
    const Instance &instance_;
    std::span<const Move> moves_;
    std::vector<std::uint32_t> steps_;
    std::vector<std::size_t> order_; ///< of moves, by step
    std::vector<Vertex> places_;
    std::size_t next_ = 0; ///< in order_

    static MotionRule ruleOf(const Solution &solution)
    {
        return solution.rotations().empty() ? MotionRule::following : MotionRule::rotation;
    }
};

class FramesDrawing
{
public:
    FramesDrawing(const Instance &instance, const Solution &solution, const Placement &placement,
                  const std::string &title)
        : instance_(instance), ground_(*instance.graph, placement), start_(instance, solution), title_(title),
          steps_(keySteps(start_.progress(), kFrames))
    {
        if (instance.graph->vertexCount() > kLargestGraph && !ground_.isGrid())
            throw DrawingError(
                fmt::format("{} vertices that are no grid are too many for frames (at most {})",
                            instance.graph->vertexCount(), kLargestGraph));
        arrange();
    }

    [[nodiscard]] Picture draw() const
    {
        const double height = static_cast<double>(rows()) * (frameHeight_ + kCaption + kGutter) + kText;
        return drawPicture(kWidth, height, [this](cairo_t *cairo) { drawOn(cairo); });
    }

private:
    static constexpr double kText = 42; ///< points, of title and legend

    const Instance &instance_;
    MapGround ground_;
    Playback start_;
    const std::string &title_;
    std::vector<std::size_t> steps_;
    std::size_t columns_ = 1;
    double unit_ = 0; ///< points between neighbours
    double frameHeight_ = 0;

    [[nodiscard]] std::size_t rows() const { return (steps_.size() + columns_ - 1) / columns_; }
    [[nodiscard]] double frameWidth() const
    {
        const auto columns = static_cast<double>(columns_);
        return (kWidth - (columns + 1) * kGutter) / columns;
    }

    /// In as few rows as are large enough, or else those that make the frames largest.
    void arrange()
    {
        const Extent size = ground_.size();
        const std::size_t frames = steps_.size();
        for (std::size_t rowCount = 1; rowCount <= frames; ++rowCount)
        {
            const std::size_t columns = (frames + rowCount - 1) / rowCount;
            const auto across = static_cast<double>(columns);
            const auto down = static_cast<double>(rowCount);
            const double unit =
                std::min({kLargestUnit, (kWidth - (across + 1) * kGutter) / across / size.width,
                          (kFramesHeight / down - kCaption - kGutter) / size.height});
            if (unit_ < kGoodUnit && unit > unit_)
            {
                unit_ = unit;
                columns_ = columns;
            }
        }
        frameHeight_ = unit_ * size.height;
    }

    void drawOn(cairo_t *cairo) const
    {
        Playback playback = start_;
        std::vector<Move> trail;
        for (std::size_t i = 0; i < steps_.size(); ++i)
        {
            trail.clear();
            playback.advance(steps_[i], [&trail](const Move &move) { trail.push_back(move); });
            const double left = kGutter + static_cast<double>(i % columns_) * (frameWidth() + kGutter);
            const std::size_t row = i / columns_;
            const double top = kGutter / 2 + static_cast<double>(row) * (frameHeight_ + kCaption + kGutter);
            const double inset = (frameWidth() - ground_.size().width * unit_) / 2;
            const MapArea area = {left + inset, top + frameHeight_, unit_};
            drawGround(cairo, area);
            if (isCrowd())
                drawCrowd(cairo, area, playback);
            else
            {
                drawTrail(cairo, area, trail);
                drawRobots(cairo, area, playback);
            }
            const std::string when = i == 0                   ? "start"
                                     : i + 1 == steps_.size() ? fmt::format("end, step {}", steps_[i])
                                                              : fmt::format("step {}", steps_[i]);
            setColor(cairo, "#202020");
            showText(
                cairo,
                layText(cairo,
                        fmt::format("{}\n{} of {} at goal", when, playback.atGoal(), instance_.robotCount()),
                        {"DejaVu Sans 7.5", frameWidth(), PANGO_ALIGN_CENTER, 2}),
                left, top + frameHeight_ + 2);
        }
        drawText(cairo);
    }

    static void setColor(cairo_t *cairo, const std::string &color)
    {
        const auto [red, green, blue] = rgb(color);
        cairo_set_source_rgb(cairo, red, green, blue);
    }

    [[nodiscard]] bool isCrowd() const { return instance_.robotCount() > kCrowd; }
    [[nodiscard]] double radius() const { return std::max(0.3 * unit_, 0.9); }

    static void disc(cairo_t *cairo, const Point &place, double radius)
    {
        cairo_new_sub_path(cairo);
        cairo_arc(cairo, place.x, place.y, radius, 0, 2 * std::numbers::pi);
    }

    void drawGround(cairo_t *cairo, const MapArea &area) const
    {
        const Graph &graph = *instance_.graph;
        if (unit_ < kSmallestVertex || graph.vertexCount() > kLargestGraph)
        {
            ground_.draw(cairo, area);
            return;
        }
        setColor(cairo, "#c4c4c4");
        cairo_set_line_width(cairo, std::clamp(unit_ / 20, 0.4, 1.5));
        for (const Graph::Edge &edge : graph.edges())
        {
            const Point from = ground_.at(edge.a, area);
            const Point to = ground_.at(edge.b, area);
            cairo_move_to(cairo, from.x, from.y);
            cairo_line_to(cairo, to.x, to.y);
        }
        cairo_stroke(cairo);
        cairo_set_line_width(cairo, 0.5);
        for (Vertex v = 0; v < graph.vertexCount(); ++v)
            disc(cairo, ground_.at(v, area), 0.75 * radius());
        setColor(cairo, "#ffffff");
        cairo_fill_preserve(cairo);
        setColor(cairo, "#9a9a9a");
        cairo_stroke(cairo);
    }

    /// Where the robots went since the frame before.
    void drawTrail(cairo_t *cairo, const MapArea &area, const std::vector<Move> &trail) const
    {
        cairo_set_line_width(cairo, std::clamp(unit_ / 12, 0.6, 2.5));
        cairo_set_line_cap(cairo, CAIRO_LINE_CAP_ROUND);
        for (const Move &move : trail)
        {
            setColor(cairo, robotColor(move.robot));
            const Point from = ground_.at(move.from, area);
            const Point to = ground_.at(move.to, area);
            cairo_move_to(cairo, from.x, from.y);
            cairo_line_to(cairo, to.x, to.y);
            cairo_stroke(cairo);
        }
    }

    void drawCrowd(cairo_t *cairo, const MapArea &area, const Playback &playback) const
    {
        for (const bool isArrived : {false, true})
        {
            setColor(cairo, isArrived ? kArrived : kOnItsWay);
            for (Robot robot = 0; robot < instance_.robotCount(); ++robot)
                if (playback.isAtGoal(robot) == isArrived)
                    disc(cairo, ground_.at(playback.places()[robot], area), radius());
            cairo_fill(cairo);
        }
    }

    void drawRobots(cairo_t *cairo, const MapArea &area, const Playback &playback) const
    {
        const double width = std::clamp(radius() / 4, 0.3, 2.2);
        for (Robot robot = 0; robot < instance_.robotCount(); ++robot)
        {
            if (playback.isAtGoal(robot))
                continue;
            setColor(cairo, robotColor(robot));
            cairo_set_line_width(cairo, width);
            disc(cairo, ground_.at(instance_.goals[robot], area), radius() + width);
            cairo_stroke(cairo);
        }
        for (Robot robot = 0; robot < instance_.robotCount(); ++robot)
            drawRobot(cairo, ground_.at(playback.places()[robot], area), robot, playback.isAtGoal(robot));
    }

    void drawRobot(cairo_t *cairo, const Point &place, Robot robot, bool isAtGoal) const
    {
        const std::string color = robotColor(robot);
        setColor(cairo, color);
        disc(cairo, place, radius());
        cairo_fill(cairo);
        if (isAtGoal)
        {
            setColor(cairo, "#000000");
            cairo_set_line_width(cairo, std::clamp(radius() / 4, 0.3, 2.2));
            disc(cairo, place, radius());
            cairo_stroke(cairo);
        }
        if (2 * radius() < kSmallestNumber)
            return;
        const TextLayout number =
            layText(cairo, std::to_string(robot), {fmt::format("DejaVu Sans {:.1f}", 0.9 * radius())});
        const TextSize size = sizeOf(number);
        setColor(cairo, textColorOn(color));
        showText(cairo, number, place.x - size.width / 2, place.y - size.height / 2);
    }

    void drawText(cairo_t *cairo) const
    {
        const char *legend = isCrowd()
                                 ? "light disc: robot on its way; dark disc: robot at its goal"
                                 : "disc: robot; black rim: it is at its goal; ring: a goal whose robot is "
                                   "elsewhere; line: way since the frame before";
        const double top = static_cast<double>(rows()) * (frameHeight_ + kCaption + kGutter);
        setColor(cairo, "#202020");
        const auto show = [&](const std::string &text, const char *font, double at) {
            showText(cairo, layText(cairo, text, {font, kWidth, PANGO_ALIGN_CENTER, 1}), 0, at);
        };
        show(oneLine(title_), "DejaVu Sans 9", top + 4);
        show(legend, "DejaVu Sans 7", top + 20);
    }
};

} // namespace

std::vector<std::size_t> keySteps(const std::vector<std::uint32_t> &atGoal, std::size_t most)
{
    const std::size_t makespan = atGoal.size() - 1;
    std::vector<std::size_t> steps = {0};
    const std::size_t parts = std::min(most - 1, makespan); // the last one ends with the makespan itself
    for (std::size_t part = 0; part + 1 < parts; ++part)
    {
        std::size_t best = makespan * part / parts + 1;
        for (std::size_t step = best; step <= makespan * (part + 1) / parts; ++step)
            if (atGoal[step] >= atGoal[best])
                best = step;
        steps.push_back(best);
    }
    if (makespan > 0)
        steps.push_back(makespan);
    return steps;
}

Picture drawFrames(const Instance &instance, const Solution &solution, const Placement &placement,
                   const std::string &title)
{
    return FramesDrawing(instance, solution, placement, title).draw();
}

} // namespace mrpp

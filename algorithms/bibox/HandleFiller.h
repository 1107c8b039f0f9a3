#pragma once
/// \file
/// Fills one handle x – w1 – … – wl – y with the robots whose goals are there.
///
/// Robots enter at x, which is the end from which that looks cheaper, the one for wl first, and push those
/// that are inside deeper; whoever is in their way leaves at y. The robots that are *in order*, those for wl,
/// wl−1, … one behind the other, with nobody but free vertices between them and with nobody in front of them,
/// grow by one with each that enters; when all are, they stand at their goals. What the paper calls turning
/// the handle's cycle is then: a free place goes to y, everybody inside makes one step, and the robot on x
/// enters; but with a free vertex inside nobody behind it has to move.
///
/// A robot that is inside but has to enter later is let out at y (*extract*). Where free vertices are too few
/// for that, robots from x enter behind it meanwhile, and leave at x again, as the paper turns its cycle
/// back.
///
/// Source: P. Surynek, "A novel approach to path planning for multiple robots in bi-connected graphs",
/// ICRA 2009. New here: several free vertices in a handle; free vertices are locked where they belong.

#include "algorithms/bibox/Carrier.h"

#include <optional>
#include <span>
#include <vector>

namespace mrpp
{

class HandleFiller
{
public:
    /// Keeps references to all of them.
    /// \param goalRobots the robot whose goal a vertex is, or kNoRobot; size = vertices
    /// \param random chooses between ends that look about equally cheap; null: the cheaper one
    HandleFiller(Carrier &carrier, std::span<const Robot> goalRobots, Random *random = nullptr);

    /// Fills handle i, and closes the open part down to level i. False where the termination condition came
    /// first.
    /// \pre level i + 1 is open; at least two of the vertices of lower levels are nobody's goal
    [[nodiscard]] bool fill(std::size_t i);

private:
    [[nodiscard]] Vertex x() const { return line_.front(); }
    [[nodiscard]] Vertex y() const { return line_.back(); }
    /// Its place in line_ where it is inside; 0 where it is not.
    [[nodiscard]] std::size_t placeInside(Robot r) const;
    /// The first place with a robot (or without one), from x inwards or from y inwards; the other end's place
    /// where there is none.
    [[nodiscard]] std::size_t firstFromX(bool occupied) const;
    [[nodiscard]] std::size_t firstFromY(bool occupied) const;
    [[nodiscard]] bool freeOutside() const;
    [[nodiscard]] bool isFilled() const;

    void setLine(std::span<const Vertex> line);
    [[nodiscard]] std::size_t countInOrder() const;
    [[nodiscard]] std::optional<std::size_t> effort();
    [[nodiscard]] bool orient();
    [[nodiscard]] bool bringInOrder();
    void enter();
    void letInAtX();
    void letInAtY();
    void letOutAtX(Vertex stays);
    void letOutAtY();
    [[nodiscard]] bool extract(Robot r);
    void settle();

    Carrier &carrier_;
    PebbleBoard &board_;
    OpenGraph &open_;
    std::span<const Robot> goalRobots_;
    Random *random_;
    std::size_t freeOpen_;            ///< free vertices in the open part
    std::vector<Vertex> line_;        ///< x, w1, …, wl, y
    std::vector<Robot> order_;        ///< the robots for wl, …, w1
    std::vector<std::size_t> places_; ///< in line_, of its vertices; anything for others; size = vertices
};

} // namespace mrpp

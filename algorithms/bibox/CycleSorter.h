#pragma once
/// \file
/// BIBOX's last stage: everything but the first cycle is locked, and its robots have to be brought into the
/// right cyclic order with the help of one vertex beside it, the *pocket*.
///
/// The paper exchanges pairs of robots. Here as many as possible keep their places (a longest cyclically
/// ascending subsequence); each of the others is turned to the pocket, waits in it while the cycle is turned
/// on to its new place, and comes back. Who belongs into the pocket joins the cycle meanwhile, and goes home
/// in the end. Then the cycle is turned until everybody is at the goal. With k robots on a cycle of c
/// vertices these are at most k insertions of O(c · k) moves each.
///
/// Source: P. Surynek, "A novel approach to path planning for multiple robots in bi-connected graphs",
/// ICRA 2009.

#include "algorithms/bibox/Carrier.h"

#include <span>
#include <vector>

namespace mrpp
{

class CycleSorter
{
public:
    /// Keeps references to both.
    /// \param goalRobots the robot whose goal a vertex is, or kNoRobot; size = vertices
    CycleSorter(Carrier &carrier, std::span<const Robot> goalRobots);

    /// False where the termination condition came first.
    /// \pre level 0 is open; two vertices of the cycle are free; all other robots are at their goals; the
    /// graph is no cycle
    [[nodiscard]] bool sort();

private:
    struct Pocket
    {
        std::size_t place = 0; ///< of its neighbour on the cycle
        Vertex vertex = kNoVertex;
    };

    [[nodiscard]] Vertex at(std::size_t place) const { return cycle_[place % cycle_.size()]; }
    [[nodiscard]] std::size_t place(Robot r) const { return places_[board_.position(r)]; }
    [[nodiscard]] std::vector<Robot> robotsFrom(std::size_t place) const;
    [[nodiscard]] std::vector<Robot> misplaced() const;
    [[nodiscard]] std::size_t distance(std::size_t a, std::size_t b) const;
    [[nodiscard]] Pocket findPocket(Robot user) const;
    [[nodiscard]] Robot takeNearest(std::size_t place, std::vector<Robot> &robots) const;
    [[nodiscard]] Robot successor(Robot r) const;
    [[nodiscard]] bool insert(Robot r, Robot before, const Pocket &pocket);
    [[nodiscard]] bool align();

    Carrier &carrier_;
    PebbleBoard &board_;
    std::span<const Robot> goalRobots_;
    std::span<const Vertex> cycle_;
    std::vector<std::size_t> places_;     ///< of the vertices of the cycle; size = vertices
    std::vector<std::size_t> goalPlaces_; ///< of the robots that belong on the cycle; size = robots
    std::vector<char> waiting_;           ///< nonzero for robots that are still to be inserted; size = robots
};

} // namespace mrpp

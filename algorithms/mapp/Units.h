#pragma once
/// \file
/// The first half of MAPP: a path for every robot, alternate paths along it, and the test
/// SLIDABLE, which says who is sure to arrive.
///
/// A path is l0 … lK. Step i goes from l(i) to l(i+1). A robot is SLIDABLE where
/// 1. *alternate connectivity*: for every step but the first and the last there is an alternate path from
///    l(i+1) back to l(i−1) that avoids l(i), and l(K); where there is none, the steps in a row that have
///    none are a *tunnel*, and further along the path there is a *buffer zone* with as many free vertices as
///    the tunnel has steps, kept free for this robot;
/// 2. *initial blank*: l1 is free;
/// 3. *target isolation*: its goal is on no other robot's path or alternate path; or, relaxed: robots whose
///    paths cross it are SLIDABLE themselves, and go before it.
/// Conditions 1 and 3 are relaxed as settings say.
///
/// Source: K.-H. C. Wang, A. Botea, "MAPP: a scalable multi-agent path planning algorithm with tractability
/// and completeness guarantees", JAIR 42 (2011) 55–90.

#include "algorithms/mapp/Alternates.h"
#include "algorithms/pebble/PebbleBoard.h"
#include "algorithms/search/PathFinder.h"
#include "framework/model/Instance.h"
#include "framework/support/Random.h"
#include "framework/support/TerminationCondition.h"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace mrpp::mapp
{

struct Settings
{
    bool orderedGoals = true;            ///< goals may be crossed: target isolation relaxed (TI)
    bool tunnels = true;                 ///< alternate connectivity relaxed (AC)
    bool counting = true;                ///< repositioning with counting (RC)
    bool attemptAll = true;              ///< robots that are not SLIDABLE try, too
    std::uint32_t longestDetour = 16;    ///< steps of an alternate path, goals counting more
    PathFinder::Cost crossingPrice = 10; ///< steps that a path goes around rather than cross a goal
};

/// Vertices of a robot's path behind a tunnel of it. While the robot has the tunnel before it, nobody of
/// lower rank may leave fewer than `need` of them free.
struct Zone
{
    Robot owner = kNoRobot;
    std::uint32_t lastStep = 0; ///< of the tunnel
    std::uint32_t need = 0;     ///< free vertices
};

class Units
{
public:
    /// Plans for every robot, from where it stands. Keeps references to instance, board and settings. Ends
    /// early where the termination condition says stop.
    /// \param random changes the order of robots; null: the nearer to its goal the earlier
    Units(const Instance &instance, const PebbleBoard &board, PathFinder &paths, const Settings &settings,
          Random *random, const TerminationCondition &ptc);

    /// l0 … lK; empty where the robot has no way.
    [[nodiscard]] std::span<const Vertex> path(Robot r) const
    {
        return {path_.data() + offsets_[r], path_.data() + offsets_[r + 1]};
    }
    /// From l(step+1) back to l(step−1), without the former; empty where there is none.
    [[nodiscard]] std::span<const Vertex> alternate(Robot r, std::size_t step) const
    {
        const std::uint32_t number = numbers_[offsets_[r] + step];
        return number == Alternates::kNone ? std::span<const Vertex>() : alternates_.path(number);
    }
    [[nodiscard]] bool isSlidable(Robot r) const { return refusals_[r] == Refusal::none; }
    [[nodiscard]] std::size_t robotCount() const { return refusals_.size(); }
    [[nodiscard]] std::size_t slidableCount() const;

    /// Those that move by themselves, highest rank first: the SLIDABLE, then those that only try. After those
    /// whose paths cross its goal comes who is nearest to its own.
    [[nodiscard]] std::span<const Robot> order() const { return order_; }

    /// The robots whose goals the paths or alternate paths of a SLIDABLE robot touch.
    [[nodiscard]] std::span<const Robot> crossed(Robot r) const
    {
        return {crossed_.data() + crossedOffsets_[r], crossed_.data() + crossedOffsets_[r + 1]};
    }
    [[nodiscard]] std::span<const Zone> zones() const { return zones_; }
    [[nodiscard]] std::span<const Vertex> verticesOf(std::uint32_t zone) const
    {
        return {zoneVertices_.data() + zoneOffsets_[zone], zoneVertices_.data() + zoneOffsets_[zone + 1]};
    }

    /// Why a robot is not SLIDABLE, in words; "" where it is.
    [[nodiscard]] std::string refusal(Robot r) const;

private:
    enum class Refusal : std::uint8_t
    {
        none,
        noPath,
        noBlank,
        noAlternate,
        goalCrossed,
        goalOrder,
        goalTaken
    };

    void plan(Robot r, PathFinder &paths, const TerminationCondition &ptc);
    void findAlternates(Robot r);
    bool bufferTunnels(Robot r);
    std::size_t bufferBehind(Robot r, std::span<const Vertex> l, std::size_t first, std::size_t last,
                             std::size_t zoneBegin);
    bool keepFree(Robot r, std::span<const Vertex> l, std::size_t first, std::size_t last);
    void addZone(const Zone &zone);
    void findCrossed(Robot r);
    void isolateGoals();
    void rankUnits(Random *random, const TerminationCondition &ptc);
    std::vector<Robot> refuse(Robot r, Refusal why);
    [[nodiscard]] std::uint32_t length(Robot r) const { return offsets_[r + 1] - offsets_[r]; }

    const Instance &instance_;
    const PebbleBoard &board_;
    const Settings &settings_;
    std::vector<char> isGoal_;      ///< size V
    std::vector<Robot> robotsHere_; ///< whose goal a vertex is; size V
    Alternates alternates_;
    std::vector<std::uint32_t> offsets_; ///< size robots + 1
    std::vector<Vertex> path_;
    std::vector<std::uint32_t> numbers_; ///< of alternate paths, beside path_
    std::vector<Refusal> refusals_;      ///< size robots
    std::vector<Robot> order_;
    std::vector<std::uint32_t> crossedOffsets_;
    std::vector<Robot> crossed_;
    std::vector<Zone> zones_;
    std::vector<std::uint32_t> zoneOffsets_ = {0};
    std::vector<Vertex> zoneVertices_;
    std::vector<std::uint32_t> stamps_; ///< size V
    std::uint32_t stamp_ = 0;
};

} // namespace mrpp::mapp

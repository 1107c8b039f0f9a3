#pragma once
/// \file
/// MAPP: multi-agent path planning that knows beforehand which robots are sure to arrive.
///
/// Every robot gets one path, with short alternate paths along it around each of its vertices. Robots for
/// which that and two more conditions hold are *SLIDABLE*. They move along their paths, all at once, in an
/// order of rank; whoever stands in the way is slid along an alternate path. The one of highest rank always
/// arrives; then the others are taken back as far as needed, and it begins again.
///
/// Use it for: many robots on large maps with room around them. It costs one path search a robot, and what
/// it cannot promise it says: SLIDABLE robots always arrive, others may; the status is `partial` where some
/// do not.
///
/// Complexity: for n robots, O(n) searches, and O(n^2 V) moves where alternate paths are short; in practice
/// near the sum of the shortest distances. Memory O(V + E + moves).
///
/// Source: K.-H. C. Wang, A. Botea, "MAPP: a scalable multi-agent path planning algorithm with tractability
/// and completeness guarantees", JAIR 42 (2011) 55–90. docs/mapp.md says what differs.

#include "algorithms/RestartingPlanner.h"
#include "algorithms/mapp/Units.h"
#include "framework/analysis/Landmarks.h"

#include <atomic>
#include <memory>
#include <vector>

namespace mrpp
{

class Mapp final : public RestartingPlanner
{
public:
    Mapp();

    void setup() override;
    void clear() override;

    /// The SLIDABLE robots of the instance, ascending. \pre setup()
    [[nodiscard]] std::vector<Robot> slidableRobots() const;

private:
    Outcome attempt(std::uint64_t number, const TerminationCondition &ptc) const override;
    [[nodiscard]] mapp::Settings settings() const;

    std::string targetIsolation_ = "ordered";
    bool tunnels_ = true;
    std::string repositioning_ = "counting";
    bool attemptAll_ = true;
    std::int64_t alternateLength_ = 16;
    std::int64_t crossingPrice_ = 10;
    std::unique_ptr<Landmarks> landmarks_;
    mutable std::atomic<std::size_t> slidable_ = 0; ///< progress properties, of the latest attempt
    mutable std::atomic<std::size_t> arrived_ = 0;
};

} // namespace mrpp

#pragma once

#include "framework/plan/BenchmarkPlan.h"
#include "framework/support/Error.h"

#include <string>

namespace mrpp
{

/// What is wrong with the input of one of a plan's problem points: a file that is missing or malformed,
/// robots that do not fit. Whoever read the plan can tell where it says that, see placed() in PlanReader.h.
class PointError : public InputError
{
public:
    /// \param point a place in plan.points
    PointError(const InputError &error, const BenchmarkPlan &plan, std::size_t point);

    [[nodiscard]] std::size_t point() const { return point_; }
    /// The setting that leads to it: "map", "robots"; empty where that is not known.
    [[nodiscard]] const std::string &setting() const { return setting_; }
    /// "problem 'yard'".
    [[nodiscard]] const std::string &problem() const { return problem_; }
    /// Whether where() is a line of a file that the problem reads.
    [[nodiscard]] bool isInFile() const { return where().line > 0; }

private:
    std::size_t point_;
    std::string problem_;
    std::string setting_;
};

} // namespace mrpp

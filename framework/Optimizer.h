#pragma once
/// \file
/// Subclass Optimizer to add a post-processing step: a shorter solution from a given one.

#include "framework/model/Instance.h"
#include "framework/model/Solution.h"
#include "framework/support/Parameters.h"
#include "framework/support/TerminationCondition.h"

namespace mrpp
{

class Optimizer
{
public:
    Optimizer() = default;
    virtual ~Optimizer() = default;
    Optimizer(const Optimizer &) = delete;
    Optimizer &operator=(const Optimizer &) = delete;

    [[nodiscard]] ParameterSet &parameters() { return parameters_; }
    [[nodiscard]] const ParameterSet &parameters() const { return parameters_; }

    /// A solution of the same instance, legal under the same motion rule, with as many moves or fewer; the
    /// given one, or as far as it got, when `ptc` says stop.
    /// \pre the solution is valid for the instance
    [[nodiscard]] virtual Solution improve(const Instance &instance, Solution solution,
                                           const TerminationCondition &ptc) const = 0;

    /// Of the algorithm: raised when its answers change, so that campaigns run again what depends on it.
    [[nodiscard]] virtual int version() const { return 1; }

protected:
    template <ParameterType T>
    void declareParam(std::string name, T &slot, std::string range, std::string help)
    {
        parameters_.declare(std::move(name), slot, std::move(range), std::move(help));
    }

private:
    ParameterSet parameters_;
};

} // namespace mrpp

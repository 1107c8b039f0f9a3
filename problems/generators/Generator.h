#pragma once
/// \file
/// Subclass Generator to add a family whose graphs are made from parameters and a seed.
///
/// \code
/// - grid: {side: 8, robots: 20}                                     # as a problem of its own
/// - fg_vr: {graph: {grid: {side: 8}}, robots: {from: 2, to: 20, step: 2}}
/// \endcode
///
/// Every generator is a family of problems, can be the `graph` of the one-factor models (OneFactor.h) and can
/// be called from the command line (`mrppsim generate`). The same parameters and seed give the same graph on
/// every machine.

#include "framework/Problem.h"

namespace mrpp
{

struct Catalog;

class Generator : public Problem
{
public:
    /// Also throws PlanError where parameters do not fit together.
    void configure(const Config &settings, const ProblemContext &context) override;

    /// What this build lacks to make the family's graphs, and how to get it; empty where nothing. A family
    /// that lacks something is refused by configure().
    [[nodiscard]] virtual std::string missing() const { return {}; }

    /// Refuses a number of robots that a graph of the family cannot hold.
    void check() const override;

    /// More vertices or edges than this are refused, before anything is built.
    static constexpr std::int64_t kMaximalSize = 100'000'000;

protected:
    /// Throws InputError where parameters, each in its own range, do not fit together.
    virtual void checkParameters() const {}

    /// Throws InputError above kMaximalSize; `size` is a product that may be beyond whole numbers.
    static void requireSize(double size);
};

/// A new generator; null where the catalog has no family of that name or it is no generator.
[[nodiscard]] std::unique_ptr<Generator> makeGenerator(const Catalog &catalog, std::string_view family);

/// Every generator of the catalog that lacks nothing, in its order.
[[nodiscard]] std::vector<std::string> generatorNames(const Catalog &catalog);

} // namespace mrpp

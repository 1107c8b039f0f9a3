#pragma once
/// \file
/// The one-factor models (section III.B.4 of the MRPPSim paper): a generated graph, of which one thing is
/// swept and all others are kept.
///
/// \code
/// - fg_vr: {graph: {biconnected: {initial_cycle: 5, handles: 4, max_handle_length: 3}},
///           free: {from: 2, to: 10, step: 1}}
/// - fr_vg: {graph: {grid: {side: {from: 2, to: 20, step: 2}}}, occupancy: 0.98}
/// \endcode
///
/// `fg_vr`, fixed graph with variable robots: in each repetition, one graph for the whole sweep; the robots
/// of a smaller case are the first robots of a larger one. `fr_vg`, fixed robots with variable graph: the
/// share (or number) of robots is kept while a parameter of the graph is swept. `graph` names any generator
/// (generators/Generator.h) with its parameters. With `solvable: true` only instances are drawn that have a
/// solution (SolvableInstance.h, which also says what then becomes of smaller and larger cases), with
/// `well_formed: true` only well-formed ones, which have one (WellFormedInstance.h).

#include "problems/generators/Generator.h"

namespace mrpp
{

class OneFactor : public Problem
{
public:
    enum class Varies
    {
        robots, ///< fg_vr
        graph,  ///< fr_vg
    };
    explicit OneFactor(Varies varies);

    void configure(const Config &settings, const ProblemContext &context) override;
    /// The graph's: "grid 8×8".
    [[nodiscard]] std::string name() const override { return generator_->name(); }
    [[nodiscard]] std::string defaults() const override
    {
        return Problem::defaults() + "; " + generator_->defaults();
    }
    [[nodiscard]] bool variesGraph() const override { return varies_ == Varies::graph; }
    [[nodiscard]] std::shared_ptr<const Graph> makeGraph(Seed seed) const override
    {
        return generator_->makeGraph(seed);
    }
    [[nodiscard]] Instance makeInstance(std::shared_ptr<const Graph> graph, std::size_t robots,
                                        Seed seed) const override;

protected:
    bool configureMap(const std::string &parameter, const Config &value) override;

private:
    void chooseGenerator(const std::string &family, const SourceLocation &where, const Config &settings);

    Varies varies_;
    std::string graph_; ///< the generator's name
    bool solvable_ = false;
    bool wellFormed_ = false;
    std::unique_ptr<Generator> generator_;
};

} // namespace mrpp

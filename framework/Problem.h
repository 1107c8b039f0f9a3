#pragma once
/// \file
/// Subclass Problem to add a family of instances.
///
/// A Problem object is one point of a plan after its sweeps are resolved: it knows how to make the graph from
/// a seed, and an instance on that graph from a number of robots and another seed. The default instance is
/// uniformly random (the paper's generator, section III.B.3) inside the graph's largest component.

#include "framework/model/Instance.h"
#include "framework/support/Config.h"
#include "framework/support/Parameters.h"
#include "framework/support/Random.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace mrpp
{

struct Catalog;

/// What a problem may need from around it while it reads its settings.
struct ProblemContext
{
    const Catalog *catalog = nullptr;                    ///< for problems that are made of others
    std::vector<std::filesystem::path> searchPaths = {}; ///< where relative files are looked for, in order

    /// The first place in which the file exists; the path itself, for the error message to come, where none.
    [[nodiscard]] std::filesystem::path resolve(const std::filesystem::path &file) const;
};

/// Three ways to say how many robots there are: how many, how many vertices stay free, or which share of the
/// vertices is occupied.
struct RobotCount
{
    enum class By
    {
        robots,
        free,
        occupancy, ///< robots = ⌊occupancy · vertices⌋
    };
    By by = By::robots;
    double value = 0;

    /// The key of a plan that stands for it: `robots`, `free` or `occupancy`.
    [[nodiscard]] static std::optional<By> key(std::string_view name);

    /// Throws InputError where that is no number of robots that `vertices` can hold.
    [[nodiscard]] std::size_t resolve(std::size_t vertices) const;
};

class Problem
{
public:
    Problem() = default;
    virtual ~Problem() = default;
    Problem(const Problem &) = delete;
    Problem &operator=(const Problem &) = delete;

    [[nodiscard]] ParameterSet &parameters() { return parameters_; }
    [[nodiscard]] const ParameterSet &parameters() const { return parameters_; }

    /// Takes the settings of one sweep point: a map from parameter to value, in which `robots`, `free` or
    /// `occupancy` may stand once if the family takesRobotCount(); or a scalar, the first declared
    /// parameter's value. Throws PlanError at the setting's place. Opens no file: a report must be possible
    /// without them.
    virtual void configure(const Config &settings, const ProblemContext &context);

    /// The name in the `problem` column and in figures: "tree", "AR0603SR", "grid 8×8", ….
    [[nodiscard]] virtual std::string name() const = 0;

    /// Whether the plan says how many robots there are (and not the problem itself).
    [[nodiscard]] virtual bool takesRobotCount() const { return true; }

    /// Whether the plan has to say it, so that one that does not is refused at once; asked after configure().
    [[nodiscard]] virtual bool needsRobotCount() const { return takesRobotCount(); }

    /// Reads and checks every input file, so that nothing runs on malformed input. Throws InputError.
    virtual void check() const {}

    /// Every file that the instances depend on; their contents are part of a run's key.
    [[nodiscard]] virtual std::vector<std::filesystem::path> inputFiles() const { return {}; }

    /// The same seed gives the same graph. Throws InputError where a file cannot be used.
    [[nodiscard]] virtual std::shared_ptr<const Graph> makeGraph(Seed seed) const = 0;

    /// How many robots this point has on that graph. Throws InputError where they do not fit.
    [[nodiscard]] virtual std::size_t robotCount(const Graph &graph) const;

    /// The same seed gives the same instance, and the robots of a smaller one are the first robots of a
    /// larger one. Throws InputError where the graph cannot hold so many.
    [[nodiscard]] virtual Instance makeInstance(std::shared_ptr<const Graph> graph, std::size_t robots,
                                                Seed seed) const;

    /// Of the family: raised when the same settings and seeds begin to give other instances.
    [[nodiscard]] virtual int version() const { return 1; }

    /// What configure() did not say: the version, and every parameter that has its default value. A part of a
    /// run's key, so that a changed default runs again.
    [[nodiscard]] virtual std::string defaults() const;

    /// Whether the graph is drawn by chance; else it is the same for every seed, and made once.
    [[nodiscard]] virtual bool drawsGraph() const { return true; }

    /// Whether the robots are drawn by chance. Where neither they nor the graph are, all repetitions are
    /// copies of one instance.
    [[nodiscard]] virtual bool drawsInstance() const { return true; }

    /// True where the swept variable changes the graph (its sweep is then preferred to one over robots).
    [[nodiscard]] virtual bool variesGraph() const { return false; }

    /// The settings without the number of robots, canonical: graph and instance seeds derive from it, so that
    /// all points of a sweep over robots share one graph and draw their robots from one sequence.
    [[nodiscard]] const std::string &identity() const { return identity_; }

    [[nodiscard]] const std::optional<RobotCount> &robots() const { return robots_; }

protected:
    template <ParameterType T>
    void declareParam(std::string name, T &slot, std::string range, std::string help)
    {
        parameters_.declare(std::move(name), slot, std::move(range), std::move(help));
    }
    [[nodiscard]] const ProblemContext &context() const { return context_; }

    /// Called by configure() where a parameter's value is a map: for families with parameters that are more
    /// than one value. Returns false where this parameter takes none, which is then an error.
    virtual bool configureMap(const std::string & /*parameter*/, const Config & /*value*/) { return false; }

private:
    ParameterSet parameters_;
    ProblemContext context_;
    std::optional<RobotCount> robots_;
    std::string identity_;
};

/// Uniformly random starts and goals: `robots` distinct starts and, drawn independently, as many distinct
/// goals, all in the graph's largest connected component (the one with the smallest vertex where several are
/// largest). The robots of a smaller number are the first of a larger one. Throws InputError where the
/// component is too small. O(V + E).
[[nodiscard]] Instance randomInstance(std::shared_ptr<const Graph> graph, std::size_t robots, Seed seed);

} // namespace mrpp

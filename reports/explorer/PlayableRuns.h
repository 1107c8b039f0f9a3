#pragma once
/// \file
/// The solutions that a page can play, packed, with the graphs and instances that they need, each only once.

#include "framework/model/Instance.h"
#include "framework/model/Schedule.h"
#include "framework/model/Solution.h"
#include "framework/run/RunRecord.h"

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace mrpp
{

/// Graph, starts and goals. All texts are packedText().
struct PlayableCase
{
    std::string name;
    std::size_t graph = 0; ///< index into PlayableRuns::graphs()
    std::size_t robots = 0;
    std::string robotsText; ///< starts and goals: for each robot the differences to the robot before it
};

struct PlayableRun
{
    std::size_t run = 0;      ///< which row of the results
    std::size_t inCase = 0;   ///< index into PlayableRuns::cases()
    bool isSequential = true; ///< one action a step, so that condensing it makes sense
    std::string solution;     ///< packSolution(); of a schedule the moves of a step stand as a rotation
    std::string optimized;    ///< the same; empty where there is none
};

class PlayableRuns
{
public:
    /// \param limit bytes that the texts may have together
    explicit PlayableRuns(std::size_t limit) : limit_(limit) {}

    /// Takes the solution in where it still fits; says whether it did. \param caseName the same name, the
    /// same instance
    bool add(std::size_t run, const std::string &caseName, const Instance &instance, const Solution &solution,
             const Solution *optimized = nullptr);
    bool add(std::size_t run, const std::string &caseName, const Instance &instance,
             const Schedule &schedule);

    [[nodiscard]] std::size_t size() const { return size_; }                         ///< bytes of all texts
    [[nodiscard]] const std::vector<std::string> &graphs() const { return graphs_; } ///< graphBlock()
    [[nodiscard]] const std::vector<PlayableCase> &cases() const { return cases_; }
    [[nodiscard]] const std::vector<PlayableRun> &runs() const { return runs_; }

private:
    bool add(PlayableRun run, const std::string &caseName, const Instance &instance);

    std::size_t limit_;
    std::size_t size_ = 0;
    std::vector<std::string> graphs_;
    std::vector<PlayableCase> cases_;
    std::vector<PlayableRun> runs_;
    std::map<std::string, std::size_t> graphNumbers_;
    std::map<std::string, std::size_t> caseNumbers_;
};

} // namespace mrpp

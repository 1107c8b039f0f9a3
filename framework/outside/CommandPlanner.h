#pragma once
/// \file
/// An outside program as a planner: gets the instance as files, answers with a file, and is checked like all
/// others.

#include "framework/FileExchange.h"
#include "framework/LateAnswer.h"
#include "framework/Planner.h"
#include "framework/outside/OutsideCommand.h"
#include "framework/system/OutsideProgram.h"
#include "framework/system/TemporaryFolder.h"

#include <map>
#include <memory>
#include <string>

namespace mrpp
{

/// Every place of the command that the program does not fill itself is a parameter (text). So is what else
/// the plan says of the command (commandProperties()), for the records: setting it changes nothing.
///
/// setup() writes the files that the command names, and makes the folder in which the program runs
/// (makeWorkingFolder()); solve() runs it, and collect() reads its answer:
///  * exit code 0 and an answer: `solved`, until the validator says otherwise;
///  * 0 and no answer, or one that says that none was found: `gave_up`, or `timeout` where the program ended
///  at
///    the limit that it was told;
///  * 0 and an answer that cannot be read, or has impossible moves: `invalid`;
///  * another exit code: what the command says that it means, else `crash`, as for a signal;
///  * out of time: it may go on for a second, then its process group is killed.
/// An instance that the wanted format cannot hold is `unsupported`. Where files cannot be written, or the
/// program cannot be started, that is a HarnessError: the program did nothing wrong. So it is where the
/// program failed and the temporary folder has no room left, unless the program filled it.
class CommandPlanner final : public Planner, public LateAnswer
{
public:
    CommandPlanner(OutsideCommand command, std::shared_ptr<const FileExchange> files);

    void setup() override;
    PlannerStatus solve(const TerminationCondition &ptc) override;
    PlannerStatus collect() override;
    void clear() override;
    /// Whether the command is told a seed.
    [[nodiscard]] bool usesChance() const override { return uses("seed"); }

    /// The last 2 KiB of what the program wrote: to its standard output where that was no good answer, and to
    /// its standard error.
    [[nodiscard]] const std::string &outputTail() const { return outputTail_; }
    [[nodiscard]] const std::string &errorTail() const { return errorTail_; }

private:
    [[nodiscard]] bool uses(const std::string &place) const;
    [[nodiscard]] std::string valueOf(const std::string &place, double secondsLeft) const;
    [[nodiscard]] std::filesystem::path fileOf(const std::string &place) const;
    void writeInput() const;
    [[nodiscard]] double ownLimit(double secondsLeft) const;
    [[nodiscard]] ProgramEnd runIt(const TerminationCondition &ptc);
    PlannerStatus run(const TerminationCondition &ptc);
    PlannerStatus gaveUp(const std::string &how);
    PlannerStatus readAnswer();
    [[nodiscard]] std::string missingAnswer() const;
    PlannerStatus unlessFull(PlannerStatus status);

    OutsideCommand command_;
    std::shared_ptr<const FileExchange> files_;
    std::map<std::string, std::string> values_; ///< of its parameters
    std::unique_ptr<TemporaryFolder> folder_;
    std::string refusal_;  ///< why the instance cannot be written
    std::string ownLimit_; ///< " at its limit of 9 s" where the program ended there
    std::string outputTail_;
    std::string errorTail_;
};

} // namespace mrpp

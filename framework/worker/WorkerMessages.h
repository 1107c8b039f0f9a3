#pragma once
/// \file
/// What a campaign and its worker processes say to each other over a socket: messages of a kind and bytes,
/// each preceded by its length.
///
///     campaign → worker: plan, then any number of: run
///     worker → campaign: ready; for each run: phase …, finished; or error, after which the worker ends

#include "framework/plan/BenchmarkPlan.h"
#include "framework/run/Executor.h"
#include "framework/run/InputWatch.h"
#include "framework/run/RunPlanner.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace mrpp
{

enum class MessageKind : std::uint8_t
{
    plan = 1, ///< PlanSource
    ready,    ///< nothing: the plan is read
    run,      ///< RunSpec
    phase,    ///< PhaseNote
    finished, ///< RunResult without its instance
    error,    ///< text: an input error that ends the campaign
};

struct Message
{
    MessageKind kind = MessageKind::error;
    std::vector<std::uint8_t> bytes;
};

/// A plan as it is read again in the worker.
struct PlanSource
{
    std::string text;
    std::filesystem::path file;
    std::vector<std::filesystem::path> mapFolders;
    InputWatch::Hashes inputs = {}; ///< what its input files have to hold
};

/// Which part of a run begins, and what is known of the run by then.
struct PhaseNote
{
    RunPhase phase = RunPhase::setup;
    RunRecord record;
};

[[nodiscard]] Message toMessage(const PlanSource &plan);
/// \param addedMetrics whether what plugins added is to be measured
[[nodiscard]] Message toMessage(const RunSpec &spec, bool addedMetrics);
[[nodiscard]] Message toMessage(const PhaseNote &note);
[[nodiscard]] Message toMessage(const RunResult &result);
[[nodiscard]] Message errorMessage(const std::string &text);

/// Nothing where the bytes are not what the kind says.
[[nodiscard]] std::optional<PlanSource> toPlan(const Message &message);
[[nodiscard]] std::optional<RunSpec> toSpec(const Message &message);
[[nodiscard]] bool wantsAddedMetrics(const Message &run);
[[nodiscard]] std::optional<PhaseNote> toPhase(const Message &message);
[[nodiscard]] std::optional<RunResult> toResult(const Message &message);
[[nodiscard]] std::string toErrorText(const Message &message);

/// Writes all of it; false where the other end is gone.
bool send(int socket, const Message &message);

/// Puts messages together from what arrives piece by piece.
class MessageBuffer
{
public:
    /// Reads what has arrived, waiting for at least one byte; false at the end, or on an error.
    bool readFrom(int socket);

    /// The next whole message, if there is one.
    [[nodiscard]] std::optional<Message> next();

private:
    std::vector<std::uint8_t> bytes_;
    std::size_t begin_ = 0; ///< of what is not yet taken
};

} // namespace mrpp

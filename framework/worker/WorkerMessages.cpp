#include "framework/worker/WorkerMessages.h"

#include "framework/store/SolutionCodec.h"
#include "framework/support/Bytes.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <sys/socket.h>
#include <sys/types.h>

namespace mrpp
{

namespace
{

constexpr std::size_t kHeader = sizeof(std::uint64_t) + 1; // length, kind

void write(ByteWriter &writer, const Value &value)
{
    writer.byte(static_cast<std::uint8_t>(value.index()));
    if (const auto *integer = std::get_if<std::int64_t>(&value))
        writer.number(static_cast<std::uint64_t>(*integer));
    else if (const auto *real = std::get_if<double>(&value))
        writer.real(*real);
    else if (const auto *text = std::get_if<std::string>(&value))
        writer.text(*text);
}

Value readValue(ByteReader &reader)
{
    switch (reader.byte())
    {
    case 1:
        return static_cast<std::int64_t>(reader.number());
    case 2:
        return reader.real();
    case 3:
        return reader.text();
    default:
        return {};
    }
}

/// The columns in their order, then those of events by name.
void write(ByteWriter &writer, const RunRecord &record)
{
    for (const RunColumn &column : runColumns())
        write(writer, column.get(record));
    writer.number(record.extra.size());
    for (const auto &[name, value] : record.extra)
    {
        writer.text(name);
        write(writer, value);
    }
}

RunRecord readRecord(ByteReader &reader)
{
    RunRecord record;
    for (const RunColumn &column : runColumns())
        column.set(record, readValue(reader));
    for (std::uint64_t left = reader.number(); left > 0 && reader.good(); --left)
    {
        std::string name = reader.text();
        record.extra.emplace(std::move(name), readValue(reader));
    }
    return record;
}

void write(ByteWriter &writer, const Progress &progress)
{
    writer.number(progress.names.size());
    for (const std::string &name : progress.names)
        writer.text(name);
    writer.number(progress.samples.size());
    for (const Progress::Sample &sample : progress.samples)
    {
        writer.real(sample.time);
        for (const double value : sample.values)
            writer.real(value);
    }
}

Progress readProgress(ByteReader &reader)
{
    Progress progress;
    for (std::uint64_t left = reader.number(); left > 0 && reader.good(); --left)
        progress.names.push_back(reader.text());
    for (std::uint64_t left = reader.number(); left > 0 && reader.good(); --left)
    {
        Progress::Sample sample;
        sample.time = reader.real();
        for (std::size_t i = 0; i < progress.names.size(); ++i)
            sample.values.push_back(reader.real());
        progress.samples.push_back(std::move(sample));
    }
    return progress;
}

std::optional<Solution> readSolution(ByteReader &reader)
{
    return unpackSolution(reader.block());
}

} // namespace

Message toMessage(const PlanSource &plan)
{
    ByteWriter writer;
    writer.text(plan.text);
    writer.text(plan.file.string());
    writer.number(plan.mapFolders.size());
    for (const std::filesystem::path &folder : plan.mapFolders)
        writer.text(folder.string());
    writer.number(plan.inputs.size());
    for (const auto &[file, hash] : plan.inputs)
    {
        writer.text(file);
        writer.text(hash);
    }
    return {MessageKind::plan, writer.take()};
}

std::optional<PlanSource> toPlan(const Message &message)
{
    ByteReader reader(message.bytes);
    PlanSource plan;
    plan.text = reader.text();
    plan.file = reader.text();
    for (std::uint64_t left = reader.number(); left > 0 && reader.good(); --left)
        plan.mapFolders.emplace_back(reader.text());
    for (std::uint64_t left = reader.number(); left > 0 && reader.good(); --left)
    {
        std::string file = reader.text();
        plan.inputs.emplace(std::move(file), reader.text());
    }
    return message.kind == MessageKind::plan && reader.good() ? std::optional(plan) : std::nullopt;
}

Message toMessage(const RunSpec &spec, bool addedMetrics)
{
    ByteWriter writer;
    writer.byte(addedMetrics ? 1 : 0);
    writer.number(spec.point);
    writer.number(spec.planner);
    writer.number(static_cast<std::uint64_t>(spec.repetition));
    writer.number(spec.graphSeed);
    writer.number(spec.instanceSeed);
    writer.number(spec.plannerSeed);
    writer.text(spec.caseId);
    writer.text(spec.runKey);
    return {MessageKind::run, writer.take()};
}

std::optional<RunSpec> toSpec(const Message &message)
{
    ByteReader reader(message.bytes);
    RunSpec spec;
    (void)reader.byte(); // see wantsAddedMetrics()
    spec.point = reader.number();
    spec.planner = reader.number();
    spec.repetition = static_cast<std::int64_t>(reader.number());
    spec.graphSeed = reader.number();
    spec.instanceSeed = reader.number();
    spec.plannerSeed = reader.number();
    spec.caseId = reader.text();
    spec.runKey = reader.text();
    return message.kind == MessageKind::run && reader.good() ? std::optional(spec) : std::nullopt;
}

bool wantsAddedMetrics(const Message &run)
{
    return ByteReader(run.bytes).byte() != 0;
}

Message toMessage(const PhaseNote &note)
{
    ByteWriter writer;
    writer.byte(static_cast<std::uint8_t>(note.phase));
    write(writer, note.record);
    return {MessageKind::phase, writer.take()};
}

std::optional<PhaseNote> toPhase(const Message &message)
{
    ByteReader reader(message.bytes);
    PhaseNote note;
    note.phase = static_cast<RunPhase>(reader.byte());
    note.record = readRecord(reader);
    return message.kind == MessageKind::phase && reader.good() ? std::optional(note) : std::nullopt;
}

Message toMessage(const RunResult &result)
{
    ByteWriter writer;
    write(writer, result.record);
    write(writer, result.progress);
    writer.block(packSolution(result.solution));
    writer.block(packSolution(result.optimized));
    for (const bool flag : {result.startedProcesses, result.paused, result.lastOfWorker})
        writer.byte(flag ? 1 : 0);
    return {MessageKind::finished, writer.take()};
}

std::optional<RunResult> toResult(const Message &message)
{
    ByteReader reader(message.bytes);
    RunResult result;
    result.record = readRecord(reader);
    result.progress = readProgress(reader);
    std::optional<Solution> solution = readSolution(reader);
    std::optional<Solution> optimized = readSolution(reader);
    for (bool *flag : {&result.startedProcesses, &result.paused, &result.lastOfWorker})
        *flag = reader.byte() != 0;
    if (message.kind != MessageKind::finished || !solution || !optimized || !reader.good())
        return std::nullopt;
    result.solution = std::move(*solution);
    result.optimized = std::move(*optimized);
    return result;
}

Message errorMessage(const std::string &text)
{
    ByteWriter writer;
    writer.text(text);
    return {MessageKind::error, writer.take()};
}

std::string toErrorText(const Message &message)
{
    return ByteReader(message.bytes).text();
}

bool send(int socket, const Message &message)
{
    std::array<std::uint8_t, kHeader> header{};
    const std::uint64_t size = message.bytes.size();
    std::memcpy(header.data(), &size, sizeof size); // both ends are on one machine
    header.back() = static_cast<std::uint8_t>(message.kind);
    std::vector<std::uint8_t> all(header.begin(), header.end());
    all.insert(all.end(), message.bytes.begin(), message.bytes.end());
    for (std::size_t sent = 0; sent < all.size();)
    {
        const ssize_t count = ::send(socket, all.data() + sent, all.size() - sent, MSG_NOSIGNAL);
        if (count < 0 && errno == EINTR)
            continue;
        if (count <= 0)
            return false;
        sent += static_cast<std::size_t>(count);
    }
    return true;
}

bool MessageBuffer::readFrom(int socket)
{
    constexpr std::size_t kPiece = std::size_t{64} << 10;
    const std::size_t before = bytes_.size();
    bytes_.resize(before + kPiece);
    ssize_t count = -1;
    do
        count = ::recv(socket, bytes_.data() + before, kPiece, 0);
    while (count < 0 && errno == EINTR);
    bytes_.resize(before + static_cast<std::size_t>(std::max<ssize_t>(count, 0)));
    return count > 0;
}

std::optional<Message> MessageBuffer::next()
{
    if (bytes_.size() - begin_ < kHeader)
        return std::nullopt;
    std::uint64_t size = 0;
    std::memcpy(&size, bytes_.data() + begin_, sizeof size);
    if (bytes_.size() - begin_ - kHeader < size)
        return std::nullopt;
    const auto from = bytes_.begin() + static_cast<std::ptrdiff_t>(begin_ + kHeader);
    Message message{static_cast<MessageKind>(bytes_[begin_ + kHeader - 1]),
                    {from, from + static_cast<std::ptrdiff_t>(size)}};
    begin_ += kHeader + size;
    if (begin_ == bytes_.size())
    {
        bytes_.clear();
        begin_ = 0;
    }
    return message;
}

} // namespace mrpp

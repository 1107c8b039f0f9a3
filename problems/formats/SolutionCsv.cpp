#include "problems/formats/SolutionCsv.h"

#include "framework/support/Config.h"
#include "framework/system/File.h"
#include "problems/formats/FormatId.h"
#include "problems/formats/support/TextReader.h"

#include <array>
#include <charconv>
#include <string>

namespace mrpp
{

namespace
{

constexpr std::string_view kHeading = "step,robot,from,to";

void readHeading(TextReader &reader)
{
    const auto line = reader.next();
    std::string heading(line.value_or("")); // R writes names in quotation marks
    std::erase(heading, '"');
    LineCursor cursor(heading);
    for (const char *name : {"step", ",", "robot", ",", "from", ",", "to"})
        if (!cursor.take(name))
            reader.fail(1, cursor.column(), "expected the heading '" + std::string(kHeading) + "'");
    if (!cursor.atEnd())
        reader.fail(1, cursor.column(),
                    "expected nothing behind the heading '" + std::string(kHeading) + "'");
}

TimedMove readRow(const TextReader &reader, std::string_view line)
{
    constexpr std::array<const char *, 4> names = {"step", "robot", "from", "to"};
    std::array<std::int64_t, 4> values{};
    LineCursor cursor(line);
    for (std::size_t i = 0; i < values.size(); ++i)
    {
        if (i > 0 && !cursor.take(","))
            reader.fail(cursor.column(), "the row has " + std::to_string(i) + (i == 1 ? " cell" : " cells") +
                                             "; expected four, " + std::string(kHeading));
        const std::size_t column = cursor.column();
        std::string_view text = cursor.until(",");
        if (text.size() > 1 && text.front() == '"' && text.back() == '"')
            text = text.substr(1, text.size() - 2);
        const auto value = parseInteger(text);
        if (!value)
            reader.fail(column, inQuotes(text) + " is no " + names[i] + "; expected a whole number");
        values[i] = *value;
    }
    if (!cursor.atEnd())
        reader.fail(cursor.column(), "the row has more than four cells; expected " + std::string(kHeading));
    return {values[0], values[1], values[2], values[3]};
}

/// Appends rows without streams or formatting: a solution may have 10^8 of them.
class RowWriter
{
public:
    explicit RowWriter(std::size_t rows)
    {
        constexpr std::size_t usualRow = 24;
        text_.reserve(kHeading.size() + 1 + usualRow * rows);
        text_.append(kHeading).push_back('\n');
    }

    void add(std::size_t step, const Move &move)
    {
        addNumber(step, ',');
        addNumber(move.robot, ',');
        addNumber(move.from, ',');
        addNumber(move.to, '\n');
    }

    [[nodiscard]] std::string take() { return std::move(text_); }

private:
    void addNumber(std::uint64_t value, char behind)
    {
        std::array<char, 20> digits; // enough for 2^64
        text_.append(digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr);
        text_.push_back(behind);
    }

    std::string text_;
};

} // namespace

SolutionRows readSolutionCsv(const std::filesystem::path &file)
{
    return parseSolutionCsv(readFile(file), file.string());
}

namespace
{

SolutionRows readRows(std::string_view text, const std::string &file)
{
    TextReader reader(text, file);
    SolutionRows rows;
    rows.file = file;
    readHeading(reader);
    std::size_t blankLine = 0;
    while (const auto line = reader.next())
    {
        if (trimmed(*line).empty())
        {
            blankLine = blankLine == 0 ? reader.line() : blankLine;
            continue;
        }
        if (blankLine != 0)
            reader.fail(blankLine, 1, "a blank line between rows; expected " + std::string(kHeading));
        rows.moves.push_back(readRow(reader, *line));
    }
    return rows;
}

} // namespace

SolutionRows parseSolutionCsv(std::string_view text, const std::string &file)
{
    return readAs(FormatId::solutionCsv, text, file, [&] { return readRows(text, file); });
}

std::string formatSolutionCsv(const Solution &solution)
{
    RowWriter writer(solution.pathLength());
    std::size_t step = 0;
    solution.forEachAction(
        [&](std::span<const Move> action)
        {
            for (const Move &move : action)
                writer.add(step, move);
            ++step;
        });
    return writer.take();
}

std::string formatSolutionCsv(const Schedule &schedule)
{
    RowWriter writer(schedule.pathLength());
    std::size_t written = 0;
    for (std::size_t s = 0; s < schedule.makespan(); ++s)
    {
        for (const Move &move : schedule.step(s))
            writer.add(written, move);
        written +=
            schedule.step(s).empty() ? 0 : 1; // a step in which everybody waits leaves no row, and no gap
    }
    return writer.take();
}

} // namespace mrpp

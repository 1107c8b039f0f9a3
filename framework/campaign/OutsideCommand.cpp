#include "framework/campaign/OutsideCommand.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <unistd.h>
#include <utility>

namespace mrpp
{

namespace
{

bool isNameCharacter(char c)
{
    return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_';
}

/// The name of the place that begins here; empty where none does.
std::string_view placeAt(std::string_view text)
{
    if (!text.starts_with('{'))
        return {};
    const auto end = std::find_if_not(text.begin() + 1, text.end(), isNameCharacter);
    const bool closed = end != text.end() && *end == '}';
    return closed ? text.substr(1, static_cast<std::size_t>(end - text.begin()) - 1) : std::string_view();
}

/// Calls `text(piece)` and `place(name)` in their order.
template <class Text, class Place>
void walk(std::string_view word, Text &&text, Place &&place)
{
    while (!word.empty())
    {
        if (const auto literal = word.starts_with("{{") ? placeAt(word.substr(1)) : std::string_view();
            !literal.empty() && word.substr(literal.size() + 3).starts_with('}'))
        {
            text(word.substr(1, literal.size() + 2));
            word.remove_prefix(literal.size() + 4);
        }
        else if (const std::string_view name = placeAt(word); !name.empty())
        {
            place(std::string(name));
            word.remove_prefix(name.size() + 2);
        }
        else
        {
            text(word.substr(0, 1));
            word.remove_prefix(1);
        }
    }
}

/// The words without places, but for a program that is looked up in PATH.
std::vector<std::string> plainWords(const OutsideCommand &command)
{
    std::vector<std::string> plain;
    for (const std::string &word : command.words)
    {
        const bool isLookedUp = &word == &command.words.front() && word.find('/') == std::string::npos;
        if (!isLookedUp && placesIn(std::span(&word, 1)).empty())
            plain.push_back(word);
    }
    return plain;
}

bool isExecutable(const std::filesystem::path &file)
{
    std::error_code error;
    return std::filesystem::is_regular_file(file, error) && ::access(file.c_str(), X_OK) == 0;
}

bool isInPath(const std::string &program)
{
    const char *variable = std::getenv("PATH");
    std::string_view folders = variable == nullptr ? "/bin:/usr/bin" : variable;
    while (!folders.empty())
    {
        const std::size_t end = std::min(folders.find(':'), folders.size());
        if (isExecutable(std::filesystem::path(folders.substr(0, end)) / program))
            return true;
        folders.remove_prefix(std::min(end + 1, folders.size()));
    }
    return false;
}

/// What is wrong with the first line of an executable file; empty where nothing is.
std::string whyNotStarted(const std::filesystem::path &file)
{
    constexpr std::size_t kLine = 256; // as much as the system reads of it
    std::string begin(kLine, '\0');
    std::ifstream stream(file, std::ios::binary);
    stream.read(begin.data(), static_cast<std::streamsize>(begin.size()));
    begin.resize(static_cast<std::size_t>(stream.gcount()));
    const bool isText = begin.find('\0') == std::string::npos && !begin.starts_with("\x7f" "ELF");
    if (!stream.eof() && stream.fail())
        return {};
    if (!begin.starts_with("#!"))
        return isText ? "it has no first line '#!…' that says what runs it; add one, or write what runs it ('sh " +
                            file.filename().string() + "')"
                      : "";
    const std::string line = begin.substr(0, begin.find('\n'));
    if (line.ends_with('\r'))
        return "its first line ends as in Windows files (CR LF); convert it, as with: sed -i 's/\\r$//' " +
               file.filename().string();
    const std::size_t start = std::min(line.find_first_not_of(" \t", 2), line.size());
    const std::string interpreter = line.substr(start, line.find_first_of(" \t", start) - start);
    std::error_code error;
    return std::filesystem::exists(interpreter, error) ? ""
                                                       : "its first line names '" + interpreter +
                                                             "', which is not there";
}

} // namespace

std::vector<std::string> splitCommand(std::string_view text)
{
    std::vector<std::string> words;
    bool inWord = false;
    char quote = 0;
    for (std::size_t i = 0; i < text.size(); ++i)
    {
        const char c = text[i];
        const bool isBlank = c == ' ' || c == '\t' || c == '\n';
        if (quote == 0 && isBlank)
        {
            inWord = false;
            continue;
        }
        if (!std::exchange(inWord, true))
            words.emplace_back();
        if (quote == 0 && (c == '\'' || c == '"'))
            quote = c;
        else if (quote != 0 && c == quote)
            quote = 0;
        else if (c == '\\' && quote != '\'' && i + 1 < text.size())
            words.back() += text[++i];
        else
            words.back() += c;
    }
    if (quote != 0)
        throw InputError(std::string("a quote ") + quote + " is not closed");
    if (words.empty() || words.front().empty())
        throw InputError("there is no program in it");
    return words;
}

std::vector<std::string> placesIn(std::span<const std::string> words)
{
    std::vector<std::string> names;
    for (const std::string &word : words)
        walk(
            word, [](std::string_view) {},
            [&names](const std::string &name)
            {
                if (std::find(names.begin(), names.end(), name) == names.end())
                    names.push_back(name);
            });
    return names;
}

std::string fillPlaces(std::string_view word, const std::function<std::string(const std::string &)> &valueOf)
{
    std::string filled;
    walk(
        word, [&filled](std::string_view piece) { filled += piece; },
        [&](const std::string &name) { filled += valueOf(name); });
    return filled;
}

const std::vector<std::string> &ownPlaces()
{
    static const std::vector<std::string> names = {"graph",  "instance",   "map",  "scen",
                                                   "robots", "time_limit", "seed", "output"};
    return names;
}

const std::vector<std::string> &commandProperties()
{
    static const std::vector<std::string> names = {"command",         "format", "graph_format",
                                                   "instance_format", "motion", "exit_codes"};
    return names;
}

std::vector<std::filesystem::path> filesOf(const OutsideCommand &command)
{
    std::vector<std::filesystem::path> files;
    std::error_code error;
    for (const std::string &word : plainWords(command))
        if (std::filesystem::is_regular_file(command.folder / word, error))
            files.push_back(command.folder / word);
    return files;
}

void checkExecutable(const OutsideCommand &command)
{
    const std::string &program = command.words.front();
    const bool isPath = program.find('/') != std::string::npos;
    const std::filesystem::path file = command.folder / program;
    std::error_code error;
    if (isPath && isExecutable(file))
    {
        if (const std::string why = whyNotStarted(file); !why.empty())
            throw PlanError(command.where, "'" + program + "' cannot be started: " + why);
        return;
    }
    if (!isPath && isInPath(program))
        return;
    throw PlanError(command.where,
                    !isPath ? "there is no program '" + program +
                                  "' in PATH; install it, or write its path ('./" + program + "')"
                    : std::filesystem::exists(file, error)
                        ? "'" + program +
                              "' is no executable file; make it one (chmod +x), or write what runs it"
                        : "there is no program '" + program + "'; its path starts at the plan's folder");
}

} // namespace mrpp

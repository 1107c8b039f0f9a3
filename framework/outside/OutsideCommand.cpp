#include "framework/outside/OutsideCommand.h"

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

/// What may stand in braces that look like a place.
bool isDoubtfulCharacter(char c)
{
    return isNameCharacter(c) || (c >= 'A' && c <= 'Z') || c == '-' || c == '.' || c == ' ';
}

struct Piece
{
    enum class Kind
    {
        text,
        place,
        doubtful, ///< text that looks like a place
    };
    Kind kind = Kind::text;
    std::string text; ///< of places without the braces
};

/// What stands in the braces that begin here; empty where none do.
std::string_view bracedAt(std::string_view text)
{
    if (!text.starts_with('{'))
        return {};
    const auto end = std::find_if_not(text.begin() + 1, text.end(), isDoubtfulCharacter);
    const bool closed = end != text.end() && *end == '}';
    return closed ? text.substr(1, static_cast<std::size_t>(end - text.begin()) - 1) : std::string_view();
}

/// Words without blanks and dots, or with them where that is a place misspelt.
bool looksLikePlace(std::string_view braced)
{
    if (braced.find_first_of(" .") == std::string_view::npos)
        return braced.front() != '-' && !(braced.front() >= '0' && braced.front() <= '9');
    const auto &own = ownPlaces();
    return std::find(own.begin(), own.end(), asPlaceName(braced)) != own.end();
}

std::vector<Piece> piecesOf(std::string_view word)
{
    std::vector<Piece> pieces;
    const auto addText = [&pieces](std::string_view text)
    {
        if (pieces.empty() || pieces.back().kind != Piece::Kind::text)
            pieces.push_back({});
        pieces.back().text += text;
    };
    for (std::size_t i = 0; i < word.size();)
    {
        const std::string_view rest = word.substr(i);
        const std::string_view escaped =
            rest.starts_with("{{") ? bracedAt(rest.substr(1)) : std::string_view();
        const std::string_view braced = bracedAt(rest);
        if (!escaped.empty() && rest.substr(escaped.size() + 3).starts_with('}'))
        {
            addText(rest.substr(1, escaped.size() + 2));
            i += escaped.size() + 4;
        }
        else if (!braced.empty() && std::all_of(braced.begin(), braced.end(), isNameCharacter))
        {
            pieces.push_back({Piece::Kind::place, std::string(braced)});
            i += braced.size() + 2;
        }
        else if (!braced.empty() && (i == 0 || word[i - 1] != '$') && looksLikePlace(braced))
        {
            pieces.push_back({Piece::Kind::doubtful, std::string(braced)});
            i += braced.size() + 2;
        }
        else
        {
            addText(rest.substr(0, 1));
            ++i;
        }
    }
    return pieces;
}

/// The texts of the pieces of that kind, each once, in their order.
std::vector<std::string> textsOf(std::span<const std::string> words, Piece::Kind kind)
{
    std::vector<std::string> texts;
    for (const std::string &word : words)
        for (const Piece &piece : piecesOf(word))
            if (piece.kind == kind && std::find(texts.begin(), texts.end(), piece.text) == texts.end())
                texts.push_back(piece.text);
    return texts;
}

bool isLookedUp(const OutsideCommand &command, std::size_t index)
{
    return index == 0 && command.words.front().find('/') == std::string::npos;
}

/// What parts the words that may name files.
constexpr std::string_view kSeparators = " \t\n'\"=:,;@()<>|&";

/// What a word may name: itself, and its parts.
std::vector<std::string_view> candidatesOf(std::string_view word)
{
    std::vector<std::string_view> candidates = {word};
    for (std::size_t begin = 0; begin <= word.size();)
    {
        const std::size_t end = std::min(word.find_first_of(kSeparators, begin), word.size());
        candidates.push_back(word.substr(begin, end - begin));
        candidates.push_back(word.substr(begin)); // names may hold such signs, too
        begin = end + 1;
    }
    for (std::size_t i = candidates.size(); i-- > 0;)
        if (candidates[i].size() > 2 && candidates[i].front() == '-')
            candidates.push_back(candidates[i].substr(2)); // behind an option's letter
    return candidates;
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
    const bool isText = begin.find('\0') == std::string::npos && !begin.starts_with("\x7f"
                                                                                    "ELF");
    if (!stream.eof() && stream.fail())
        return {};
    if (!begin.starts_with("#!"))
        return isText ? "it has no first line '#!…' that says what runs it; add one, or write what runs it "
                        "('sh " +
                            file.filename().string() + "')"
                      : "";
    const std::string line = begin.substr(0, begin.find('\n'));
    if (line.ends_with('\r'))
        return "its first line ends as in Windows files (CR LF); convert it, as with: sed -i 's/\\r$//' " +
               file.filename().string();
    const std::size_t start = std::min(line.find_first_not_of(" \t", 2), line.size());
    const std::string interpreter = line.substr(start, line.find_first_of(" \t", start) - start);
    std::error_code error;
    return std::filesystem::exists(interpreter, error)
               ? ""
               : "its first line names '" + interpreter + "', which is not there";
}

} // namespace

std::vector<std::string> splitCommand(std::string_view text)
{
    std::vector<std::string> words;
    bool inWord = false;
    char quote = 0;
    const auto add = [&](std::string_view more)
    {
        if (!std::exchange(inWord, true))
            words.emplace_back();
        words.back() += more;
    };
    for (std::size_t i = 0; i < text.size(); ++i)
    {
        const char c = text[i];
        const std::string_view next = text.substr(i + 1);
        const bool escapes = c == '\\' && quote != '\'' && !next.empty();
        const bool isBlank = c == ' ' || c == '\t' || c == '\n' || c == '\r';
        if (escapes && (next.starts_with('\n') || next.starts_with("\r\n")))
            i += next.starts_with('\n') ? 1 : 2; // the lines are joined
        else if (escapes &&
                 (quote == 0 || std::string_view("$`\"\\").find(next.front()) != std::string_view::npos))
            add(text.substr(++i, 1));
        else if (quote == 0 && isBlank)
            inWord = false;
        else if (quote == 0 && (c == '\'' || c == '"'))
        {
            quote = c;
            add("");
        }
        else if (quote != 0 && c == quote)
            quote = 0;
        else
            add(text.substr(i, 1));
    }
    if (quote != 0)
        throw InputError(std::string("a quote ") + quote + " is not closed");
    if (words.empty() || words.front().empty())
        throw InputError("there is no program in it");
    return words;
}

std::vector<std::string> placesIn(std::span<const std::string> words)
{
    return textsOf(words, Piece::Kind::place);
}

std::vector<std::string> doubtfulPlacesIn(std::span<const std::string> words)
{
    return textsOf(words, Piece::Kind::doubtful);
}

std::string asPlaceName(std::string_view text)
{
    const std::size_t begin = std::min(text.find_first_not_of(' '), text.size());
    text = text.substr(begin, text.find_last_not_of(' ') + 1 - begin);
    std::string name;
    for (const char c : text)
        name += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : isNameCharacter(c) ? c : '_';
    return name;
}

std::string fillPlaces(std::string_view word, const std::function<std::string(const std::string &)> &valueOf)
{
    std::string filled;
    for (const Piece &piece : piecesOf(word))
        filled += piece.kind == Piece::Kind::place      ? valueOf(piece.text)
                  : piece.kind == Piece::Kind::doubtful ? "{" + piece.text + "}"
                                                        : piece.text;
    return filled;
}

const std::vector<std::string> &ownPlaces()
{
    static const std::vector<std::string> names = {"graph",  "instance",   "map",          "scen",
                                                   "robots", "time_limit", "time_limit_s", "time_limit_ms",
                                                   "seed",   "output",     "folder",       "plan_folder"};
    return names;
}

const std::vector<std::string> &commandProperties()
{
    static const std::vector<std::string> names = {"command", "format",     "graph_format", "instance_format",
                                                   "motion",  "exit_codes", "files",        "margin"};
    return names;
}

double timeMargin(const OutsideCommand &command, double limit)
{
    constexpr double kShare = 0.1;
    constexpr double kMost = 1; // second
    return command.margin.value_or(std::min(limit * kShare, kMost));
}

std::string givenWord(const OutsideCommand &command, std::size_t index, const std::string &filled)
{
    const auto absolute = [&command](std::string_view path)
    { return (command.folder / path).lexically_normal().string(); };
    if (isLookedUp(command, index))
        return filled;
    if (index == 0)
        return absolute(filled);
    std::string word;
    for (std::size_t begin = 0; begin <= filled.size();)
    {
        const std::size_t end = std::min(filled.find_first_of(kSeparators, begin), filled.size());
        const std::string_view part = std::string_view(filled).substr(begin, end - begin);
        std::error_code error;
        const bool leaves = part.starts_with("../") && std::filesystem::exists(command.folder / part, error);
        word.append(leaves ? absolute(part) : std::string(part)).append(filled, end, 1);
        begin = end + 1;
    }
    return word;
}

std::vector<CommandFile> filesOf(const OutsideCommand &command,
                                 std::span<const std::pair<std::string, std::string>> values)
{
    std::vector<CommandFile> files;
    const auto add = [&](const std::filesystem::path &name)
    {
        const std::filesystem::path path = (command.folder / name).lexically_normal();
        if (std::none_of(files.begin(), files.end(), [&](const auto &file) { return file.path == path; }))
            files.push_back({name.lexically_normal().string(), path});
    };
    for (const std::string &file : command.files)
        add(file);
    const auto valueOf = [&values](const std::string &place)
    {
        const auto value = std::find_if(values.begin(), values.end(),
                                        [&place](const auto &setting) { return setting.first == place; });
        return value == values.end() ? "\n" : value->second; // our own places only part what is beside them
    };
    for (std::size_t i = 0; i < command.words.size(); ++i)
    {
        if (isLookedUp(command, i))
            continue;
        const std::string word = fillPlaces(command.words[i], valueOf);
        for (const std::string_view candidate : candidatesOf(word))
        {
            std::error_code error;
            if (!candidate.empty() && std::filesystem::is_regular_file(command.folder / candidate, error))
                add(candidate);
        }
    }
    return files;
}

void checkExecutable(const OutsideCommand &command)
{
    const std::string &program = command.words.front();
    const bool isPath = program.find('/') != std::string::npos;
    const std::filesystem::path file = command.folder / program; // an absolute path stays itself
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

#include "yaml/YamlConfig.h"

#include "framework/support/ReadableText.h"

#include <algorithm>
#include <cctype>
#include <optional>
#include <sstream>
#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/exceptions.h>
#include <yaml-cpp/mark.h>
#include <yaml-cpp/parser.h>

namespace mrpp
{

namespace
{

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

/// Text that YAML 1.1 readers take for an octal number, and YAML 1.2 readers for a decimal one; or the other
/// ways to write a number that is not what it looks like.
bool looksLikeOctalOrHex(std::string_view text)
{
    if (!text.empty() && (text.front() == '+' || text.front() == '-'))
        text.remove_prefix(1);
    if (text.size() < 2 || text.front() != '0')
        return false;
    const auto isDigit = [](char c) { return c >= '0' && c <= '9'; };
    if (text[1] == 'x' || text[1] == 'o')
        return text.size() > 2 && std::all_of(text.begin() + 2, text.end(),
                                              [](unsigned char c) { return std::isxdigit(c) != 0; });
    return isDigit(text[1]) &&
           std::all_of(text.begin(), text.end(), [&](char c) { return isDigit(c) || c == '.' || c == '_'; });
}

/// Builds the tree from yaml-cpp's events: unlike its nodes, they come in file order, each with its own mark,
/// and nothing is shared, so that no text can make the tree larger than itself.
class TreeBuilder final : public YAML::EventHandler
{
public:
    explicit TreeBuilder(std::string file) : file_(std::move(file)) {}

    [[nodiscard]] SourceLocation where(const YAML::Mark &mark) const
    {
        if (mark.is_null())
            return {file_, 0, 0};
        return {file_, static_cast<std::size_t>(mark.line) + 1, static_cast<std::size_t>(mark.column) + 1};
    }
    [[nodiscard]] Config takeRoot() { return std::move(root_); }

    /// yaml-cpp's complaint; where it only found that the text has ended, the bracket that is still open.
    [[nodiscard]] PlanError complaint(const YAML::Exception &error) const
    {
        const bool unclosed =
            error.msg == YAML::ErrorMsg::END_OF_SEQ_FLOW || error.msg == YAML::ErrorMsg::END_OF_MAP_FLOW;
        if (unclosed && !open_.empty())
            return {open_.back().node.where(), open_.back().node.isList() ? "this [ is never closed by a ]"
                                                                          : "this { is never closed by a }"};
        return {where(error.mark), "this is no YAML: " + error.msg};
    }

    void OnDocumentStart(const YAML::Mark &mark) override
    {
        if (hasDocument_)
            throw PlanError(where(mark), "a second YAML document begins here; a plan is one document");
        hasDocument_ = true;
    }
    void OnDocumentEnd() override {}

    void OnNull(const YAML::Mark &mark, YAML::anchor_t anchor) override
    {
        refuseAnchor(mark, anchor);
        if (expectsKey())
            throw PlanError(where(mark), "a key is missing before the colon");
        Config nothing;
        nothing.setWhere(where(mark));
        add(std::move(nothing));
    }

    void OnAlias(const YAML::Mark &mark, YAML::anchor_t) override
    {
        throw PlanError(where(mark), "aliases (*name) are not taken in a plan; write the value out");
    }

    void OnScalar(const YAML::Mark &mark, const std::string &tag, YAML::anchor_t anchor,
                  const std::string &value) override
    {
        refuseAnchor(mark, anchor);
        refuseTag(mark, tag);
        const bool plain = tag != "!";
        refuseControls(mark, value);
        if (expectsKey())
        {
            addKey(value, where(mark));
            return;
        }
        if (plain && looksLikeOctalOrHex(value))
            throw PlanError(where(mark),
                            "'" + value +
                                "' may be read as an octal or hexadecimal number; write a decimal "
                                "number without leading zeros, or quote it");
        add(Config::scalar(value, where(mark)));
    }

    void OnSequenceStart(const YAML::Mark &mark, const std::string &tag, YAML::anchor_t anchor,
                         YAML::EmitterStyle::value) override
    {
        begin(Config::list({}, where(mark)), mark, tag, anchor);
    }
    void OnSequenceEnd() override { end(); }

    void OnMapStart(const YAML::Mark &mark, const std::string &tag, YAML::anchor_t anchor,
                    YAML::EmitterStyle::value) override
    {
        begin(Config::map({}, where(mark)), mark, tag, anchor);
    }
    void OnMapEnd() override { end(); }

private:
    /// A list or map that is being filled.
    struct Frame
    {
        Config node;
        bool hasKey = false; ///< the last entry of the map waits for its value
    };

    [[nodiscard]] bool expectsKey() const
    {
        return !open_.empty() && open_.back().node.isMap() && !open_.back().hasKey;
    }

    void begin(Config node, const YAML::Mark &mark, const std::string &tag, YAML::anchor_t anchor)
    {
        refuseAnchor(mark, anchor);
        refuseTag(mark, tag);
        if (expectsKey())
            throw PlanError(where(mark), "a key must be a word, not a list or map");
        if (open_.size() >= kMaximalYamlDepth)
            throw PlanError(where(mark),
                            "nested deeper than " + std::to_string(kMaximalYamlDepth) + " levels");
        open_.push_back({std::move(node), false});
    }

    void end()
    {
        Config node = std::move(open_.back().node);
        open_.pop_back();
        add(std::move(node));
    }

    void addKey(const std::string &key, SourceLocation place)
    {
        if (key == "<<")
            throw PlanError(place, "merge keys (<<) are not taken in a plan; write the values out");
        auto &entries = open_.back().node.entries();
        const auto first = std::find_if(entries.begin(), entries.end(),
                                        [&key](const Config::Entry &entry) { return entry.key == key; });
        if (first != entries.end())
            throw PlanError(place, "the key '" + key + "' stands here a second time (first in line " +
                                       std::to_string(first->where.line) + "); keep one of the two");
        entries.push_back({key, std::move(place), Config()});
        open_.back().hasKey = true;
    }

    void add(Config node)
    {
        if (open_.empty())
        {
            root_ = std::move(node);
            return;
        }
        Frame &frame = open_.back();
        if (frame.node.isList())
        {
            frame.node.items().push_back(std::move(node));
            return;
        }
        frame.node.entries().back().value = std::move(node);
        frame.hasKey = false;
    }

    void refuseAnchor(const YAML::Mark &mark, YAML::anchor_t anchor) const
    {
        if (anchor != 0)
            throw PlanError(where(mark), "anchors (&name) are not taken in a plan; write the value out");
    }

    /// "?" stands for a plain scalar, "!" for a quoted one.
    void refuseTag(const YAML::Mark &mark, const std::string &tag) const
    {
        if (!tag.empty() && tag != "?" && tag != "!")
            throw PlanError(where(mark), "tags (" + tag + ") are not taken in a plan; leave it out");
    }

    /// What "\0", "\e" and "\uD800" put into a text: no name, path or word of a command can hold it.
    void refuseControls(const YAML::Mark &mark, std::string_view text) const
    {
        while (!text.empty())
        {
            const std::size_t length = sequenceLength(text);
            if (length == 0)
                throw PlanError(where(mark), "this text holds what is no character; write it without");
            if (text.front() != '\r' && isControl(text, length))
                throw PlanError(where(mark), "this text holds a control character (" +
                                                 readable(text.substr(0, length)) + "); write it without");
            text.remove_prefix(length);
        }
    }

    std::string file_;
    bool hasDocument_ = false;
    std::vector<Frame> open_;
    Config root_;
};

/// Throws at the first byte that no plan may hold: broken UTF-8, control characters, tabs that indent.
void checkCharacters(std::string_view text, const std::string &file)
{
    SourceLocation place{file, 1, 1};
    bool indenting = true;
    std::optional<SourceLocation> tab;
    for (std::size_t i = 0; i < text.size();)
    {
        const char c = text[i];
        const std::size_t length = sequenceLength(text.substr(i));
        if (length == 0)
            throw PlanError(place, "not UTF-8 text; save the plan as UTF-8");
        if (static_cast<unsigned char>(c) < 0x20 && c != '\t' && c != '\n' && c != '\r')
            throw PlanError(place, "a control character; a plan is plain text");
        i += length;
        if (c == '\n')
        {
            ++place.line;
            place.column = 1;
            indenting = true;
            tab.reset();
            continue;
        }
        if (indenting && c == '\t' && !tab)
            tab = place;
        if (c != ' ' && c != '\t' && c != '\r')
        {
            if (indenting && tab && c != '#')
                throw PlanError(*tab, "a tab in the indentation; indent with blanks");
            indenting = false;
        }
        place.column += length;
    }
}

} // namespace

Config parseYaml(std::string_view text, const std::string &file)
{
    if (text.starts_with(kByteOrderMark))
        text.remove_prefix(kByteOrderMark.size());
    if (text.size() > kMaximalYamlSize)
        throw PlanError({file, 0, 0}, "larger than " + std::to_string(kMaximalYamlSize >> 20) +
                                          " MiB; a plan is a short text");
    checkCharacters(text, file);

    TreeBuilder builder(file);
    try
    {
        std::istringstream stream{std::string(text)};
        YAML::Parser parser(stream);
        while (parser.HandleNextDocument(builder))
        {}
    }
    catch (const YAML::Exception &error)
    {
        throw builder.complaint(error);
    }
    return builder.takeRoot();
}

} // namespace mrpp

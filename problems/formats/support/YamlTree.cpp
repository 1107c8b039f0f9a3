#include "problems/formats/support/YamlTree.h"

#include "framework/support/Suggestion.h"
#include "problems/formats/support/TextReader.h"

#include <algorithm>
#include <cctype>
#include <sstream>
#include <unordered_map>
#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/exceptions.h>
#include <yaml-cpp/mark.h>
#include <yaml-cpp/parser.h>

namespace mrpp
{

namespace
{

/// Built from yaml-cpp's events: nothing is shared, so that no text can make the tree larger than itself.
class TreeBuilder final : public YAML::EventHandler
{
public:
    explicit TreeBuilder(const std::string &file) : file_(file) {}

    [[noreturn]] void fail(const YAML::Mark &mark, const std::string &what) const
    {
        const SourceLocation where = place(mark);
        throw ParseError({file_, where.line, where.column}, what);
    }
    [[nodiscard]] Config take() { return std::move(root_); }

    void OnDocumentStart(const YAML::Mark &mark) override
    {
        if (hasDocument_)
            fail(mark, "a second YAML document begins here; expected one");
        hasDocument_ = true;
    }
    void OnDocumentEnd() override {}

    void OnNull(const YAML::Mark &mark, YAML::anchor_t anchor) override
    {
        refuseAnchor(mark, anchor);
        if (expectsKey())
            fail(mark, "a key is missing before the colon");
        Config nothing;
        nothing.setWhere(place(mark));
        add(std::move(nothing));
    }
    void OnAlias(const YAML::Mark &mark, YAML::anchor_t) override
    {
        fail(mark, "aliases (*name) are not read; write the value out");
    }
    void OnScalar(const YAML::Mark &mark, const std::string &, YAML::anchor_t anchor,
                  const std::string &value) override
    {
        refuseAnchor(mark, anchor);
        if (!expectsKey())
        {
            add(Config::scalar(value, place(mark)));
            return;
        }
        Frame &frame = open_.back();
        const auto [known, isNew] = frame.lineOfKey.emplace(value, place(mark).line);
        if (!isNew)
            fail(mark, "the key " + inQuotes(value) + " stands in line " + std::to_string(known->second) +
                           " already");
        frame.node.entries().push_back({value, place(mark), Config()});
        frame.hasKey = true;
    }
    void OnSequenceStart(const YAML::Mark &mark, const std::string &, YAML::anchor_t anchor,
                         YAML::EmitterStyle::value) override
    {
        begin(Config::list({}, place(mark)), mark, anchor);
    }
    void OnSequenceEnd() override { end(); }
    void OnMapStart(const YAML::Mark &mark, const std::string &, YAML::anchor_t anchor,
                    YAML::EmitterStyle::value) override
    {
        begin(Config::map({}, place(mark)), mark, anchor);
    }
    void OnMapEnd() override { end(); }

private:
    /// A list or map that is being filled.
    struct Frame
    {
        Config node;
        bool hasKey = false; ///< the last entry of the map waits for its value
        std::unordered_map<std::string, std::size_t> lineOfKey;
    };

    static SourceLocation place(const YAML::Mark &mark)
    {
        if (mark.is_null())
            return {};
        return {{}, static_cast<std::size_t>(mark.line) + 1, static_cast<std::size_t>(mark.column) + 1};
    }

    [[nodiscard]] bool expectsKey() const
    {
        return !open_.empty() && open_.back().node.isMap() && !open_.back().hasKey;
    }

    void begin(Config node, const YAML::Mark &mark, YAML::anchor_t anchor)
    {
        constexpr std::size_t deepest = 16;
        refuseAnchor(mark, anchor);
        if (expectsKey())
            fail(mark, "a key must be a word, not a list or map");
        if (open_.size() >= deepest)
            fail(mark, "nested deeper than " + std::to_string(deepest) + " levels");
        open_.push_back({std::move(node), false, {}});
    }

    void end()
    {
        Config node = std::move(open_.back().node);
        open_.pop_back();
        add(std::move(node));
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
            fail(mark, "anchors (&name) are not read; write the value out");
    }

    const std::string &file_;
    bool hasDocument_ = false;
    std::vector<Frame> open_;
    Config root_;
};

} // namespace

Config parseYamlTree(std::string_view text, const std::string &file)
{
    TreeBuilder builder(file);
    try
    {
        std::istringstream stream{std::string(withoutByteOrderMark(text))};
        YAML::Parser parser(stream);
        while (parser.HandleNextDocument(builder))
            continue;
    }
    catch (const YAML::Exception &error)
    {
        builder.fail(error.mark, "this is no YAML: " + error.msg);
    }
    return builder.take();
}

YamlDocument::YamlDocument(std::string_view text, std::string file)
    : file_(std::move(file)), root_(parseYamlTree(text, file_))
{
    if (!root_.isMap())
        throw ParseError({file_, 1, 1}, "expected YAML with a map of keys at the top");
}

void YamlDocument::fail(const Config &node, const std::string &what) const
{
    fail(node.where(), what);
}

void YamlDocument::fail(const SourceLocation &where, const std::string &what) const
{
    throw ParseError({file_, where.line, where.column}, what);
}

const Config &YamlDocument::get(const Config &map, const char *key) const
{
    if (!map.isMap())
        fail(map, std::string("expected a map with the key '") + key + "'");
    const Config *value = map.find(key);
    if (value == nullptr)
        fail(map, std::string("the key '") + key + "' is missing");
    return *value;
}

std::int64_t YamlDocument::integer(const Config &node, const char *what) const
{
    const auto value = node.isScalar() ? parseInteger(node.text()) : std::nullopt;
    if (!value)
        fail(node, "expected a whole number, the " + std::string(what));
    return *value;
}

double YamlDocument::number(const Config &node, const char *what) const
{
    const auto value = node.isScalar() ? parseNumber(node.text()) : std::nullopt;
    if (!value)
        fail(node, "expected a number, the " + std::string(what));
    return *value;
}

bool YamlDocument::flag(const Config &node) const
{
    const std::string &text = node.text();
    std::string lower;
    for (const char c : text)
        lower += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    const bool isYes = lower == "true" || lower == "yes" || lower == "on" || lower == "y";
    const bool isNo = lower == "false" || lower == "no" || lower == "off" || lower == "n";
    if (!node.isScalar() || (!isYes && !isNo))
        fail(node, "expected true or false");
    return isYes;
}

std::pair<const Config &, const Config &> YamlDocument::pair(const Config &node, const char *form) const
{
    if (!node.isList() || node.items().size() != 2)
        fail(node, "expected a list of two, " + std::string(form));
    return {node.items()[0], node.items()[1]};
}

std::pair<std::int64_t, std::int64_t> YamlDocument::point(const Config &node) const
{
    const auto &[x, y] = pair(node, "[column, row]");
    return {integer(x, "column"), integer(y, "row")};
}

const std::vector<Config> &YamlDocument::items(const Config &node, const char *what) const
{
    if (!node.isList() && !isEmpty(node))
        fail(node, "expected a list of " + std::string(what));
    return node.items();
}

bool YamlDocument::isEmpty(const Config &node)
{
    return !node.isScalar() && node.items().empty() && node.entries().empty();
}

void YamlDocument::allowKeys(const Config &map, const std::vector<std::string> &known) const
{
    for (const Config::Entry &entry : map.entries())
        if (std::find(known.begin(), known.end(), entry.key) == known.end())
            fail(entry.where,
                 "the key " + inQuotes(entry.key) + " is not known here" + suggestion(entry.key, known));
}

} // namespace mrpp

#pragma once
/// \file
/// YAML that other programs wrote, as a tree. Internal to the readers of this folder.

#include "framework/support/Config.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace mrpp
{

/// The one document of the text. Places have no file name, to save memory. Tags are skipped (Python's writers
/// add them to tuples). Throws ParseError for what is no YAML, anchors and aliases, keys that are no words or
/// stand twice, a second document, and nesting deeper than any of the formats has.
[[nodiscard]] Config parseYamlTree(std::string_view text, const std::string &file);

/// The tree of a file, and how to take it apart with complaints at the right places.
class YamlDocument
{
public:
    /// Throws ParseError as parseYamlTree() does, and where there is no map at the top.
    YamlDocument(std::string_view text, std::string file);

    [[nodiscard]] const Config &root() const { return root_; }
    [[nodiscard]] const std::string &file() const { return file_; }

    [[noreturn]] void fail(const Config &node, const std::string &what) const;
    [[noreturn]] void fail(const SourceLocation &where, const std::string &what) const;

    /// The value of a key that has to be there.
    [[nodiscard]] const Config &get(const Config &map, const char *key) const;
    [[nodiscard]] std::int64_t integer(const Config &node, const char *what) const;
    /// A number, be it with a fraction.
    [[nodiscard]] double number(const Config &node, const char *what) const;
    /// As YAML 1.1 spells it: true, yes, on, y and their opposites, small, large or capitalized.
    [[nodiscard]] bool flag(const Config &node) const;
    /// Two items.
    [[nodiscard]] std::pair<const Config &, const Config &> pair(const Config &node, const char *form) const;
    /// Column and row.
    [[nodiscard]] std::pair<std::int64_t, std::int64_t> point(const Config &node) const;
    /// The items of a list; none of a key without a value.
    [[nodiscard]] const std::vector<Config> &items(const Config &node, const char *what) const;

    /// Whether there is nothing in it: no value, an empty list or map.
    [[nodiscard]] static bool isEmpty(const Config &node);

    /// Throws ParseError where a map has another key: what is not known may not be left out.
    void allowKeys(const Config &map, const std::vector<std::string> &known) const;

private:
    std::string file_;
    Config root_;
};

} // namespace mrpp

#pragma once
/// \file
/// A tree of settings as a plan or a command line gives them: scalars, lists and maps, each knowing where it
/// stands, so that whoever refuses a value can say `file:line:column`.

#include "framework/support/Error.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace mrpp
{

class Config
{
public:
    enum class Kind
    {
        empty,  ///< a key without a value
        scalar, ///< text(); its type is the reader's business
        list,   ///< items()
        map,    ///< entries(), in file order, keys pairwise distinct
    };
    struct Entry;

    Config() = default;
    [[nodiscard]] static Config scalar(std::string text, SourceLocation where = {});
    [[nodiscard]] static Config list(std::vector<Config> items, SourceLocation where = {});
    [[nodiscard]] static Config map(std::vector<Entry> entries, SourceLocation where = {});

    [[nodiscard]] Kind kind() const { return kind_; }
    [[nodiscard]] bool isScalar() const { return kind_ == Kind::scalar; }
    [[nodiscard]] bool isList() const { return kind_ == Kind::list; }
    [[nodiscard]] bool isMap() const { return kind_ == Kind::map; }
    [[nodiscard]] const SourceLocation &where() const { return where_; }
    void setWhere(SourceLocation where) { where_ = std::move(where); }

    [[nodiscard]] const std::string &text() const { return text_; }
    [[nodiscard]] const std::vector<Config> &items() const { return items_; }
    [[nodiscard]] const std::vector<Entry> &entries() const { return entries_; }
    [[nodiscard]] std::vector<Config> &items() { return items_; }
    [[nodiscard]] std::vector<Entry> &entries() { return entries_; }

    /// The value under a key of a map, or null.
    [[nodiscard]] const Config *find(std::string_view key) const;

    /// The scalar as a number; throws PlanError at its place where it is none.
    [[nodiscard]] double number() const;
    [[nodiscard]] std::int64_t integer() const;

    /// One line of JSON with sorted keys: equal settings have equal text, whatever their order in the file.
    [[nodiscard]] std::string canonical() const;

private:
    Kind kind_ = Kind::empty;
    SourceLocation where_;
    std::string text_;
    std::vector<Config> items_;
    std::vector<Entry> entries_;
};

struct Config::Entry
{
    std::string key;
    SourceLocation where; ///< of the key
    Config value;
};

/// The whole text as a number, or nothing: no octal, no hexadecimal, no trailing characters, no infinities.
[[nodiscard]] std::optional<double> parseNumber(std::string_view text);
[[nodiscard]] std::optional<std::int64_t> parseInteger(std::string_view text);

/// The shortest text that reads back as the same number; integers without a point.
[[nodiscard]] std::string formatNumber(double value);

} // namespace mrpp

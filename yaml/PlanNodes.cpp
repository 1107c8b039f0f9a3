#include "yaml/PlanNodes.h"

#include "framework/support/Suggestion.h"

#include <algorithm>

namespace mrpp
{

const Config &requireMap(const Config &node, const SourceLocation &where, const std::string &what)
{
    if (!node.isMap())
        throw PlanError(node.where().line > 0 ? node.where() : where, what);
    return node;
}

void checkKeys(const Config &map, const std::string &owner, const std::vector<std::string> &known)
{
    for (const Config::Entry &entry : map.entries())
        if (std::find(known.begin(), known.end(), entry.key) == known.end())
            throw PlanError(entry.where,
                            "unknown key '" + entry.key + "' in " + owner + suggestion(entry.key, known));
}

const std::string &textOf(const Config::Entry &entry)
{
    if (!entry.value.isScalar() || entry.value.text().empty())
        throw PlanError(entry.value.isScalar() || entry.value.kind() == Config::Kind::empty
                            ? entry.where
                            : entry.value.where(),
                        "'" + entry.key + "' takes one value");
    return entry.value.text();
}

std::int64_t integerOf(const Config::Entry &entry, std::int64_t low, std::int64_t high)
{
    (void)textOf(entry);
    const auto value = parseInteger(entry.value.text());
    if (!value || *value < low || *value > high)
        throw PlanError(entry.value.where(), "'" + entry.key + "' takes a whole number from " +
                                                 std::to_string(low) + " to " + std::to_string(high) +
                                                 ", but is '" + entry.value.text() + "'");
    return *value;
}

const std::vector<Config> &itemsOf(const Config::Entry &entry, const std::string &what)
{
    if (!entry.value.isList())
        throw PlanError(entry.value.kind() == Config::Kind::empty ? entry.where : entry.value.where(),
                        "'" + entry.key + "' takes a list: " + what);
    if (entry.value.items().empty())
        throw PlanError(entry.value.where(), "'" + entry.key + "' is an empty list; give " + what);
    return entry.value.items();
}

} // namespace mrpp

#include "yaml/PlanNodes.h"

#include "framework/support/Suggestion.h"

#include <algorithm>
#include <array>
#include <span>
#include <string_view>
#include <utility>

namespace mrpp
{

namespace
{

using Unit = std::pair<std::string_view, double>;
constexpr std::array<Unit, 4> kTimeUnits = {{{"ms", 1e-3}, {"s", 1}, {"min", 60}, {"h", 3600}}};
constexpr std::array<Unit, 7> kMemoryUnits = {{{"kB", 1e-3},
                                               {"MB", 1},
                                               {"GB", 1e3},
                                               {"TB", 1e6},
                                               {"KiB", 1024e-6},
                                               {"MiB", 1.048576},
                                               {"GiB", 1073.741824}}};

/// "60 s", "1.5h", "4 GiB".
double quantityOf(const Config::Entry &entry, std::span<const Unit> units, const std::string &examples,
                  Zero zero)
{
    const std::string_view text = textOf(entry);
    const std::size_t unitAt = std::min(text.find_last_of("0123456789.") + 1, text.size());
    std::string_view unit = text.substr(unitAt);
    unit.remove_prefix(std::min(unit.find_first_not_of(' '), unit.size()));
    const auto number = parseNumber(text.substr(0, unitAt));
    const auto known =
        std::find_if(units.begin(), units.end(), [unit](const Unit &u) { return u.first == unit; });
    if (!number || known == units.end())
        throw PlanError(entry.value.where(), "'" + entry.key + "' takes a number and a unit, as in " +
                                                 examples + ", but is '" + std::string(text) + "'");
    constexpr double kMost = 1e9;
    const double value = *number * known->second;
    if (!(value > 0 || (value == 0 && zero == Zero::allowed)) || value > kMost)
        throw PlanError(entry.value.where(), "'" + entry.key + "' is '" + std::string(text) +
                                                 "', which is no sensible limit; take one as in " + examples);
    return value;
}

} // namespace

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

const std::string &nameOf(const Config::Entry &entry)
{
    const std::string &name = textOf(entry);
    if (name.find_first_of("\n\r\t") != std::string::npos)
        throw PlanError(entry.value.where(), "a name has one line and no tabs");
    return name;
}

std::string inOneLine(std::string text)
{
    std::replace_if(
        text.begin(), text.end(), [](char c) { return c == '\n' || c == '\r' || c == '\t'; }, ' ');
    return text;
}

double durationOf(const Config::Entry &entry, Zero zero)
{
    return quantityOf(entry, kTimeUnits, "500 ms, 60 s, 5 min, 1 h", zero);
}

double sizeOf(const Config::Entry &entry, const std::string &examples)
{
    return quantityOf(entry, kMemoryUnits, examples, Zero::refused);
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

#include "framework/support/Parameters.h"

#include "framework/support/Config.h"
#include "framework/support/Error.h"
#include "framework/support/Suggestion.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>

namespace mrpp
{

namespace
{

std::vector<std::string> split(std::string_view text, char separator)
{
    std::vector<std::string> parts;
    while (!text.empty())
    {
        const std::size_t end = text.find(separator);
        parts.emplace_back(text.substr(0, end));
        text = end == std::string_view::npos ? "" : text.substr(end + 1);
    }
    return parts;
}

/// Throws where a number is outside `low:high` or `low:step:high`.
void checkRange(const ParameterSet::Parameter &parameter, double value, std::string_view text)
{
    const auto bounds = split(parameter.range, ':');
    if (bounds.empty())
        return;
    const auto low = parseNumber(bounds.front());
    const auto high = parseNumber(bounds.back());
    if ((low && value < *low) || (high && value > *high))
        throw ParamError("parameter '" + parameter.name + "' must lie in " + parameter.range + ", but is " +
                         std::string(text));
}

[[noreturn]] void refuse(const ParameterSet::Parameter &parameter, std::string_view text, const char *wanted)
{
    throw ParamError("parameter '" + parameter.name + "' takes " + wanted + ", but is '" + std::string(text) +
                     "'");
}

struct Setter
{
    const ParameterSet::Parameter &parameter;
    std::string_view text;

    void operator()(bool *slot) const
    {
        if (text == "true" || text == "yes" || text == "1")
            *slot = true;
        else if (text == "false" || text == "no" || text == "0")
            *slot = false;
        else
            refuse(parameter, text, "true or false");
    }
    void operator()(std::int64_t *slot) const
    {
        const auto value = parseInteger(text);
        if (!value)
            refuse(parameter, text, "a whole number");
        checkRange(parameter, static_cast<double>(*value), text);
        *slot = *value;
    }
    void operator()(double *slot) const
    {
        const auto value = parseNumber(text);
        if (!value)
            refuse(parameter, text, "a number");
        checkRange(parameter, *value, text);
        *slot = *value;
    }
    void operator()(std::string *slot) const
    {
        const auto words = split(parameter.range, ',');
        if (!words.empty() && std::find(words.begin(), words.end(), text) == words.end())
            throw ParamError("parameter '" + parameter.name + "' does not take '" + std::string(text) + "'" +
                             suggestion(text, words));
        *slot = text;
    }
    void operator()(std::filesystem::path *slot) const
    {
        if (text.empty())
            refuse(parameter, text, "a file's path");
        *slot = text;
    }
};

} // namespace

std::string_view ParameterSet::Parameter::type() const
{
    constexpr std::string_view names[] = {"bool", "int", "real", "text", "path"};
    return names[slot.index()];
}

std::string ParameterSet::Parameter::value() const
{
    struct Getter
    {
        std::string operator()(const bool *value) const { return *value ? "true" : "false"; }
        std::string operator()(const std::int64_t *value) const { return std::to_string(*value); }
        std::string operator()(const double *value) const { return formatNumber(*value); }
        std::string operator()(const std::string *value) const { return *value; }
        std::string operator()(const std::filesystem::path *value) const { return value->string(); }
    };
    return std::visit(Getter(), slot);
}

void ParameterSet::add(Parameter parameter)
{
    assert(find(parameter.name) == nullptr && "a parameter's name is taken");
    parameter.defaultValue = parameter.value();
    parameters_.push_back(std::move(parameter));
}

void ParameterSet::set(std::string_view name, std::string_view text)
{
    const Parameter *parameter = find(name);
    if (parameter == nullptr)
        throw ParamError("there is no parameter '" + std::string(name) + "'" + suggestion(name, names()));
    std::visit(Setter{*parameter, text}, parameter->slot);
}

const ParameterSet::Parameter *ParameterSet::find(std::string_view name) const
{
    const auto found = std::find_if(parameters_.begin(), parameters_.end(),
                                    [name](const Parameter &parameter) { return parameter.name == name; });
    return found == parameters_.end() ? nullptr : &*found;
}

std::vector<std::string> ParameterSet::names() const
{
    std::vector<std::string> list;
    for (const Parameter &parameter : parameters_)
        list.push_back(parameter.name);
    return list;
}

} // namespace mrpp

#pragma once
/// \file
/// Typed parameters with ranges: the settings of planners, problems and optimizers, each bound to the member
/// that holds it.
///
/// \code
/// MyPlanner::MyPlanner() : Planner({...})
/// {
///     declareParam("restarts", restarts_, "1:1000", "how often to begin anew with another order");
///     declareParam("order", order_, "far_first,near_first,given", "who plans first");
/// }
/// \endcode
///
/// A range is `low:high` or `low:step:high` for numbers (both ends allowed; the step is a hint for sweeps),
/// the allowed words separated by commas for text, and empty for no limit.

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace mrpp
{

/// What a parameter may be bound to.
template <class T>
concept ParameterType = std::same_as<T, bool> || std::same_as<T, std::int64_t> || std::same_as<T, double> ||
    std::same_as<T, std::string> || std::same_as<T, std::filesystem::path>;

class ParameterSet
{
public:
    using Slot = std::variant<bool *, std::int64_t *, double *, std::string *, std::filesystem::path *>;

    struct Parameter
    {
        std::string name;
        Slot slot;
        std::string range;
        std::string help;         ///< one line: meaning and unit
        std::string defaultValue; ///< the slot's value when it was declared

        /// `bool`, `int`, `real`, `text` or `path`.
        [[nodiscard]] std::string_view type() const;
        /// The slot's value as text.
        [[nodiscard]] std::string value() const;
    };

    template <ParameterType T>
    void declare(std::string name, T &slot, std::string range, std::string help)
    {
        add({std::move(name), Slot(&slot), std::move(range), std::move(help), {}});
    }

    /// Sets a parameter from text. Throws ParamError for an unknown name (with the nearest known one), a
    /// value of the wrong type, or one outside its range; then nothing has changed.
    void set(std::string_view name, std::string_view text);

    [[nodiscard]] const std::vector<Parameter> &all() const { return parameters_; }
    [[nodiscard]] const Parameter *find(std::string_view name) const;
    [[nodiscard]] std::vector<std::string> names() const;

private:
    void add(Parameter parameter);

    std::vector<Parameter> parameters_;
};

} // namespace mrpp

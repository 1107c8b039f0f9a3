#include "framework/PlannerStatus.h"

#include <array>
#include <utility>

namespace mrpp
{

namespace
{
using enum PlannerStatus;
constexpr std::array<std::pair<PlannerStatus, std::string_view>, 11> kNames = {{
    {unknown, "unknown"},
    {timeout, "timeout"},
    {partial, "partial"},
    {solved, "solved"},
    {crash, "crash"},
    {aborted, "aborted"},
    {infeasible, "infeasible"},
    {gave_up, "gave_up"},
    {unsupported, "unsupported"},
    {memory_limit, "memory_limit"},
    {invalid, "invalid"},
}};
} // namespace

std::string_view toString(PlannerStatus status)
{
    for (const auto &[value, name] : kNames)
        if (value == status)
            return name;
    return "unknown";
}

std::optional<PlannerStatus> plannerStatus(std::string_view name)
{
    for (const auto &[value, known] : kNames)
        if (known == name)
            return value;
    return std::nullopt;
}

} // namespace mrpp

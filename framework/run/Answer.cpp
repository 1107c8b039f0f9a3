#include "framework/run/Answer.h"

#include <array>

namespace mrpp
{

std::span<const std::string_view> answerColumns()
{
    static constexpr std::array<std::string_view, 12> kColumns = {"status",
                                                                  "instance_fingerprint",
                                                                  "solution_fingerprint",
                                                                  "completed",
                                                                  "path_length",
                                                                  "actions",
                                                                  "makespan",
                                                                  "sum_of_costs",
                                                                  "optimized_actions",
                                                                  "optimized_makespan",
                                                                  "optimized_path_length",
                                                                  "optimized_sum_of_costs"};
    return kColumns;
}

std::vector<std::string_view> answerDifferences(const RunRecord &a, const RunRecord &b)
{
    std::vector<std::string_view> different;
    for (const std::string_view name : answerColumns())
    {
        const RunColumn *column = findRunColumn(name);
        if (column->get(a) != column->get(b))
            different.push_back(name);
    }
    return different;
}

bool endedByLimit(const RunRecord &record)
{
    return record.status == PlannerStatus::timeout || record.status == PlannerStatus::memory_limit;
}

} // namespace mrpp

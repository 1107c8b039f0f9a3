#pragma once
/// \file
/// The figures of a campaign: which there are, what they show and what their captions say.

#include "framework/store/ResultTable.h"
#include "reports/figures/Figure.h"

#include <string>
#include <vector>

namespace mrpp
{

struct CampaignFigures
{
    std::vector<Figure> figures;
    std::vector<std::string> complaints; ///< what cannot be shown, and why
};

/// The figures that the plan asks for, and unless it wants those alone: for each sweep path length, makespan
/// (each also optimized), time and success against the swept variable; for each family's other problems the
/// same measures compared, a row a problem; planners compared over the whole campaign; how costs grow with
/// graphs; what planners say of themselves while they work. A measure that no run has gets no figure. The
/// same results give the same figures under the same names.
[[nodiscard]] CampaignFigures campaignFigures(const ResultTable &results);

} // namespace mrpp

#pragma once
/// \file
/// The figures of a campaign while they are put together.

#include "reports/figures/CampaignFigures.h"
#include "reports/picture/Text.h"

#include <string>
#include <vector>

namespace mrpp
{

/// What is done about the campaign's figures: names are unique among them, and a planner has one style.
class FigureList
{
public:
    explicit FigureList(const ResultTable &results);

    [[nodiscard]] const std::vector<std::string> &planners() const { return planners_; }
    /// A planner's style: its position in the plan.
    [[nodiscard]] std::size_t styleOf(const std::string &planner) const;

    /// Gives the figure a name of its own after `title`, and its caption the planners' motion rules where
    /// they differ.
    void add(Figure figure, const std::string &title);
    void complain(std::string complaint) { result_.complaints.push_back(std::move(complaint)); }
    [[nodiscard]] CampaignFigures take() { return std::move(result_); }

private:
    std::vector<std::string> planners_;
    std::string rules_; ///< a sentence; empty where all planners obey the same rule
    FileNames names_;
    CampaignFigures result_;
};

} // namespace mrpp

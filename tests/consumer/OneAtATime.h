#pragma once

#include "framework/Planner.h"

/// Sends the robots to their goals one after another, each along a shortest path around all others.
class OneAtATime final : public mrpp::Planner
{
public:
    OneAtATime();

    mrpp::PlannerStatus solve(const mrpp::TerminationCondition &ptc) override;

private:
    std::int64_t rounds_ = 10;
};

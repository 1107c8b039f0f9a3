#pragma once

#include "framework/Problem.h"

/// Arms of equal length around one vertex; every robot has to go from its arm's end to that of the next arm.
class Star final : public mrpp::Problem
{
public:
    Star();

    std::string name() const override;
    std::shared_ptr<const mrpp::Graph> makeGraph(mrpp::Seed seed) const override;
    mrpp::Instance makeInstance(std::shared_ptr<const mrpp::Graph> graph, std::size_t robots,
                                mrpp::Seed seed) const override;

private:
    std::int64_t arms_ = 4;
    std::int64_t length_ = 3;
};

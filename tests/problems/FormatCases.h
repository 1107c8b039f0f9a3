#pragma once
/// \file
/// What the tests of the formats share: random instances with legal schedules, and refusals by place.

#include "framework/model/Instance.h"
#include "framework/model/Schedule.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <string>
#include <vector>

namespace mrpp
{

/// A malformed file, where it is wrong, and a part of the message.
struct Refusal
{
    const char *name;
    std::string contents;
    std::string where; ///< "bad:line:column"
    const char *fragment;
};

inline void PrintTo(const Refusal &refusal, std::ostream *out)
{
    *out << refusal.name;
}

/// Expects that `read(contents, "bad")` throws ParseError at the refusal's place.
template <class Read>
void expectRefusal(const Refusal &refusal, Read &&read);

/// A random connected graph of cells: a grid with holes, whole coordinates, y downwards.
[[nodiscard]] std::shared_ptr<const Graph> randomCells();

/// A random graph without coordinates; every edge has weight 1.
[[nodiscard]] std::shared_ptr<const Graph> randomGraph();

struct Case
{
    Instance instance;
    Schedule schedule; ///< takes every robot to its goal; no empty steps
};

/// Robots somewhere on the graph, some steps of random moves, each legal under `following`; the goals are
/// where they end.
[[nodiscard]] Case randomCase(std::shared_ptr<const Graph> graph);

} // namespace mrpp

#include "framework/support/Error.h"

template <class Read>
void mrpp::expectRefusal(const Refusal &refusal, Read &&read)
{
    try
    {
        read(refusal.contents, "bad");
        ADD_FAILURE() << refusal.name << " was accepted";
    }
    catch (const InputError &error)
    {
        EXPECT_EQ(error.where().toString(), refusal.where) << refusal.name << ": " << error.what();
        EXPECT_THAT(error.what(), testing::HasSubstr(refusal.fragment)) << refusal.name;
        EXPECT_THAT(error.what(), testing::Not(testing::HasSubstr("\n"))) << refusal.name;
    }
}

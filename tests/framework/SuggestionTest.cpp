#include "framework/support/Suggestion.h"
#include "framework/support/Registry.h"

#include <gtest/gtest.h>

#include <vector>

namespace mrpp
{
namespace
{

const std::vector<std::string> kPlanners = {"push_and_swap", "push_and_rotate", "bibox", "tass"};

TEST(Suggestion, FindsTheNearestWord)
{
    EXPECT_EQ(nearestWord("push_and_swop", kPlanners), "push_and_swap");
    EXPECT_EQ(nearestWord("push_and_rotat", kPlanners), "push_and_rotate");
    EXPECT_EQ(nearestWord("bbiox", kPlanners), "bibox") << "swapped neighbours count one";
    EXPECT_EQ(nearestWord("bibox", kPlanners), "bibox");
}

TEST(Suggestion, OfEquallyNearWordsTakesTheFirst)
{
    EXPECT_EQ(nearestWord("b", std::vector<std::string>{"a", "c"}), "a");
}

TEST(Suggestion, IsSilentWhereNothingIsNear)
{
    EXPECT_EQ(nearestWord("dijkstra", kPlanners), "");
    EXPECT_EQ(nearestWord("", {}), "");
}

TEST(Suggestion, IsWrittenBehindAMessage)
{
    EXPECT_EQ(suggestion("tas", kPlanners), "; did you mean 'tass'?");
    EXPECT_EQ(suggestion("dijkstra", kPlanners), "; known: push_and_swap, push_and_rotate, bibox, tass");
    EXPECT_EQ(suggestion("dijkstra", {}), "");
}

struct Shape
{
    Shape() = default;
    virtual ~Shape() = default;
    Shape(const Shape &) = delete;
    Shape &operator=(const Shape &) = delete;
    [[nodiscard]] virtual int corners() const = 0;
};
struct Square : Shape
{
    [[nodiscard]] int corners() const override { return 4; }
};

TEST(Registry, MakesWhatWasRegistered)
{
    Registry<Shape> registry("shape");
    registry.add<Square>("square", "four corners");
    EXPECT_EQ(registry.create("square")->corners(), 4);
    EXPECT_EQ(registry.names(), std::vector<std::string>{"square"});
    EXPECT_EQ(registry.find("square")->description, "four corners");
    EXPECT_EQ(registry.find("circle"), nullptr);
}

TEST(Registry, SuggestsTheNearestName)
{
    Registry<Shape> registry("shape");
    registry.add<Square>("square", "four corners");
    try
    {
        (void)registry.create("sqaure");
        FAIL();
    }
    catch (const InputError &error)
    {
        EXPECT_STREQ(error.what(), "there is no shape 'sqaure'; did you mean 'square'?");
    }
}

TEST(Registry, TakesANameOnce)
{
    Registry<Shape> registry("shape");
    registry.add<Square>("square", "four corners");
    EXPECT_THROW(registry.add<Square>("square", "again"), std::logic_error);
}

} // namespace
} // namespace mrpp

#include "framework/support/Parameters.h"
#include "framework/support/Error.h"

#include <gtest/gtest.h>

namespace mrpp
{
namespace
{

class Parameters : public ::testing::Test
{
protected:
    Parameters()
    {
        set_.declare("restarts", restarts_, "1:1000", "how often");
        set_.declare("bias", bias_, "0:0.05:1", "towards the goal");
        set_.declare("order", order_, "far_first,near_first", "who plans first");
        set_.declare("title", title_, "", "any text");
        set_.declare("smooth", smooth_, "", "whether");
        set_.declare("map", map_, "", "file");
        set_.declare("offset", offset_, "", "any number");
    }

    std::string complaint(std::string_view name, std::string_view text)
    {
        try
        {
            set_.set(name, text);
        }
        catch (const ParamError &error)
        {
            return error.complaint();
        }
        return "";
    }

    ParameterSet set_;
    std::int64_t restarts_ = 10;
    double bias_ = 0.5;
    std::string order_ = "far_first";
    std::string title_;
    bool smooth_ = true;
    std::filesystem::path map_;
    std::int64_t offset_ = -3;
};

TEST_F(Parameters, SetTheMembersTheyAreBoundTo)
{
    set_.set("restarts", "25");
    set_.set("bias", "1e-1");
    set_.set("order", "near_first");
    set_.set("title", "two words, a comma");
    set_.set("smooth", "no");
    set_.set("map", "maps/a.map");
    EXPECT_EQ(restarts_, 25);
    EXPECT_EQ(bias_, 0.1);
    EXPECT_EQ(order_, "near_first");
    EXPECT_EQ(title_, "two words, a comma");
    EXPECT_FALSE(smooth_);
    EXPECT_EQ(map_, "maps/a.map");
}

TEST_F(Parameters, AcceptBothEndsOfARange)
{
    EXPECT_EQ(complaint("restarts", "1"), "");
    EXPECT_EQ(complaint("restarts", "1000"), "");
    EXPECT_EQ(complaint("bias", "0"), "");
    EXPECT_EQ(complaint("bias", "1"), "");
    EXPECT_EQ(complaint("offset", "-9223372036854775808"), "");
}

TEST_F(Parameters, RefuseWhatIsOutsideTheirRange)
{
    EXPECT_EQ(complaint("restarts", "0"), "parameter 'restarts' must lie in 1:1000, but is 0");
    EXPECT_EQ(complaint("restarts", "1001"), "parameter 'restarts' must lie in 1:1000, but is 1001");
    EXPECT_EQ(complaint("bias", "1.01"), "parameter 'bias' must lie in 0:0.05:1, but is 1.01");
    EXPECT_EQ(complaint("order", "farfirst"),
              "parameter 'order' does not take 'farfirst'; did you mean 'far_first'?");
    EXPECT_EQ(restarts_, 10) << "nothing has changed";
    EXPECT_EQ(bias_, 0.5);
    EXPECT_EQ(order_, "far_first");
}

TEST_F(Parameters, RefuseTheWrongType)
{
    EXPECT_EQ(complaint("restarts", "2.5"), "parameter 'restarts' takes a whole number, but is '2.5'");
    EXPECT_EQ(complaint("restarts", "0x10"), "parameter 'restarts' takes a whole number, but is '0x10'");
    EXPECT_EQ(complaint("restarts", ""), "parameter 'restarts' takes a whole number, but is ''");
    EXPECT_EQ(complaint("restarts", "99999999999999999999"),
              "parameter 'restarts' takes a whole number, but is '99999999999999999999'");
    EXPECT_EQ(complaint("bias", "half"), "parameter 'bias' takes a number, but is 'half'");
    EXPECT_EQ(complaint("bias", "nan"), "parameter 'bias' takes a number, but is 'nan'");
    EXPECT_EQ(complaint("smooth", "maybe"), "parameter 'smooth' takes true or false, but is 'maybe'");
    EXPECT_EQ(complaint("map", ""), "parameter 'map' takes a file's path, but is ''");
}

TEST_F(Parameters, SuggestTheNearestName)
{
    EXPECT_EQ(complaint("restart", "3"), "there is no parameter 'restart'; did you mean 'restarts'?");
}

TEST_F(Parameters, KnowTheirTypesValuesAndDefaults)
{
    const auto type = [&](std::string_view name) { return std::string(set_.find(name)->type()); };
    EXPECT_EQ(type("restarts"), "int");
    EXPECT_EQ(type("bias"), "real");
    EXPECT_EQ(type("order"), "text");
    EXPECT_EQ(type("smooth"), "bool");
    EXPECT_EQ(type("map"), "path");
    set_.set("restarts", "25");
    EXPECT_EQ(set_.find("restarts")->value(), "25");
    EXPECT_EQ(set_.find("restarts")->defaultValue, "10");
    EXPECT_EQ(set_.find("bias")->defaultValue, "0.5");
    EXPECT_EQ(set_.find("smooth")->value(), "true");
    EXPECT_EQ(set_.find("none"), nullptr);
    EXPECT_EQ(set_.all().size(), 7U);
    EXPECT_EQ(set_.names().front(), "restarts");
}

} // namespace
} // namespace mrpp

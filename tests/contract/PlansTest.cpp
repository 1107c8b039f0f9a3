/// \file
/// Every plan that comes with the program can be read, and says what it is.

#include "framework/system/File.h"
#include "tests/contract/EverythingRegistered.h"
#include "yaml/PlanReader.h"

#include <algorithm>
#include <filesystem>

namespace mrpp
{
namespace
{

Catalog &catalog()
{
    static Catalog kCatalog = test::everythingRegistered();
    return kCatalog;
}

const std::filesystem::path kPlans = std::filesystem::path(MRPP_SOURCE_DIR) / "yaml" / "plans";

std::vector<std::string> plans()
{
    std::vector<std::string> names;
    for (const auto &entry : std::filesystem::directory_iterator(kPlans))
        if (entry.path().extension() == ".yaml")
            names.push_back(entry.path().stem().string());
    std::sort(names.begin(), names.end());
    return names;
}

class EveryPlan : public testing::TestWithParam<std::string>
{};

TEST_P(EveryPlan, CanBeReadAndHasRuns)
{
    const BenchmarkPlan plan = readPlan(kPlans / (GetParam() + ".yaml"), catalog());
    EXPECT_EQ(plan.campaign, GetParam());
    EXPECT_TRUE(plan.text.starts_with("# "));
    EXPECT_FALSE(expand(plan, MissingInput::tolerate).empty());
}

INSTANTIATE_TEST_SUITE_P(Bundled, EveryPlan, testing::ValuesIn(plans()), test::nameOf);

TEST(Plans, AreThereForAllThirteenObjectives)
{
    const auto names = plans();
    for (int i = 1; i <= 13; ++i)
    {
        const std::string name = (i < 10 ? "objective0" : "objective") + std::to_string(i);
        EXPECT_TRUE(std::find(names.begin(), names.end(), name) != names.end()) << name;
    }
}

} // namespace
} // namespace mrpp

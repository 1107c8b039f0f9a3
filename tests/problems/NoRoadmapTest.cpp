/// What a build without CGAL says of planar roadmaps.

#include "framework/Catalog.h"
#include "problems/Problems.h"
#include "problems/generators/Generator.h"
#include "tests/problems/Generated.h"
#include "yaml/ProblemList.h"
#include "yaml/YamlConfig.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace mrpp::test
{
namespace
{

using ::testing::HasSubstr;

TEST(NoRoadmapGenerator, SaysWhatIsMissingAndHowToGetIt)
{
    EXPECT_EQ(
        complaint("roadmap", {{"vertices", "9"}}),
        "plan.yaml:4:5: planar roadmaps need CGAL, and this mrppsim was built without it; build it with "
        "-DMRPP_WITH_CGAL=ON");
}

TEST(NoRoadmapGenerator, IsNoGraphOfTheOneFactorModels)
{
    Catalog catalog;
    registerProblems(catalog);
    const Config plan =
        parseYaml("problems:\n  - fg_vr: {graph: {roadmap: {vertices: 9}}, robots: 2}", "plan.yaml");
    try
    {
        static_cast<void>(readProblems(plan.find("problems")->items(), {.catalog = &catalog}));
        FAIL();
    }
    catch (const InputError &error)
    {
        EXPECT_THAT(error.what(), HasSubstr("plan.yaml:2:"));
        EXPECT_THAT(error.what(), HasSubstr("built without"));
    }
    const auto names = generatorNames(catalog);
    EXPECT_EQ(std::find(names.begin(), names.end(), "roadmap"), names.end());
}

} // namespace
} // namespace mrpp::test

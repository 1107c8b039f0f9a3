#include "tests/reports/Golden.h"

#include "framework/system/File.h"

#include <cstdlib>
#include <filesystem>
#include <gtest/gtest.h>

namespace mrpp::testing
{

void expectGolden(const std::string &name, const std::string &text)
{
    const std::filesystem::path file = std::filesystem::path(MRPP_SOURCE_DIR) / "tests" / "golden" / name;
    const char *bless = std::getenv("MRPP_BLESS");
    if (bless != nullptr && std::string(bless) == "1")
        writeFile(file, text);
    ASSERT_TRUE(std::filesystem::exists(file)) << file << " is missing; MRPP_BLESS=1 writes it";
    EXPECT_EQ(readFile(file), text) << file << " differs; MRPP_BLESS=1 writes it anew";
}

} // namespace mrpp::testing

/// Whatever happens to a file of any format, it is read or refused, within bounded time and memory.
/// MRPP_DAMAGED_FILES is the number of cases a format (1500 where it is not set).

#include "framework/support/Config.h"
#include "framework/system/Memory.h"

#include "tests/problems/FormatReaders.h"
#include "tests/support/CpuClock.h"
#include "tests/support/Damage.h"

#include <cstdlib>
#include <gtest/gtest.h>

namespace mrpp
{
namespace
{

class DamagedFormat : public testing::TestWithParam<FormatReader>
{};

TEST_P(DamagedFormat, IsReadOrRefused)
{
    const FormatReader &format = GetParam();
    ASSERT_NO_THROW(format.read(format.good));
    const char *setting = std::getenv("MRPP_DAMAGED_FILES");
    const std::int64_t cases = parseInteger(setting == nullptr ? "1500" : setting).value_or(1500);
    Random random(deriveSeed(20, format.name));
    std::size_t read = 0;
    std::size_t refused = 0;
    resetPeakMemory();
    for (std::int64_t i = 0; i < cases; ++i)
    {
        const std::string text = test::damaged(format.good, random);
        const double begin = test::cpuSeconds();
        try
        {
            format.read(text);
            ++read;
        }
        catch (const InputError &)
        {
            ++refused;
        }
        catch (const std::exception &error)
        {
            FAIL() << "case " << i << ": " << error.what() << "\n" << text;
        }
        ASSERT_LT(test::cpuSeconds() - begin, 2) << "case " << i << "\n" << text;
        ASSERT_LT(peakMemory(), 1000) << "case " << i << "\n" << text; // MB, with all that came before
    }
    EXPECT_GT(refused, read / 20);
}

INSTANTIATE_TEST_SUITE_P(All, DamagedFormat, testing::ValuesIn(formatReaders()),
                         [](const auto &row) { return std::string(row.param.name); });

} // namespace
} // namespace mrpp

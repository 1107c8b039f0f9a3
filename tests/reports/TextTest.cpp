#include "reports/picture/Text.h"
#include "reports/gnuplot/Axis.h"
#include "reports/picture/Numbers.h"
#include "reports/picture/Palette.h"

#include <gtest/gtest.h>
#include <set>
#include <tuple>

namespace mrpp
{
namespace
{

TEST(OneLine, ShowsControlCharactersAndRepairsUtf8)
{
    EXPECT_EQ(oneLine("a\nb\tc\x01\x7F"), "a b c\\x01\\x7F");
    EXPECT_EQ(oneLine("grün 8×8 😀"), "grün 8×8 😀");
    EXPECT_EQ(oneLine("\xFFx\xC3"), "\uFFFDx\uFFFD");
    EXPECT_EQ(oneLine("\xED\xA0\x80"), "\uFFFD\uFFFD\uFFFD"); // a surrogate
    EXPECT_EQ(oneLine("\xC2\x85z"), "\\x85z");                // a C1 control character
    EXPECT_EQ(manyLines("a\n\tb\r\n"), "a\n    b\n");
}

TEST(Ellipsize, CutsCharactersNotBytes)
{
    EXPECT_EQ(ellipsize("äöü", 3), "äöü");
    EXPECT_EQ(ellipsize("äöüß", 3), "äö…");
    EXPECT_EQ(characterCount("äö…"), 3U);
}

TEST(FileNames, AreSafeAndDistinct)
{
    FileNames names;
    EXPECT_EQ(names.add("small_benchmark-tree"), "small_benchmark-tree");
    EXPECT_EQ(names.add("grid 8×8"), "grid-8-8");
    EXPECT_EQ(names.add("grid 8+8"), "grid-8-8-2");
    EXPECT_EQ(names.add("../../etc/passwd"), "etc-passwd");
    EXPECT_EQ(names.add("`touch x`"), "touch-x");
    EXPECT_EQ(names.add("..."), "unnamed");
    EXPECT_EQ(names.add(std::string(300, 'x')).size(), 90U);
}

TEST(CurveStyle, TellsFortyCurvesApartWithoutColor)
{
    std::set<std::tuple<std::string, int, std::string>> styles;
    for (std::size_t i = 0; i < 40; ++i)
    {
        const CurveStyle style = curveStyle(i);
        EXPECT_EQ(style.filledMarker, style.hollowMarker + 1);
        EXPECT_TRUE(styles.insert({style.color, style.filledMarker, style.dashes}).second) << i;
    }
}

TEST(RobotColor, IsAlwaysSixDigits)
{
    for (std::size_t i = 0; i < 500; ++i)
    {
        const std::string color = robotColor(i);
        ASSERT_EQ(color.size(), 7U);
        EXPECT_EQ(color[0], '#');
        EXPECT_EQ(color.find_first_not_of("0123456789abcdef", 1), std::string::npos) << color;
    }
    EXPECT_EQ(textColorOn("#f0e442"), "#000000");
    EXPECT_EQ(textColorOn("#0072b2"), "#ffffff");
}

TEST(MeasureAxis, IsLogarithmicOnlyBeyondTwoDecades)
{
    EXPECT_FALSE(measureAxis({1, 100}).logarithmic);
    EXPECT_TRUE(measureAxis({1, 101}).logarithmic);
    EXPECT_FALSE(measureAxis({0, 1000}).logarithmic); // zero has no logarithm
    EXPECT_EQ(measureAxis({3, 7}).least, 0);
    EXPECT_GT(measureAxis({3, 7}).most, 7);
    EXPECT_LT(measureAxis({}).least, measureAxis({}).most);
    EXPECT_LT(measureAxis({0}).least, measureAxis({0}).most);
}

TEST(SweepAxis, NamesEveryValueWhereThereIsRoom)
{
    const Axis few = sweepAxis({200, 50, 100, 50});
    ASSERT_EQ(few.tics.size(), 3U);
    EXPECT_EQ(few.tics[0].label, "50");
    EXPECT_EQ(few.tics[2].label, "200");
    std::vector<double> many;
    for (int i = 1; i <= 30; ++i)
        many.push_back(i);
    const Axis even = sweepAxis(many);
    ASSERT_EQ(even.tics.size(), 6U);
    EXPECT_EQ(even.tics[1].label, "10");
    const Axis single = sweepAxis({5});
    EXPECT_LT(single.least, 5);
    EXPECT_GT(single.most, 5);
}

TEST(SweepAxis, NamesFractionsByThreeDigits)
{
    EXPECT_EQ(sweepAxis({4.0 / 9, 5.0 / 9}).tics[0].label, "0.444");
    EXPECT_EQ(sweepAxis({1234567, 2345678}).tics[0].label, "1234567");
}

std::string labels(const Axis &axis)
{
    std::string text;
    for (const Tic &tic : axis.tics)
        if (!tic.label.empty())
            text += tic.label + "|";
    return text;
}

TEST(ThinnedAxis, KeepsNamesThatDoNotTouch)
{
    const Axis axis = measureAxis({15, 4000});
    EXPECT_EQ(labels(thinned(axis, 20)), "20|50|100|200|500|1000|2000|5000|");
    EXPECT_EQ(labels(thinned(axis, 7)), "20|100|500|2000|"); // 1000 and 2000 would touch
    EXPECT_EQ(labels(thinned(axis, 0.1)), "20|500|");
}

TEST(MeasureAxis, NamesTicsInOneStyle)
{
    EXPECT_EQ(labels(measureAxis({15, 20000})), "100|1000|10\u202F000|");
    EXPECT_EQ(labels(measureAxis({15, 4000})), "20|50|100|200|500|1000|2000|5000|");
    EXPECT_EQ(labels(measureAxis({0.5, 2e8})), "10¹|10³|10⁵|10⁷|");
    EXPECT_EQ(labels(measureAxis({12, 21})), "0|5|10|15|20|");
    EXPECT_EQ(labels(measureAxis({0, 0.9})), "0|0.2|0.4|0.6|0.8|");
    EXPECT_EQ(labels(measureAxis({1e6, 5e6})),
              "0|1\u202F000\u202F000|2\u202F000\u202F000|3\u202F000\u202F000|4\u202F000\u202F000|"
              "5\u202F000\u202F000|");
    EXPECT_EQ(labels(measureAxis({1e8, 5e8})), "0|1·10⁸|2·10⁸|3·10⁸|4·10⁸|5·10⁸|");
}

TEST(ThreeDigits, HaveNoExponents)
{
    EXPECT_EQ(threeDigits(12.54), "12.5");
    EXPECT_EQ(threeDigits(9.999), "10.0");
    EXPECT_EQ(threeDigits(0.00123456), "0.00123");
    EXPECT_EQ(threeDigits(1234567), "1234567");
    EXPECT_EQ(threeDigits(0), "0");
}

TEST(TimeUnit, KeepsNumbersShort)
{
    EXPECT_STREQ(timeUnit(2e-5).name, "µs");
    EXPECT_STREQ(timeUnit(0.5).name, "ms");
    EXPECT_STREQ(timeUnit(1).name, "s");
    EXPECT_STREQ(timeUnit(std::vector<double>{0, 1e-6, 10}).name, "ms");
    EXPECT_STREQ(timeUnit(std::vector<double>{}).name, "s");
}

TEST(PowerOfTen, IsRaised)
{
    EXPECT_EQ(powerOfTen(12), "10¹²");
    EXPECT_EQ(powerOfTen(-6), "10⁻⁶");
}

} // namespace
} // namespace mrpp

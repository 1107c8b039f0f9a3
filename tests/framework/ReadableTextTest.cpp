#include "framework/support/ReadableText.h"

#include <gtest/gtest.h>

namespace mrpp
{
namespace
{

using namespace std::string_literals;

TEST(ReadableText, leavesTextAlone)
{
    EXPECT_EQ(readable(""), "");
    EXPECT_EQ(readable("two\nlines\tand a tab"), "two\nlines\tand a tab");
    EXPECT_EQ(readable("grün 8×8 😀 \\x1B"), "grün 8×8 😀 \\x1B");
}

TEST(ReadableText, showsControlCharacters)
{
    EXPECT_EQ(readable("nul:\0:"s), "nul:\\x00:");
    EXPECT_EQ(readable("\x1B[31mred\x1B[0m\a\x7F"), "\\x1B[31mred\\x1B[0m\\x07\\x7F");
    EXPECT_EQ(readable("a\r\nb\rc"), "a\nb\\x0Dc");
    EXPECT_EQ(readable("\xC2\x85"), "\\x85");             // a C1 control
    EXPECT_EQ(readable("\xE2\x80\xAErtl"), "\\u202Ertl"); // writes from right to left
    EXPECT_EQ(readable("\xE2\x80\xA8"), "\\u2028");       // a line separator
}

TEST(ReadableText, replacesBytesThatAreNoUtf8)
{
    EXPECT_EQ(readable("bad \377\376 utf8 \303\050"), "bad \uFFFD\uFFFD utf8 \uFFFD(");
    EXPECT_EQ(readable("\xED\xA0\x80"), "\uFFFD\uFFFD\uFFFD"); // a surrogate
    EXPECT_EQ(readable("\xC0\x80"), "\uFFFD\uFFFD");           // an overlong NUL
    EXPECT_EQ(readable("\xF4\x90\x80\x80"), "\uFFFD\uFFFD\uFFFD\uFFFD");
    EXPECT_EQ(readable("cut \xE2\x82"), "cut \uFFFD\uFFFD");
}

TEST(ReadableText, anyBytesBecomeValidTextWithoutControls)
{
    std::string all;
    for (unsigned high = 0; high < 256; ++high)
        for (unsigned low = 0; low < 256; ++low)
            all.append({static_cast<char>(high), static_cast<char>(low), 'x'});
    const std::string shown = readable(all);
    for (std::string_view rest = shown; !rest.empty();)
    {
        const std::size_t length = sequenceLength(rest);
        ASSERT_GT(length, 0U);
        ASSERT_FALSE(isControl(rest, length));
        rest.remove_prefix(length);
    }
    EXPECT_EQ(readable(shown), shown);
}

TEST(Tail, doesNotBeginWithinACharacter)
{
    EXPECT_EQ(tail("abc", 5), "abc");
    EXPECT_EQ(tail("abcdef", 3), "def");
    EXPECT_EQ(tail("a😀b", 3), "b");
    EXPECT_EQ(tail("a😀b", 5), "😀b");
}

} // namespace
} // namespace mrpp

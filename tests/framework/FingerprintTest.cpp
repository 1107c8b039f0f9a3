#include "framework/support/Fingerprint.h"

#include <gtest/gtest.h>

#include <array>

namespace mrpp
{
namespace
{

// The literals are SHA-256 digests of the documented bytes, computed outside this program.
TEST(Fingerprint, IsTheSameOnEveryMachine)
{
    EXPECT_EQ(Fingerprint().hex(), "e3b0c44298fc1c149afbf4c8996fb924");
    EXPECT_EQ(Fingerprint().add("abc").hex(), "ce91dc5eec0139adf091900d225971d6");
    EXPECT_EQ(Fingerprint().add(std::uint64_t{42}).hex(), "ed049108bc18f2c64369e8d0ea42850b");
    EXPECT_EQ(Fingerprint().add(1.5).hex(), "e163f8cb0f7067a7fc78ca859a77f849");
    constexpr std::array<std::uint32_t, 3> kNumbers = {1, 2, 3};
    EXPECT_EQ(Fingerprint().add(std::span(kNumbers)).hex(), "62464da5afe5d016e96fc02cdb43c012");
    EXPECT_EQ(Fingerprint().add(std::uint64_t{42}).bits(), 14335547759750350061U);
}

TEST(Fingerprint, TellsWhereOneTextEndsAndTheNextBegins)
{
    EXPECT_NE(Fingerprint().add("ab").add("c").hex(), Fingerprint().add("a").add("bc").hex());
    EXPECT_NE(Fingerprint().add("").add("a").hex(), Fingerprint().add("a").add("").hex());
}

TEST(Fingerprint, MovesItsState)
{
    Fingerprint first;
    first.add("abc");
    Fingerprint second = std::move(first);
    EXPECT_EQ(second.hex(), "ce91dc5eec0139adf091900d225971d6");
}

} // namespace
} // namespace mrpp

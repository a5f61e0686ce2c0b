// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <rtob/core/nearest_name.h>

TEST(EditDistance, CountsTheFewestChanges)
{
    EXPECT_EQ(rtob::edit_distance("", ""), 0u);
    EXPECT_EQ(rtob::edit_distance("", "abc"), 3u);
    EXPECT_EQ(rtob::edit_distance("kitten", "sitting"), 3u);  // k>s, e>i, +g
    EXPECT_EQ(rtob::edit_distance("flaw", "lawn"), 2u);       // -f, +n
    EXPECT_EQ(rtob::edit_distance("abdc", "abc"), 1u);
}

TEST(EditDistance, IsBlindToCaseAndSymmetric)
{
    EXPECT_EQ(rtob::edit_distance("ABC", "abc"), 0u);
    EXPECT_EQ(rtob::edit_distance("window", "Widow"), rtob::edit_distance("Widow", "window"));
}

TEST(NearestName, TakesTheFirstOfTheNearest)
{
    EXPECT_EQ(rtob::nearest_name("seed", {"speed", "seeds", "need"}), "speed");
    EXPECT_EQ(rtob::nearest_name("max_rnage_m", {"min_range_m", "max_range_m"}), "max_range_m");
}

TEST(NearestName, IsEmptyWhenNothingIsNear)
{
    EXPECT_EQ(rtob::nearest_name("window", {"exp", "uniform"}), "");
    EXPECT_EQ(rtob::nearest_name("window", {}), "");
    EXPECT_EQ(rtob::nearest_name("ab", {"ax", "cd"}), "ax");  // one of two letters is half
}

TEST(Suggestion, ListsAllNamesWhenNoneIsNear)
{
    EXPECT_EQ(rtob::suggestion("sed", {"seed", "out"}), "; did you mean 'seed'?");
    EXPECT_EQ(rtob::suggestion("window", {"seed", "out"}), "; known: seed, out");
}

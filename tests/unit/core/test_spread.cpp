// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <rtob/core/spread.h>

namespace rtob::test
{
namespace
{
TEST(Percentile, IsTheNearestRank)
{
    const std::vector<float> values{50, 10, 40, 20, 30};
    EXPECT_EQ(percentile(values, 0.5), 30);
    EXPECT_EQ(percentile(values, 0.2), 10);
    EXPECT_EQ(percentile(values, 0.21), 20);
    EXPECT_EQ(percentile(values, 1), 50);
    EXPECT_EQ(percentile(values, 0), 10);
    EXPECT_EQ(percentile({}, 0.5), 0);
}

TEST(Spread, OfAnOddNumberHasTheMiddleOne)
{
    const Spread spread = spread_of({9, 1, 4});
    EXPECT_EQ(spread.lowest, 1);
    EXPECT_EQ(spread.median, 4);
    EXPECT_EQ(spread.highest, 9);
}

TEST(Spread, OfAnEvenNumberHasTheMeanOfTheMiddleTwo)
{
    EXPECT_EQ(spread_of({8, 1, 4, 2}).median, 3);
}

TEST(Spread, OfOneValueIsThatValue)
{
    const Spread spread = spread_of({7});
    EXPECT_EQ(spread.lowest, 7);
    EXPECT_EQ(spread.median, 7);
    EXPECT_EQ(spread.highest, 7);
}

TEST(Spread, OfNothingIsZero)
{
    EXPECT_EQ(spread_of({}).median, 0);
    EXPECT_EQ(spread_of({}).highest, 0);
}
}  // namespace
}  // namespace rtob::test

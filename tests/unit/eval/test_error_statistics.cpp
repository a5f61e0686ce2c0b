// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <rtob/eval/error_statistics.h>

#include <cmath>
#include <stdexcept>

using rtob::error_statistics;

TEST(ErrorStatistics, AreTheHandComputedOnes)
{
    const auto found = error_statistics({4, 1, 3, 0});
    EXPECT_DOUBLE_EQ(found.min, 0);
    EXPECT_DOUBLE_EQ(found.max, 4);
    EXPECT_DOUBLE_EQ(found.mean, 2);
    EXPECT_DOUBLE_EQ(found.median, 2);             // between 1 and 3
    EXPECT_DOUBLE_EQ(found.sse, 26);               // 16 + 1 + 9
    EXPECT_DOUBLE_EQ(found.rmse, std::sqrt(6.5));  // 26 / 4
    EXPECT_DOUBLE_EQ(found.std, std::sqrt(2.5));   // (4 + 1 + 1 + 4) / 4
    EXPECT_DOUBLE_EQ(error_statistics({9, 1, 2}).median, 2);
}

TEST(ErrorStatistics, RmseIsMadeOfMeanAndSpread)
{
    const auto found = error_statistics({0.3, 1.7, 2.2, 0.01, 5});
    EXPECT_NEAR(found.rmse * found.rmse, found.mean * found.mean + found.std * found.std, 1e-12);
}

TEST(ErrorStatistics, OfOneErrorHaveNoSpread)
{
    const auto found = error_statistics({3});
    EXPECT_EQ(found.rmse, 3);
    EXPECT_EQ(found.median, 3);
    EXPECT_EQ(found.std, 0);
    EXPECT_THROW(static_cast<void>(error_statistics({})), std::invalid_argument);
}

// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <rtob/slam/guess_errors.h>

using rtob::GuessErrors;

namespace
{
/// After so many scans whose guess was off by 1 cm and half a degree.
GuessErrors of_good_odometry(int scans)
{
    GuessErrors errors;
    for (int i = 0; i < scans; ++i) errors.learn({0.008, -0.006, i % 2 == 0 ? 0.009 : -0.009});
    return errors;
}
}  // namespace

TEST(GuessErrors, NothingIsUnusualAtFirst)
{
    EXPECT_FALSE(GuessErrors().isUnusual({0.5, 0, 0.3}));
    EXPECT_FALSE(of_good_odometry(20).isUnusual({0.5, 0, 0.3}));
}

TEST(GuessErrors, ALargeErrorIsUnusualAfterManySmallOnes)
{
    const GuessErrors errors = of_good_odometry(500);
    // The limits: 0.05 m and three times 0.01 m, 0.02 rad and three times 0.009 rad.
    EXPECT_FALSE(errors.isUnusual({0, 0.075, 0}));
    EXPECT_TRUE(errors.isUnusual({0, 0.10, 0}));
    EXPECT_TRUE(errors.isUnusual({-0.2, 0.2, 0}));
    EXPECT_FALSE(errors.isUnusual({0, 0, -0.045}));
    EXPECT_TRUE(errors.isUnusual({0, 0, -0.06}));
}

TEST(GuessErrors, AFewWildOnesDoNotChangeWhatIsUsual)
{
    GuessErrors errors = of_good_odometry(500);
    for (int i = 0; i < 5; ++i) errors.learn({1, 1, 1});
    EXPECT_TRUE(errors.isUnusual({0.2, 0, 0}));
}

TEST(GuessErrors, OdometryThatIsOftenWrongIsNotHeldTo)
{
    GuessErrors errors = of_good_odometry(500);
    // Every fourth scan: more than the tenth that the quantile leaves out.
    for (int i = 0; i < 400; ++i) errors.learn({i % 4 == 0 ? 0.3 : 0.01, 0, 0});
    EXPECT_FALSE(errors.isUnusual({0.4, 0, 0}));
}

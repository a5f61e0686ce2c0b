// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <rtob/drivers/pilot_stick.h>

using namespace rtob;

namespace
{
AutopilotNews manual_news(std::int16_t x, std::int16_t y, std::int16_t r)
{
    AutopilotNews news;
    news.manual.time_s = 100;
    news.manual.message.x = x;
    news.manual.message.y = y;
    news.manual.message.r = r;
    return news;
}
}  // namespace

TEST(PilotStick, AWholeDeflectionIsTheTopSpeed)
{
    StickOptions options;
    options.max_speed_mps = 1.5;
    options.max_turn_dps = 90;
    const auto wish = pilot_wish(manual_news(1000, 0, -1000), options, 100.1);
    ASSERT_TRUE(wish);
    EXPECT_NEAR(wish->velocity_vehicle.x(), 1.5, 1e-12);
    EXPECT_NEAR(wish->velocity_vehicle.y(), 0, 1e-12);
    EXPECT_NEAR(wish->yaw_rate_radps, M_PI / 2, 1e-12);  // to the left
}

TEST(PilotStick, TheDeadBandIsRoundAndLeavesNoStep)
{
    const StickOptions options;  // 0.1 of the way, 1 m/s
    EXPECT_TRUE(pilot_wish(manual_news(70, 70, 90), options, 100)->velocity_vehicle.isZero());
    EXPECT_EQ(pilot_wish(manual_news(70, 70, 90), options, 100)->yaw_rate_radps, 0);
    EXPECT_NEAR(
        pilot_wish(manual_news(110, 0, 0), options, 100)->velocity_vehicle.x(), 0.01 / 0.9, 1e-12);
    // Half of the way to the right: (0.5 - 0.1) / 0.9.
    EXPECT_NEAR(
        pilot_wish(manual_news(0, 500, 0), options, 100)->velocity_vehicle.y(), -4.0 / 9, 1e-12);
    // A corner of the stick's square is no faster than its sides.
    EXPECT_NEAR(
        pilot_wish(manual_news(1000, 1000, 0), options, 100)->velocity_vehicle.norm(), 1, 1e-12);
}

TEST(PilotStick, OldSticksWishNothing)
{
    const StickOptions options;
    EXPECT_TRUE(pilot_wish(manual_news(1000, 0, 0), options, 100.49));
    EXPECT_FALSE(pilot_wish(manual_news(1000, 0, 0), options, 100.51));
    EXPECT_FALSE(pilot_wish(manual_news(1000, 0, 0), options, 99));  // the clock was set back
    EXPECT_FALSE(pilot_wish({}, options, 100));
}

TEST(PilotStick, AnAxisThatIsNotThereIsInTheMiddle)
{
    const auto wish = pilot_wish(manual_news(INT16_MAX, INT16_MIN, 0), StickOptions(), 100);
    EXPECT_TRUE(wish->velocity_vehicle.isZero());
}

TEST(PilotStick, ReadsTheChannelsThatItIsTold)
{
    AutopilotNews news;
    news.rc.time_s = 100;
    news.rc.message.chan = {2000, 1000, 1500, 65535, 1250};
    StickOptions options;
    options.source = StickSource::RcChannels;
    options.dead_band = 0;
    auto wish = pilot_wish(news, options, 100);  // roll fully right, pitch fully down
    EXPECT_NEAR(wish->velocity_vehicle.x(), std::sqrt(0.5), 1e-12);
    EXPECT_NEAR(wish->velocity_vehicle.y(), -std::sqrt(0.5), 1e-12);
    EXPECT_EQ(wish->yaw_rate_radps, 0);  // no such channel
    options.ahead_channel = 5;
    options.right_channel = 3;
    wish = pilot_wish(news, options, 100);
    EXPECT_NEAR(wish->velocity_vehicle.x(), -0.5, 1e-12);
    EXPECT_EQ(wish->velocity_vehicle.y(), 0);
    options.source = StickSource::ManualControl;
    EXPECT_FALSE(pilot_wish(news, options, 100));  // a receiver is no joystick
}

TEST(StickOptions, RefuseAChannelThatIsNone)
{
    StickOptions options;
    options.turn_right_channel = 0;
    EXPECT_THROW(options.validate(), std::invalid_argument);
    options.turn_right_channel = -19;
    EXPECT_THROW(options.validate(), std::invalid_argument);
}

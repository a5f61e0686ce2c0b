// SPDX-License-Identifier: BSD-3-Clause
#include <error_message.h>
#include <gmock/gmock.h>
#include <mrpt/config/CConfigFileMemory.h>
#include <onboard_config.h>

using namespace rtob;
using namespace rtob::test;
using testing::HasSubstr;

namespace
{
OnboardConfig loaded(const std::string& more)
{
    mrpt::config::CConfigFileMemory ini;
    ini.setContent("[Laser]\ndriver = RtobRplidar\nprocess_rate = 100\n" + more);
    return load_onboard_config(ini);
}
}  // namespace

TEST(PilotConfig, IsOffUnlessAskedFor)
{
    EXPECT_FALSE(loaded("").pilot.enabled);
    EXPECT_FALSE(loaded("[Guard]\nguide_deg = 30\n").pilot.enabled);
}

TEST(PilotConfig, HoldsGuardVehicleAndSticks)
{
    const OnboardConfig config = loaded(
        "[Autopilot]\nlink = udp:127.0.0.1:14540\n[Pilot]\nenabled = true\n"
        "[Guard]\nunknown = creep\n[VehicleLimits]\nradius_m = 0.2\n"
        "[Stick]\nsource = rc_channels\nahead_channel = 3\n");
    EXPECT_TRUE(config.pilot.enabled);
    EXPECT_EQ(config.run.guard.unknown, UnknownPolicy::Creep);
    EXPECT_EQ(config.run.vehicle.radius_m, 0.2);
    EXPECT_EQ(config.stick.source, StickSource::RcChannels);
    EXPECT_EQ(config.stick.ahead_channel, 3);
}

TEST(PilotConfig, NeedsAnAutopilotAndEnoughDecisions)
{
    EXPECT_THAT(
        error_message([] { static_cast<void>(loaded("[Pilot]\nenabled = true\n")); }),
        HasSubstr("set [Autopilot] link"));
    EXPECT_THAT(
        error_message(
            []
            {
                static_cast<void>(
                    loaded("[Autopilot]\nlink = udp:127.0.0.1:14540\n"
                           "[Pilot]\nenabled = true\ncommand_hz = 15\n"));
            }),
        HasSubstr("2 / [VehicleLimits] period_s"));
}

// SPDX-License-Identifier: BSD-3-Clause
#include <error_message.h>
#include <gmock/gmock.h>
#include <mrpt/config/CConfigFileMemory.h>
#include <mrpt/core/exceptions.h>
#include <onboard_config.h>
#include <rtob/drivers/register_drivers.h>
#include <sensor_runner.h>

using namespace rtob;
using namespace rtob::test;
using testing::AllOf;
using testing::HasSubstr;

namespace
{
std::string refusal(const std::string& content)
{
    register_drivers();
    mrpt::config::CConfigFileMemory ini;
    ini.setContent(content);
    return error_message([&] { static_cast<void>(load_onboard_config(ini)); });
}

const std::string laser = "[Laser]\ndriver = RtobRplidar\nprocess_rate = 100\n";
}  // namespace

TEST(OnboardConfig, RefusesAMisspeltKeyOfASensor)
{
    EXPECT_THAT(
        refusal(laser + "COM_prt_LIN = /dev/ttyUSB0\n"),
        AllOf(
            HasSubstr("section Laser"), HasSubstr("unknown key 'COM_prt_LIN'"),
            HasSubstr("did you mean 'COM_port_LIN'")));
    EXPECT_THAT(refusal(laser + "pose_yaw = ninety\n"), HasSubstr("'ninety' is not a number"));
}

TEST(OnboardConfig, SaysWhatMrptsDriversRefuseAndWhere)
{
    const std::string message = refusal(
        "[Second]\ndriver = CHokuyoURG\nprocess_rate = 20\npose_x = 1\nIP_DIR = 127.0.0.1\n"
        "exclusionZone1_x = 1 2 3\nexclusionZone1_y = 1 2\n");
    EXPECT_THAT(message, HasSubstr("section [Second], "));
    EXPECT_THAT(message, Not(HasSubstr(".cpp:")));
}

TEST(OnboardConfig, TellsAFileWithoutSensorsWhatItLacks)
{
    EXPECT_THAT(refusal("[Draw]\npoints = 900\n"), HasSubstr("no section has a key `driver`"));
    // Even where it is one of another program.
    EXPECT_THAT(refusal("[MappingApplication]\nx = 1\n"), HasSubstr("config/onboard.ini"));
    EXPECT_THAT(refusal(laser + "rawlog-grabber-ignore = true\n"), HasSubstr("switched off"));
}

TEST(OnboardConfig, RefusesALinkThatIsNeitherPortNorAddress)
{
    EXPECT_THAT(
        refusal(laser + "[Autopilot]\nlink = upd:127.0.0.1:14540\n"),
        AllOf(HasSubstr("[Autopilot]"), HasSubstr("link = upd:"), HasSubstr("udp:HOST:PORT")));
}

TEST(PlainMessage, LeavesOutMrptsPlaceAndCalls)
{
    try
    {
        THROW_EXCEPTION("no such port: /dev/[x]");
    }
    catch (const std::exception& error)
    {
        EXPECT_EQ(plain_message(error), "no such port: /dev/[x]");
    }
    EXPECT_EQ(plain_message(std::runtime_error("first\nsecond")), "first");
}

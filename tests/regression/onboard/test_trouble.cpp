// SPDX-License-Identifier: BSD-3-Clause
#include "held_thread.h"
#include "onboard_capture.h"

namespace rtob::test
{
namespace
{
using devices::RplidarOnTerminal;
using testing::HasSubstr;

TEST_F(Onboard, AMissingSensorDoesNotStopTheOthers)
{
    const RplidarOnTerminal laser(laserPort(), devices::model_a2(), house_from(unix_time_s()));
    RunningProgram program(
        RTOB_ONBOARD, {write("[Second]\ndriver = RtobRplidar\nprocess_rate = 50\n"
                             "sensorLabel = SECOND\nCOM_port_LIN = /dev/not-there\n")});
    EXPECT_TRUE(states_.waitForMore(10));
    program.send(SIGINT);
    const auto result = program.wait();
    EXPECT_EQ(0, result.exit_code) << result.err;
    EXPECT_THAT(result.out, HasSubstr("Second: serial port /dev/not-there cannot be opened"));
    EXPECT_GE(read_capture(logged(flights()[0])).poses.size(), 10u);
}

/// As MRPT's socket does for ever where the laser hangs up at the wrong moment.
TEST_F(Onboard, TellsOfADriverThatHangs)
{
    if (!may_hold_threads()) GTEST_SKIP() << "ptrace is not allowed here";
    const RplidarOnTerminal laser(laserPort(), devices::model_a2(), house_from(unix_time_s()));
    RunningProgram program(RTOB_ONBOARD, {write()});
    ASSERT_TRUE(states_.waitForMore(10));
    {
        const HeldThread held(program.id(), "Laser");
        wait_s(22);
    }
    EXPECT_TRUE(states_.waitForMore(10));
    program.send(SIGTERM);
    const auto result = program.wait();
    EXPECT_EQ(0, result.exit_code) << result.err;
    EXPECT_THAT(result.out, HasSubstr("Laser: its driver hangs"));
    EXPECT_THAT(result.out, HasSubstr("Laser: all is well again"));
}

TEST_F(Onboard, CheckTellsWhatItSees)
{
    const RplidarOnTerminal laser(laserPort(), devices::model_a2(), house_from(unix_time_s()));
    const auto good = run_program(RTOB_ONBOARD, {write(), "--check"});
    EXPECT_EQ(0, good.exit_code) << good.out << good.err;
    EXPECT_THAT(good.out, HasSubstr("RPLidar A2M8"));
    EXPECT_THAT(good.out, HasSubstr("ok    [Laser] port " + laserPort() + " is /dev/pts/"));
    EXPECT_THAT(good.out, HasSubstr(" Hz, "));
    EXPECT_TRUE(flights().empty());
}

TEST_F(Onboard, CheckFailsWithoutALaser)
{
    const auto bad = run_program(RTOB_ONBOARD, {write(), "--check"});
    EXPECT_EQ(1, bad.exit_code);
    EXPECT_THAT(bad.out, HasSubstr("FAIL  [Laser]"));
    EXPECT_THAT(bad.out, HasSubstr("port " + laserPort() + ": No such file"));
}

TEST_F(Onboard, RefusesAnUnknownDriverAndAnUnknownKey)
{
    const auto driver = run_program(
        RTOB_ONBOARD, {folder_.write("bad.ini", "[Laser]\ndriver = CLaser\nprocess_rate = 5\n")});
    EXPECT_EQ(1, driver.exit_code);
    EXPECT_THAT(driver.err, HasSubstr("driver = CLaser is unknown"));
    const auto key = run_program(RTOB_ONBOARD, {write("[Onboard2]\nx = 1\n")});
    EXPECT_THAT(key.err, HasSubstr("unknown section [Onboard2]; did you mean 'Onboard'?"));
    EXPECT_EQ(2, run_program(RTOB_ONBOARD, {}).exit_code);
}

/// As when a computer without a clock on board hears of the time in flight.
TEST_F(Onboard, FliesOnWhenTheComputersClockIsSetBack)
{
    EmulatedAutopilot autopilot;
    const RplidarOnTerminal laser(laserPort(), devices::model_a2(), house_from(unix_time_s()));
    const std::string step = folder_.file("clock-is-set-back");
    RunningProgram program(
        "/usr/bin/env",
        {"LD_PRELOAD=" RTOB_STEPPED_CLOCK, "RTOB_CLOCK_STEPS_WITH=" + step, RTOB_ONBOARD,
         write(
             "[Autopilot]\nlink = udp:127.0.0.1:" + std::to_string(autopilot.port()) +
             "\npose_hz = 30\n")});
    ASSERT_TRUE(states_.waitForMore(20));
    static_cast<void>(folder_.write("clock-is-set-back", ""));
    const auto poses = autopilot.poses().size(), heartbeats = autopilot.heartbeats();
    ASSERT_TRUE(states_.waitForMore(30));
    program.send(SIGTERM);
    const auto result = program.wait();
    EXPECT_EQ(0, result.exit_code) << result.err;
    EXPECT_GT(autopilot.poses().size(), poses + 30);
    EXPECT_GT(autopilot.heartbeats(), heartbeats + 1);
    const auto capture = read_capture(logged(flights()[0]));
    EXPECT_TRUE(std::is_sorted(capture.scans.begin(), capture.scans.end()));
    EXPECT_GE(capture.poses.size(), 50u);
}

TEST_F(Onboard, AFullDiskStopsTheCaptureAlone)
{
    const RplidarOnTerminal laser(laserPort(), devices::model_a2(), house_from(unix_time_s()));
    // No file of this process may grow beyond this: the capture fails, as on a full disk.
    const std::string shell = "ulimit -f 40; trap '' XFSZ; exec \"$0\" \"$1\"";
    RunningProgram program("/bin/sh", {"-c", shell, RTOB_ONBOARD, write()});
    EXPECT_TRUE(states_.waitForMore(60));
    program.send(SIGTERM);
    const auto result = program.wait();
    EXPECT_EQ(1, result.exit_code);
    EXPECT_THAT(result.out, HasSubstr("cannot be written"));
    const auto capture = read_capture(logged(flights()[0]));
    EXPECT_EQ("", capture.damage);
    EXPECT_GT(
        summary_of(flights()[0])["scans"]["localised"].get<std::size_t>(), capture.poses.size());
}
}  // namespace
}  // namespace rtob::test

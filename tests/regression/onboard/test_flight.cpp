// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/devices/device_on_tcp.h>
#include <rtob/devices/hokuyo_emulator.h>
#include <rtob/devices/sick_emulator.h>
#include <rtob/io/capture_file.h>

#include "onboard_capture.h"

namespace rtob::test
{
namespace
{
using devices::DeviceOnTcp;
using devices::RplidarOnTerminal;
using testing::Contains;
using testing::HasSubstr;

/// For figures a flight is made longer: RTOB_FLIGHT_TIMES times.
std::size_t poses_of_flight(int usual)
{
    return static_cast<std::size_t>(usual * times_of("RTOB_FLIGHT_TIMES", 1));
}

template <class Device, class... Model>
std::unique_ptr<DeviceOnTcp> on_tcp(const Takeoff& takeoff, const Model&... model)
{
    return std::make_unique<DeviceOnTcp>(std::make_unique<Device>(house_from(takeoff), model...));
}

/// The section of a Hokuyo on TCP.
std::string hokuyo_at(int port)
{
    return "driver = CHokuyoURG\nprocess_rate = 200\nIP_DIR = 127.0.0.1\nPORT_DIR = " +
           std::to_string(port) + "\nsweep_s = 0.01875\nstamp_late_s = 0.025\n";
}

TEST_F(Onboard, FliesFromTheLaserToTheAutopilotAndRepeatsItFromTheLog)
{
    EmulatedAutopilot autopilot;
    RplidarOnTerminal laser(laserPort(), devices::model_a2(), house_from(takeoff_));
    const std::string flight =
        fly(write(
                "[Autopilot]\nlink = udp:127.0.0.1:" + std::to_string(autopilot.port()) +
                "\npose_hz = 30\n"),
            poses_of_flight(80));
    ASSERT_NE("", flight);

    // Poses in the log, against the truth at their own times.
    const auto capture = read_capture(logged(flight));
    EXPECT_EQ("", capture.damage);
    ASSERT_GE(capture.poses.size(), 80u);
    EXPECT_GE(capture.attitudes, 50u);
    expectTheTruth(capture);

    // The autopilot heard them, ever newer, and in its own axes.
    const auto poses = autopilot.poses();
    EXPECT_GE(poses.size(), 80u);
    for (std::size_t i = 1; i < poses.size(); ++i)
        EXPECT_GT(poses[i].time_usec, poses[i - 1].time_usec);
    const Pose2 start = takeoff_.pose(capture.poses[0]);
    const Pose2 last =
        between(start, takeoff_.pose(1e-6 * static_cast<double>(poses.back().time_usec)));
    EXPECT_NEAR(last.x, poses.back().x, 0.1);
    EXPECT_NEAR(-last.y, poses.back().y, 0.1);
    EXPECT_GE(autopilot.heartbeats(), 5u);
    EXPECT_THAT(autopilot.texts(), Contains(HasSubstr("TRACKING")));

    // Who listens hears the poses that are in the log.
    const auto states = states_.states();
    EXPECT_EQ("TRACKING", states.back()["state"].get<std::string>());
    EXPECT_NEAR(capture.pose_map_vehicle[40].x, states[40]["x_m"].get<double>(), 1e-6);

    const auto summary = summary_of(flight);
    EXPECT_EQ(summary["scans"]["localised"], capture.poses.size());
    EXPECT_EQ(0u, summary["autopilot"]["frames_damaged"].get<unsigned>());
    for (const char* name : {"map.rtob", "map.ply", "map.pgm", "map.yaml", "summary.txt"})
        EXPECT_TRUE(std::filesystem::exists(flight + "/" + name)) << name;
    expectTheSamePosesAgain(flight);
    expectStockProgramsRead(flight);
}

TEST_F(Onboard, FliesWithMrptsOwnHokuyoDriver)
{
    const auto laser = on_tcp<devices::HokuyoEmulator>(takeoff_);
    const std::string flight = fly(writeFor(hokuyo_at(laser->port())), poses_of_flight(160));
    ASSERT_NE("", flight);
    expectTheTruth(read_capture(logged(flight)));
    expectTheSamePosesAgain(flight);
    expectStockProgramsRead(flight);
}

/// MRPT's driver sets its clock once, by the laser's eleventh scan: whatever delayed that one
/// would delay all that come after it.
TEST_F(Onboard, AScanThatIsReadLateDoesNotMakeTheNextOnesLate)
{
    const auto laser = on_tcp<devices::HokuyoEmulator>(takeoff_);
    const std::string flight =
        fly(writeFor(hokuyo_at(laser->port())), 200,
            [this](const RunningProgram& program)
            {
                program.send(SIGSTOP);
                wait_s(2);
                program.send(SIGCONT);
                EXPECT_TRUE(states_.waitForMore(20));
            });
    ASSERT_NE("", flight);
    expectTheTruth(read_capture(logged(flight)));
}

/// A Hokuyo's clock begins anew every four and a half hours, which MRPT's driver does not expect.
TEST_F(Onboard, FliesOnWhenTheLasersClockBeginsAnew)
{
    const auto laser = on_tcp<devices::HokuyoEmulator>(takeoff_, (1U << 24) - 2000U);
    const std::string flight = fly(writeFor(hokuyo_at(laser->port())), 160);
    ASSERT_NE("", flight);
    expectTheTruth(read_capture(logged(flight)));
}

/// The driver asks at its own pace, stamps when the answer has come, and says that the beams turn
/// to the right where they turn to the left: a roll of 180 degrees sets that right.
TEST_F(Onboard, FliesWithMrptsOwnSickDriver)
{
    const auto laser = on_tcp<devices::SickEmulator>(takeoff_);
    const std::string flight =
        fly(writeFor(
                "driver = CSICKTim561Eth\nprocess_rate = 15\npose_roll = 180\n"
                "ip_address = 127.0.0.1\nTCP_port = " +
                std::to_string(laser->port()) + "\nsweep_s = 0.05\nstamp_late_s = 0.12\n"),
            poses_of_flight(80));
    ASSERT_NE("", flight);
    expectTheTruth(read_capture(logged(flight)));
    expectTheSamePosesAgain(flight);
    expectStockProgramsRead(flight);
}

/// The same traps; it begins after 15 s, and what it reads it waits for 40 ms longer.
TEST_F(Onboard, FliesWithMrptsOwnLmsDriver)
{
    const auto laser = on_tcp<devices::SickEmulator>(takeoff_, devices::model_lms111());
    const std::string flight =
        fly(writeFor(
                "driver = CLMS100Eth\nprocess_rate = 25\npose_roll = 180\n"
                "ip_address = 127.0.0.1\nTCP_port = " +
                std::to_string(laser->port()) + "\nsweep_s = 0.03\nstamp_late_s = 0.1\n"),
            poses_of_flight(120));
    ASSERT_NE("", flight);
    expectTheTruth(read_capture(logged(flight)));
    expectTheSamePosesAgain(flight);
    expectStockProgramsRead(flight);
}

/// A thousand scans a second are too many: some are dropped, marked, and passed over by the replay.
TEST_F(Onboard, DropsScansThatItHasNoTimeForAndTheReplayDoes)
{
    CaptureFile log(folder_.file("house.rawlog"));
    for (int scan = 0; scan < 300; ++scan)
        log.write(scan_in_house_at(scan / 20, 1000 + 0.1 * scan));
    log.flush();
    const std::string flight = fly(
        writeFor("driver = RtobLogPlayer\nprocess_rate = 100\nspeed = 100\nfile = " + log.name()),
        20);
    ASSERT_NE("", flight);
    const auto summary = summary_of(flight);
    EXPECT_GT(summary["scans"]["dropped"].get<std::size_t>(), 0u);
    const auto capture = read_capture(logged(flight));
    EXPECT_EQ(summary["scans"]["dropped"].get<std::size_t>(), capture.dropped);
    EXPECT_EQ(capture.scans.size(), capture.poses.size() + capture.dropped);
    expectTheSamePosesAgain(flight);
}

TEST_F(Onboard, FliesALogAsIfItHappenedNow)
{
    const auto laser = on_tcp<devices::HokuyoEmulator>(takeoff_);
    const std::string first = fly(writeFor(hokuyo_at(laser->port())), 80);
    ASSERT_NE("", first);
    const auto recorded = read_capture(logged(first));
    const std::string again =
        fly(writeFor(
                "driver = RtobLogPlayer\nprocess_rate = 200\nspeed = 0.5\nfile = " + logged(first)),
            recorded.poses.size());
    ASSERT_NE("", again);
    const auto played = read_capture(logged(again));
    EXPECT_EQ(recorded.scans.size(), played.scans.size());
    // The same ranges, the same map: only the stamps differ, and with them the straightening.
    EXPECT_NEAR(recorded.pose_map_vehicle.back().x, played.pose_map_vehicle.back().x, 0.02);
    EXPECT_NEAR(recorded.pose_map_vehicle.back().y, played.pose_map_vehicle.back().y, 0.02);
}
}  // namespace
}  // namespace rtob::test

// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <rtob/devices/hokuyo_on_tcp.h>

#include "onboard_capture.h"

namespace rtob::test
{
namespace
{
using devices::RplidarOnTerminal;
using testing::Contains;
using testing::HasSubstr;

TEST_F(Onboard, FliesFromTheLaserToTheAutopilotAndRepeatsItFromTheLog)
{
    const double takeoff_s = unix_time_s();
    EmulatedAutopilot autopilot;
    RplidarOnTerminal laser(laserPort(), devices::model_a2(), house_from(takeoff_s));
    RunningProgram program(
        RTOB_ONBOARD, {write(
                          "[Autopilot]\nlink = udp:127.0.0.1:" + std::to_string(autopilot.port()) +
                          "\npose_hz = 30\n")});
    waitForCapture();
    wait_s(8);
    program.send(SIGTERM);
    const auto result = program.wait();
    ASSERT_EQ(0, result.exit_code) << result.err << result.out;
    std::cout << result.out;
    ASSERT_EQ(1u, flights().size());
    const std::string flight = flights()[0];

    // Poses in the log, against the truth at their own times.
    const auto capture = read_capture(logged(flight));
    EXPECT_EQ("", capture.damage);
    ASSERT_GE(capture.poses.size(), 60u);
    EXPECT_GE(capture.attitudes, 100u);
    const Pose2 start = flight_pose(capture.poses[0] - takeoff_s);
    EXPECT_LT(rms_error_m(capture, takeoff_s), 0.02);

    // The autopilot heard them, ever newer, and in its own axes.
    const auto poses = autopilot.poses();
    EXPECT_GE(poses.size(), 200u);
    for (std::size_t i = 1; i < poses.size(); ++i)
        EXPECT_GT(poses[i].time_usec, poses[i - 1].time_usec);
    const Pose2 last =
        between(start, flight_pose(1e-6 * static_cast<double>(poses.back().time_usec) - takeoff_s));
    EXPECT_NEAR(last.x, poses.back().x, 0.1);
    EXPECT_NEAR(-last.y, poses.back().y, 0.1);
    EXPECT_GE(autopilot.heartbeats(), 7u);
    EXPECT_THAT(autopilot.texts(), Contains(HasSubstr("TRACKING")));

    // The log gives the same poses again, to the last digit.
    const auto replay = run_program(
        RTOB_PROGRAM, {"run", logged(flight), "-c", flight + "/config.effective.ini", "-o",
                       folder_.file("replay"), "--quiet"});
    ASSERT_EQ(0, replay.exit_code) << replay.err;
    EXPECT_EQ(
        file_content(flight + "/trajectory.tum"),
        file_content(folder_.file("replay") + "/trajectory.tum"));

    const auto summary = summary_of(flight);
    EXPECT_EQ(summary["scans"]["localised"], capture.poses.size());
    for (const char* name : {"map.rtob", "map.ply", "map.pgm", "map.yaml", "summary.txt"})
        EXPECT_TRUE(std::filesystem::exists(flight + "/" + name)) << name;

    // MRPT's own programs read the capture.
    const auto info = run_program("/usr/bin/rawlog-edit", {"--info", "-i", logged(flight)});
    EXPECT_EQ(0, info.exit_code);
    EXPECT_THAT(info.out, HasSubstr("LASER, rtob.pose, rtob.scan_timing"));
    EXPECT_THAT(info.out, HasSubstr("Observations format               : Yes"));
    // icp-slam leaves its folder where it is started.
    const auto icp_slam = run_program(
        "/bin/sh", {"-c", "cd \"$0\" && exec icp-slam \"$1\" \"$2\"", folder_.path(),
                    RTOB_SOURCE_DIR "/config/mrpt-icp-slam-dense.ini", logged(flight)});
    EXPECT_EQ(0, icp_slam.exit_code) << icp_slam.out << icp_slam.err;
}

TEST_F(Onboard, ItsSensorRecordsInRawlogGrabber)
{
    const RplidarOnTerminal laser(laserPort(), devices::model_a2(), house_from(unix_time_s()));
    const std::string ini = folder_.write(
        "grabber.ini", "[global]\nrawlog_prefix = " + folder_.file("grabbed") +
                           "\n[Laser]\ndriver = RtobRplidar\nprocess_rate = 200\n"
                           "sensorLabel = LASER\nCOM_port_LIN = " +
                           laserPort() + "\nCOM_baudRate = 115200\n");
    // It ends at once where its input does, so that is held open; and by SIGINT.
    const std::string shell =
        "sleep 9 | rawlog-grabber -p \"$0\" \"$1\" & sleep 7; kill -INT $!; wait $!";
    const auto result = run_program("/bin/sh", {"-c", shell, RTOB_DRIVERS_PLUGIN, ini});
    std::size_t scans = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder_.path()))
        if (entry.path().extension() == ".rawlog") scans += read_capture(entry.path()).scans.size();
    EXPECT_GE(scans, 20u) << result.out << result.err;
}

TEST_F(Onboard, FliesWithMrptsOwnHokuyoDriver)
{
    const double takeoff_s = unix_time_s();
    devices::HokuyoOnTcp laser(house_from(takeoff_s));
    const std::string ini = folder_.write(
        "hokuyo.ini", "[Onboard]\noutput_folder = " + folder_.file("flights") +
                          "\n[Laser]\ndriver = CHokuyoURG\nprocess_rate = 200\n"
                          "sensorLabel = LASER\nIP_DIR = 127.0.0.1\nPORT_DIR = " +
                          std::to_string(laser.port()) + "\nsweep_s = 0.01875\n");
    RunningProgram program(RTOB_ONBOARD, {ini});
    waitForCapture();
    wait_s(5);
    program.send(SIGTERM);
    const auto result = program.wait();
    ASSERT_EQ(0, result.exit_code) << result.err << result.out;
    const auto capture = read_capture(logged(flights()[0]));
    ASSERT_GE(capture.poses.size(), 80u);
    EXPECT_LT(rms_error_m(capture, takeoff_s), 0.02);
    std::cout << result.out;
}

}  // namespace
}  // namespace rtob::test

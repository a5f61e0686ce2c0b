// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include <random>

#include "onboard_capture.h"

namespace rtob::test
{
namespace
{
using devices::RplidarOnTerminal;
using testing::HasSubstr;

TEST_F(Onboard, LosesAtMostTheLastSecondToKillMinus9)
{
    const RplidarOnTerminal laser(laserPort(), devices::model_a2(), house_from(unix_time_s()));
    const std::string ini = write("COM_baudRate = 115200\n");
    std::mt19937 random(static_cast<unsigned>(4));
    for (int i = 0; i < times_of("RTOB_KILLS", 3); ++i)
    {
        const auto flights_before = flights().size();
        RunningProgram program(RTOB_ONBOARD, {ini});
        while (flights().size() == flights_before) wait_s(0.01);
        waitForCapture();
        wait_s(1 + 0.001 * static_cast<double>(random() % 1000));
        const double killed_s = unix_time_s();
        program.send(SIGKILL);
        EXPECT_EQ(-1, program.wait().exit_code);
        const auto capture = read_capture(logged(flights().back()));
        ASSERT_FALSE(capture.scans.empty()) << "kill " << i;
        // A scan is older than its stamp by its sweep and its way through the packets.
        EXPECT_LT(killed_s - capture.scans.back(), 1.0 + 0.2) << "kill " << i;
        EXPECT_EQ("", capture.damage) << "kill " << i;
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
    }
}

TEST_F(Onboard, SurvivesRandomFaults)
{
    RplidarOnTerminal laser(laserPort(), devices::model_a2(), house_from(unix_time_s()));
    RunningProgram program(RTOB_ONBOARD, {write("COM_baudRate = 115200\n")});
    waitForCapture();
    std::mt19937 random(9);
    const int faults = times_of("RTOB_FAULTS", 10);
    for (int i = 0; i < faults; ++i)
    {
        const auto fault = devices::all_line_faults[random() % devices::all_line_faults.size()];
        laser.inject(fault, 0.05 + 0.001 * static_cast<double>(random() % 300));
        wait_s(0.001 * static_cast<double>(random() % 700));
    }
    wait_s(6);  // the last recovery
    const double end_s = unix_time_s();
    program.send(SIGTERM);
    const auto result = program.wait();
    EXPECT_NE(-1, result.exit_code) << result.err;
    const std::string flight = flights().back();
    const auto capture = read_capture(logged(flight));
    EXPECT_EQ("", capture.damage);
    ASSERT_FALSE(capture.scans.empty());
    EXPECT_LT(end_s - capture.scans.back(), 1.0) << "scans come again at the end";
    const auto summary = summary_of(flight);
    EXPECT_EQ(capture.poses.size(), summary["scans"]["localised"].get<std::size_t>())
        << "nothing that was captured is lost";
    double longest_s = 0;
    for (std::size_t i = 1; i < capture.scans.size(); ++i)
        longest_s = std::max(longest_s, capture.scans[i] - capture.scans[i - 1]);
    std::cout << faults << " faults, longest time without a scan " << longest_s << " s, "
              << capture.scans.size() << " scans, restarts " << summary["sensors"][0]["restarts"]
              << "\n";
}

TEST_F(Onboard, AMissingSensorDoesNotStopTheOthers)
{
    const RplidarOnTerminal laser(laserPort(), devices::model_a2(), house_from(unix_time_s()));
    RunningProgram program(
        RTOB_ONBOARD, {write("[Second]\ndriver = RtobRplidar\nprocess_rate = 50\n"
                             "sensorLabel = SECOND\nCOM_port_LIN = /dev/not-there\n")});
    waitForCapture();
    wait_s(2);
    program.send(SIGINT);
    const auto result = program.wait();
    EXPECT_EQ(0, result.exit_code) << result.err;
    EXPECT_THAT(result.out, HasSubstr("Second: serial port /dev/not-there cannot be opened"));
    EXPECT_GE(read_capture(logged(flights()[0])).poses.size(), 10u);
}

TEST_F(Onboard, CheckTellsWhatItSees)
{
    const RplidarOnTerminal laser(laserPort(), devices::model_a2(), house_from(unix_time_s()));
    const auto good = run_program(RTOB_ONBOARD, {write(), "--check"});
    EXPECT_EQ(0, good.exit_code) << good.out << good.err;
    EXPECT_THAT(good.out, HasSubstr("RPLidar A2M8"));
    EXPECT_THAT(good.out, HasSubstr(" Hz, "));
    EXPECT_TRUE(flights().empty());
}

TEST_F(Onboard, CheckFailsWithoutALaser)
{
    const auto bad = run_program(RTOB_ONBOARD, {write(), "--check"});
    EXPECT_EQ(1, bad.exit_code);
    EXPECT_THAT(bad.out, HasSubstr("FAIL  [Laser]"));
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

TEST_F(Onboard, AFullDiskStopsTheCaptureAlone)
{
    const RplidarOnTerminal laser(laserPort(), devices::model_a2(), house_from(unix_time_s()));
    // No file of this process may grow beyond this: the capture fails, as on a full disk.
    const std::string shell = "ulimit -f 40; trap '' XFSZ; exec \"$0\" \"$1\"";
    RunningProgram program("/bin/sh", {"-c", shell, RTOB_ONBOARD, write()});
    waitForCapture();
    wait_s(5);
    program.send(SIGTERM);
    const auto result = program.wait();
    EXPECT_EQ(1, result.exit_code);
    EXPECT_THAT(result.out, HasSubstr("cannot be written"));
    const auto capture = read_capture(logged(flights()[0]));
    EXPECT_EQ("", capture.damage);
    const auto summary = nlohmann::json::parse(file_content(flights()[0] + "/summary.json"));
    EXPECT_GT(summary["scans"]["localised"].get<std::size_t>(), capture.poses.size());
}
}  // namespace
}  // namespace rtob::test

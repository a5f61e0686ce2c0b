// SPDX-License-Identifier: BSD-3-Clause
#include "onboard_capture.h"
#include "sanitized.h"

namespace rtob::test
{
namespace
{
using devices::RplidarOnTerminal;
using mrpt::obs::CObservation2DRangeScan;

std::vector<CObservation2DRangeScan::Ptr> scans_in(const std::string& file)
{
    std::vector<CObservation2DRangeScan::Ptr> scans;
    const auto log = open_log(file);
    try
    {
        while (const auto entry = log->next())
            if (auto scan = std::dynamic_pointer_cast<CObservation2DRangeScan>(entry->observation))
                scans.push_back(scan);
    }
    catch (const LogError&)  // rawlog-grabber was interrupted
    {
    }
    return scans;
}

/// The emulated head takes its beams by the clock of its own scan, and nothing moves: turn for turn
/// two programs see the same.
devices::RangeSource house_at_rest()
{
    return [world = house()](double bearing_rad, double)
    { return world.range(2, 1.5, 0.3 + bearing_rad); };
}

TEST_F(Onboard, RawlogGrabberRecordsTheSameScans)
{
    if (RTOB_SANITIZED) GTEST_SKIP() << "rawlog-grabber cannot load what needs a sanitizer";
    {
        const RplidarOnTerminal laser(laserPort(), devices::model_a2(), house_at_rest());
        ASSERT_NE("", fly(write("[Sensor]\nlabels = LASER\n"), 30));
    }
    const RplidarOnTerminal laser(laserPort(), devices::model_a2(), house_at_rest());
    const std::string ini = folder_.write(
        "grabber.ini", "[global]\nrawlog_prefix = " + folder_.file("grabbed") +
                           "\n[Laser]\ndriver = RtobRplidar\nprocess_rate = 200\n"
                           "sensorLabel = LASER\nCOM_baudRate = 115200\nCOM_port_LIN = " +
                           laserPort() + "\n");
    // It ends at once where its input does, so that is held open by a pipe to nobody.
    const std::string shell =
        "mkfifo \"$2.in\" && exec 3<>\"$2.in\" && exec rawlog-grabber -p \"$0\" \"$1\" <&3";
    RunningProgram grabber(
        "/bin/sh", {"-c", shell, RTOB_DRIVERS_PLUGIN, ini, folder_.file("grabber")});
    const double limit_s = unix_time_s() + 120;
    while (!laser.isScanning() && unix_time_s() < limit_s) wait_s(0.05);
    while (laser.shaftDeg(unix_time_s()) < 60 * 360 && unix_time_s() < limit_s) wait_s(0.05);
    grabber.send(SIGINT);
    const auto result = grabber.wait();

    std::vector<CObservation2DRangeScan::Ptr> grabbed;
    for (const auto& entry : std::filesystem::directory_iterator(folder_.path()))
        if (entry.path().extension() == ".rawlog") grabbed = scans_in(entry.path());
    const auto flown = scans_in(logged(flights().back()));
    ASSERT_GE(grabbed.size(), 20u) << result.out << result.err;
    ASSERT_GE(flown.size(), 20u);
    for (std::size_t i = 0; i < 20; ++i)
    {
        const auto &a = *grabbed[i], &b = *flown[i];
        ASSERT_EQ(b.getScanSize(), a.getScanSize()) << "turn " << i;
        EXPECT_EQ(b.rightToLeft, a.rightToLeft);
        EXPECT_EQ(b.aperture, a.aperture);
        EXPECT_EQ(b.maxRange, a.maxRange);
        EXPECT_EQ(b.sensorLabel, a.sensorLabel);
        EXPECT_EQ(b.sensorPose.asTPose(), a.sensorPose.asTPose());
        for (std::size_t beam = 0; beam < a.getScanSize(); ++beam)
        {
            EXPECT_EQ(b.getScanRange(beam), a.getScanRange(beam)) << "turn " << i;
            EXPECT_EQ(b.getScanRangeValidity(beam), a.getScanRangeValidity(beam));
        }
    }
}
}  // namespace
}  // namespace rtob::test

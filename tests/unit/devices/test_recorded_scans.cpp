// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <rtob/devices/recorded_scans.h>

#include <cmath>
#include <stdexcept>

namespace rtob::devices
{
namespace
{
/// Four beams, a quarter turn apart; the ranges tell scan and beam.
RecordedScan quarters(double time_s, double first_rad, double step_rad, float scan)
{
    return {time_s, first_rad, step_rad, {scan + 0.1f, scan + 0.2f, scan + 0.3f, scan + 0.4f}};
}

constexpr double quarter_rad = M_PI / 2;

TEST(PlayScans, ABearingSeesItsNearestBeam)
{
    const auto ranges = play_scans({quarters(5, 0, quarter_rad, 1)}, 100);
    EXPECT_FLOAT_EQ(1.1f, static_cast<float>(ranges(0, 100)));
    EXPECT_FLOAT_EQ(1.1f, static_cast<float>(ranges(0.7, 100)));   // under half a step
    EXPECT_FLOAT_EQ(1.2f, static_cast<float>(ranges(0.85, 100)));  // over half a step
    EXPECT_FLOAT_EQ(1.4f, static_cast<float>(ranges(-quarter_rad, 100)));
    EXPECT_FLOAT_EQ(1.2f, static_cast<float>(ranges(quarter_rad + 4 * M_PI, 100)));
}

TEST(PlayScans, BeamsMayFollowEachOtherClockwise)
{
    const auto ranges = play_scans({quarters(5, M_PI, -quarter_rad, 1)}, 100);
    EXPECT_FLOAT_EQ(1.1f, static_cast<float>(ranges(-M_PI, 100)));
    EXPECT_FLOAT_EQ(1.2f, static_cast<float>(ranges(quarter_rad, 100)));
    EXPECT_FLOAT_EQ(1.3f, static_cast<float>(ranges(0, 100)));
}

TEST(PlayScans, SeesNothingWhereTheLogsLaserSawNothing)
{
    RecordedScan half = quarters(0, -quarter_rad, quarter_rad, 1);
    half.ranges_m.resize(3);  // from the right over the front to the left
    const auto ranges = play_scans({half}, 0);
    EXPECT_EQ(0, ranges(M_PI, 0));
    EXPECT_FLOAT_EQ(1.3f, static_cast<float>(ranges(quarter_rad, 0)));
}

TEST(PlayScans, EachScanIsSeenFromItsTimeOn)
{
    const auto ranges = play_scans(
        {quarters(5, 0, quarter_rad, 1), quarters(5.5, 0, quarter_rad, 2),
         quarters(5.25, 0, quarter_rad, 3)},  // a stamp that steps back
        100);
    EXPECT_FLOAT_EQ(1.1f, static_cast<float>(ranges(0, 90)));
    EXPECT_FLOAT_EQ(1.1f, static_cast<float>(ranges(0, 100.4)));
    EXPECT_FLOAT_EQ(3.1f, static_cast<float>(ranges(0, 100.6)));
    EXPECT_FLOAT_EQ(3.1f, static_cast<float>(ranges(0, 1e6)));
}

TEST(PlayScans, NeedsAScan)
{
    EXPECT_THROW(static_cast<void>(play_scans({}, 0)), std::invalid_argument);
}
}  // namespace
}  // namespace rtob::devices

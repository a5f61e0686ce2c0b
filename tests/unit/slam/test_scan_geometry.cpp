// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <mrpt/core/bits_math.h>
#include <rtob/core/pose2.h>
#include <rtob/slam/scan_filter.h>
#include <rtob/slam/scan_geometry.h>

#include <cmath>
#include <stdexcept>

using mrpt::DEG2RAD;
using mrpt::poses::CPose3D;
using rtob::Pose2;
using rtob::ScanGeometry;
using rtob::ScanGeometryOptions;
using rtob::Tilt;
using rtob::Twist2;

namespace
{
constexpr double kFloat_m = 1e-5;

/// Beams all around, from straight behind counter-clockwise.
mrpt::obs::CObservation2DRangeScan round_scan(std::size_t beams, const std::vector<float>& ranges_m)
{
    mrpt::obs::CObservation2DRangeScan scan;
    scan.aperture = static_cast<float>(2 * M_PI * (1 - 1 / static_cast<double>(beams)));
    scan.rightToLeft = true;
    scan.resizeScan(beams);
    for (std::size_t i = 0; i < beams; ++i)
    {
        scan.setScanRange(i, ranges_m[i % ranges_m.size()]);
        scan.setScanRangeValidity(i, true);
    }
    return scan;
}

rtob::Points points_of(
    const mrpt::obs::CObservation2DRangeScan& scan, const ScanGeometry& geometry,
    rtob::BeamCounts* counts = nullptr)
{
    rtob::Points points;
    const auto its_counts = rtob::ScanFilter().filter(scan, geometry, points);
    if (counts != nullptr) *counts = its_counts;
    return points;
}
}  // namespace

TEST(SweepTiming, IsForTheMiddleOfTheSweep)
{
    ScanGeometryOptions options;
    EXPECT_EQ(rtob::sweep_timing({}, options).sweep_s, 0);
    EXPECT_EQ(rtob::sweep_timing({}, options).pose_after_stamp_s, 0);
    EXPECT_NEAR(rtob::sweep_timing(0.1, options).pose_after_stamp_s, 0.05, 1e-12);
    options.sweep_s = 0.2;
    options.stamp_at = 1;
    EXPECT_NEAR(rtob::sweep_timing({}, options).pose_after_stamp_s, -0.1, 1e-12);
    EXPECT_EQ(rtob::sweep_timing(0.1, options).sweep_s, 0.2);  // who sets it knows better
}

/// A vehicle that spins and flies sees a fixed point with each beam: one point comes out.
TEST(ScanGeometry, PutsBeamsOfAMovingVehicleWhereTheyHit)
{
    constexpr std::size_t beams = 360;
    const Twist2 twist{1.5, -0.5, 4};
    const double sweep_s = 0.18;
    auto scan = round_scan(beams, {1});
    // What each beam meets: a circle of radius 3 m around where the vehicle is in the middle.
    const double first_rad = -0.5 * scan.aperture;
    const double step_rad = scan.aperture / static_cast<double>(beams - 1);
    for (std::size_t i = 0; i < beams; ++i)
    {
        const double share = (static_cast<double>(i) + 0.5) / beams - 0.5;
        const Pose2 at = rtob::carried(twist, share * sweep_s);
        const double bearing = at.yaw + first_rad + step_rad * static_cast<double>(i);
        // |at + r (cos, sin)| = 3
        const double along = at.x * std::cos(bearing) + at.y * std::sin(bearing);
        const double range = -along + std::sqrt(along * along + 9 - at.x * at.x - at.y * at.y);
        scan.setScanRange(i, static_cast<float>(range));
    }
    const auto geometry =
        rtob::scan_geometry(CPose3D(), {}, {}, {0, sweep_s}, twist, ScanGeometryOptions());
    const auto straight = points_of(scan, geometry);
    ASSERT_EQ(straight.size(), beams);
    for (std::size_t i = 0; i < beams; ++i)
        EXPECT_NEAR(std::hypot(straight.x[i], straight.y[i]), 3, kFloat_m);

    ScanGeometryOptions off;
    off.deskew = false;
    const auto skewed =
        points_of(scan, rtob::scan_geometry(CPose3D(), {}, {}, {0, sweep_s}, twist, off));
    EXPECT_GT(std::abs(std::hypot(skewed.x[0], skewed.y[0]) - 3), 0.05);
}

TEST(ScanGeometry, LeavesTheScanOfAStandingVehicleAlone)
{
    const auto scan = round_scan(90, {1, 2, 3});
    const auto still = rtob::scan_geometry(
        CPose3D(0.1, 0.2, 0, 0.3, 0, 0), {}, {}, {0, 0.1}, {}, ScanGeometryOptions());
    const auto plain = points_of(scan, ScanGeometry{CPose3D(0.1, 0.2, 0, 0.3, 0, 0)});
    const auto points = points_of(scan, still);
    EXPECT_EQ(points.x, plain.x);
    EXPECT_EQ(points.y, plain.y);
}

/// A wall 4 m ahead, nose 20 degrees down: the beam is longer by 1 / cos 20.
TEST(ScanGeometry, LaysATiltedScanIntoThePlane)
{
    const Tilt nose_down{0, DEG2RAD(20.0)};
    const auto scan = round_scan(4, {1, 1, static_cast<float>(4 / std::cos(DEG2RAD(20.0))), 1});
    const auto geometry =
        rtob::scan_geometry(CPose3D(), nose_down, {}, {}, {}, ScanGeometryOptions());
    const auto points = points_of(scan, geometry);
    ASSERT_EQ(points.size(), 4U);
    // Four beams: half a step beside behind, right, ahead, left. The third looks 45 degrees left.
    const double c = std::cos(DEG2RAD(20.0)), half = std::sqrt(0.5);
    EXPECT_NEAR(points.x[2], 4 / c * half * c, 1e-4);
    EXPECT_NEAR(points.y[2], 4 / c * half, 1e-4);
}

TEST(ScanGeometry, DropsHitsOnFloorAndCeiling)
{
    // Nose 10 degrees down at 1 m: ahead the floor is 1 m / sin 10 = 5.76 m away.
    const Tilt nose_down{0, DEG2RAD(10.0)};
    const double to_floor_m = 1 / std::sin(DEG2RAD(10.0));
    const auto scan = round_scan(2, {static_cast<float>(to_floor_m)});
    auto turned = scan;  // beams at +-90 degrees: turn the laser by 90, so that they look fore, aft
    ScanGeometryOptions options;
    options.ceiling_height_m = 2;
    rtob::BeamCounts counts;
    const CPose3D quarter(0, 0, 0, M_PI / 2, 0, 0);
    const auto both_gone =
        points_of(turned, rtob::scan_geometry(quarter, nose_down, 1.0, {}, {}, options), &counts);
    EXPECT_EQ(both_gone.size(), 0U);
    EXPECT_EQ(counts.floor_or_ceiling, 2U);
    // Without a known ceiling only the floor's; without a height neither.
    options.ceiling_height_m = 0;
    EXPECT_EQ(
        points_of(turned, rtob::scan_geometry(quarter, nose_down, 1.0, {}, {}, options)).size(),
        1U);
    EXPECT_EQ(
        points_of(turned, rtob::scan_geometry(quarter, nose_down, {}, {}, {}, options)).size(), 2U);
    // A wall at 4 m is 30 cm above the floor: it stays.
    const auto wall = round_scan(2, {4});
    EXPECT_EQ(
        points_of(wall, rtob::scan_geometry(quarter, nose_down, 1.0, {}, {}, options)).size(), 2U);
}

/// A low robot's laser is nearer to the floor than the margin, and level: it sees walls.
TEST(ScanGeometry, KeepsTheScanOfALaserNearTheFloor)
{
    const auto scan = round_scan(8, {2});
    const auto geometry =
        rtob::scan_geometry(CPose3D(), Tilt{}, 0.05, {}, {}, ScanGeometryOptions());
    EXPECT_EQ(points_of(scan, geometry).size(), 8U);
}

TEST(ScanGeometryOptions, RefuseWhatIsOutOfRange)
{
    ScanGeometryOptions options;
    options.stamp_at = 1.5;
    EXPECT_THROW(options.validate(), std::invalid_argument);
    options = {};
    options.sweep_s = -1;
    EXPECT_THROW(options.validate(), std::invalid_argument);
}

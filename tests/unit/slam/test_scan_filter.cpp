// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <mrpt/core/bits_math.h>
#include <rtob/slam/scan_filter.h>

#include <cmath>
#include <limits>
#include <stdexcept>

using mrpt::DEG2RAD;
using mrpt::obs::CObservation2DRangeScan;
using mrpt::poses::CPose3D;
using rtob::BeamCounts;
using rtob::Points;
using rtob::ScanFilter;
using rtob::ScanFilterOptions;

namespace
{
constexpr double pi = 3.14159265358979323846;
constexpr double kFloat_m = 2e-6;
const CPose3D at_the_origin;

/// Beams spread evenly over the aperture, from the right to the left, all valid.
CObservation2DRangeScan scan_of(const std::vector<float>& ranges_m, double aperture_rad = pi)
{
    CObservation2DRangeScan scan;
    scan.aperture = static_cast<float>(aperture_rad);
    scan.rightToLeft = true;
    scan.resizeScan(ranges_m.size());
    for (std::size_t i = 0; i < ranges_m.size(); ++i)
    {
        scan.setScanRange(i, ranges_m[i]);
        scan.setScanRangeValidity(i, true);
    }
    return scan;
}

std::uint64_t total(const BeamCounts& c)
{
    return c.used + c.invalid + c.not_a_number + c.not_positive + c.too_near + c.too_far +
           c.masked + c.thinned;
}
}  // namespace

TEST(ScanFilter, TurnsBeamsIntoPointsOfTheVehicle)
{
    // Right, ahead, left; the laser sits half a metre ahead of the vehicle's origin.
    Points points_vehicle;
    const auto counts =
        ScanFilter().filter(scan_of({1, 2, 3}), CPose3D(0.5, 0, 0, 0, 0, 0), points_vehicle);
    EXPECT_EQ(counts.used, 3U);
    ASSERT_EQ(points_vehicle.size(), 3U);
    const double expected[][2] = {{0.5, -1}, {2.5, 0}, {0.5, 3}};
    for (std::size_t i = 0; i < 3; ++i)
    {
        EXPECT_NEAR(points_vehicle.x[i], expected[i][0], kFloat_m);
        EXPECT_NEAR(points_vehicle.y[i], expected[i][1], kFloat_m);
    }
}

TEST(ScanFilter, ReadsScansThatRunFromTheLeft)
{
    auto scan = scan_of({1, 2, 3});
    scan.rightToLeft = false;
    Points points_vehicle;
    ScanFilter().filter(scan, at_the_origin, points_vehicle);
    ASSERT_EQ(points_vehicle.size(), 3U);
    EXPECT_NEAR(points_vehicle.y[0], 1, kFloat_m);
    EXPECT_NEAR(points_vehicle.y[2], -3, kFloat_m);
}

TEST(ScanFilter, SeesAScanAsMrptDoes)
{
    const CPose3D pose_vehicle_laser(0.1, -0.2, 0.3, 0.5, 0.1, pi);  // turned, tilted, hanging
    auto scan = scan_of(std::vector<float>(361, 2.5f), 1.7);
    scan.sensorPose = pose_vehicle_laser;
    Points points_vehicle;
    ScanFilter().filter(scan, pose_vehicle_laser, points_vehicle);
    ASSERT_EQ(points_vehicle.size(), 361U);
    for (std::size_t i = 0; i < 361; ++i)
    {
        const double bearing_rad = scan.getScanAngle(i);
        mrpt::math::TPoint3D point;
        pose_vehicle_laser.composePoint(
            2.5 * std::cos(bearing_rad), 2.5 * std::sin(bearing_rad), 0, point.x, point.y, point.z);
        EXPECT_NEAR(points_vehicle.x[i], point.x, kFloat_m);
        EXPECT_NEAR(points_vehicle.y[i], point.y, kFloat_m);
    }
}

TEST(ScanFilter, KeepsTheBordersOfTheRange)
{
    ScanFilterOptions options;
    options.min_range_m = 0.5;
    options.max_range_m = 8;
    Points points_vehicle;
    const auto counts = ScanFilter(options).filter(
        scan_of({0.5f, 8, std::nextafter(0.5f, 0.0f), std::nextafter(8.0f, 9.0f)}), at_the_origin,
        points_vehicle);
    EXPECT_EQ(counts.used, 2U);
    EXPECT_EQ(counts.too_near, 1U);
    EXPECT_EQ(counts.too_far, 1U);
}

TEST(ScanFilter, CountsEachBeamOnceByReason)
{
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    constexpr float inf = std::numeric_limits<float>::infinity();
    ScanFilterOptions options;
    options.mask_deg = "80..100";  // the last beam
    auto scan = scan_of({nan, inf, -inf, 0, -2, 5, 0.05f, 81.83f, 3, 4});
    scan.setScanRangeValidity(0, false);  // its first reason is that it is no number
    scan.setScanRangeValidity(5, false);
    Points points_vehicle;
    const auto counts = ScanFilter(options).filter(scan, at_the_origin, points_vehicle);
    EXPECT_EQ(counts.not_a_number, 3U);
    EXPECT_EQ(counts.not_positive, 2U);
    EXPECT_EQ(counts.invalid, 1U);
    EXPECT_EQ(counts.too_near, 1U);
    EXPECT_EQ(counts.too_far, 1U);
    EXPECT_EQ(counts.masked, 1U);
    EXPECT_EQ(counts.used, 1U);
    EXPECT_EQ(counts.thinned, 0U);
    EXPECT_EQ(total(counts), 10U);
    EXPECT_EQ(points_vehicle.size(), 1U);
}

TEST(ScanFilter, MasksBearingsOfTheLaserWhateverItsMount)
{
    ScanFilterOptions options;
    options.mask_deg = "-100..-80";  // the laser's right
    Points points_vehicle;
    ScanFilter filter(options);
    filter.filter(scan_of({1, 2, 3}), CPose3D(0, 0, 0, pi, 0, 0), points_vehicle);
    ASSERT_EQ(points_vehicle.size(), 2U);
    EXPECT_NEAR(points_vehicle.x[0], -2, kFloat_m);
}

TEST(ScanFilter, ThinsToAtMostSoManyBeamsEvenly)
{
    ScanFilterOptions options;
    options.max_beams = 100;
    for (const std::size_t beams : {99U, 100U, 101U, 250U, 1081U})
    {
        Points points_vehicle;
        const auto counts = ScanFilter(options).filter(
            scan_of(std::vector<float>(beams, 1.0f)), at_the_origin, points_vehicle);
        EXPECT_LE(counts.used, 100U);
        EXPECT_GE(counts.used, beams <= 100 ? beams : 50U) << beams;
        EXPECT_EQ(total(counts), beams);
        const double first_gap = std::hypot(
            points_vehicle.x[1] - points_vehicle.x[0], points_vehicle.y[1] - points_vehicle.y[0]);
        for (std::size_t i = 2; i < points_vehicle.size(); ++i)
            EXPECT_NEAR(
                std::hypot(
                    points_vehicle.x[i] - points_vehicle.x[i - 1],
                    points_vehicle.y[i] - points_vehicle.y[i - 1]),
                first_gap, kFloat_m);
    }
}

TEST(ScanFilter, TakesScansOfNoBeamAndOfOne)
{
    Points points_vehicle;
    points_vehicle.add(1, 1);
    ScanFilter filter;
    EXPECT_EQ(total(filter.filter(scan_of({}), at_the_origin, points_vehicle)), 0U);
    EXPECT_EQ(points_vehicle.size(), 0U);
    EXPECT_EQ(filter.filter(scan_of({2}), at_the_origin, points_vehicle).used, 1U);
    EXPECT_EQ(points_vehicle.size(), 1U);
}

TEST(ScanFilter, FollowsAChangeOfTheScansShape)
{
    ScanFilter filter;
    Points used, expected;
    auto turned = scan_of({1, 2, 3});
    turned.rightToLeft = false;
    for (const auto& scan :
         {scan_of({1, 2, 3}), scan_of({1, 2, 3}, 1.0), turned, scan_of({1, 2}), scan_of({1, 2, 3})})
    {
        filter.filter(scan, at_the_origin, used);
        ScanFilter().filter(scan, at_the_origin, expected);
        EXPECT_EQ(used.x, expected.x);
        EXPECT_EQ(used.y, expected.y);
    }
}

TEST(BeamCounts, AddUp)
{
    BeamCounts a{1, 2, 3, 4, 5, 6, 7, 8};
    a += BeamCounts{10, 20, 30, 40, 50, 60, 70, 80};
    EXPECT_EQ(a.used, 11U);
    EXPECT_EQ(a.invalid, 22U);
    EXPECT_EQ(a.not_a_number, 33U);
    EXPECT_EQ(a.not_positive, 44U);
    EXPECT_EQ(a.too_near, 55U);
    EXPECT_EQ(a.too_far, 66U);
    EXPECT_EQ(a.masked, 77U);
    EXPECT_EQ(a.thinned, 88U);
}

TEST(ScanFilterOptions, RefusesValuesOutOfRange)
{
    EXPECT_THROW(ScanFilter({-0.1, 40, "", 720}), std::invalid_argument);
    EXPECT_THROW(ScanFilter({1, 1, "", 720}), std::invalid_argument);
    EXPECT_THROW(ScanFilter({0.1, 40, "all", 720}), std::invalid_argument);
    EXPECT_THROW(ScanFilter({0.1, 40, "", 9}), std::invalid_argument);
}

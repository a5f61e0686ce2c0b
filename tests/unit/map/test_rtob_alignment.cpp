// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <mrpt/maps/CMultiMetricMap.h>
#include <mrpt/maps/COccupancyGridMap2D.h>
#include <mrpt/poses/CPose3DPDFGaussian.h>
#include <mrpt/poses/CPosePDFGaussian.h>
#include <rtob/map/conversions.h>
#include <rtob/map/rtob_alignment.h>
#include <rtob/map/rtob_map.h>

#include "near_pose.h"
#include "room_mrpt.h"

#include <cmath>

using mrpt::maps::CSimplePointsMap;
using mrpt::poses::CPose2D;
using mrpt::poses::CPose3D;
using rtob::Pose2;
using rtob::RtobAlignment;
using rtob::RtobAlignmentResult;
using rtob::RtobMap;
using rtob::to_pose2;
using rtob::test::IsNearPose;
using rtob::test::points_map;
using rtob::test::room_4x3;

namespace
{
// The very scan that is matched lies in the map, so the fit is exact.
const Pose2 truth{1.5, 1.0, 0.4};
const Pose2 guess{1.6, 0.9, 0.33};

RtobMap rtob_map()
{
    rtob::RtobMapOptions options;
    options.density.density = rtob::Density::Uniform;
    RtobMap map(options);
    map.insertScan(map.tick(1), truth, room_4x3().scan_vehicle(truth).view());
    return map;
}

CSimplePointsMap scan()
{
    return points_map(room_4x3().scan_vehicle(truth));
}
}  // namespace

TEST(RtobAlignment, FindsThePoseInAnRtobMap)
{
    const RtobMap map = rtob_map();
    const auto scan_vehicle = scan();
    RtobAlignment alignment;
    RtobAlignmentResult result;
    const auto pose = alignment.Align(&map, &scan_vehicle, rtob::to_cpose2d(guess), result);
    // 1 mm and 0.05 degrees: what the core promises of noise-free worlds.
    EXPECT_THAT(to_pose2(pose->getMeanVal()), IsNearPose(truth, 0.001, 0.0009));
    EXPECT_EQ(result.pairs, 360u);
    EXPECT_EQ(result.paired_share, 1.0);
    EXPECT_LT(result.mean_squared_error, 1e-6);
    // It stops once it rests, which a noise-free world allows early.
    EXPECT_GE(result.iterations, 1);
    EXPECT_LE(result.iterations, rtob::IcpOptions{}.iterations);
    EXPECT_GT(result.executionTime, 0);
}

TEST(RtobAlignment, FindsThePoseInMrptsPointMap)
{
    const CSimplePointsMap map =
        points_map(rtob::test::moved(room_4x3().scan_vehicle(truth), truth));
    const auto scan_vehicle = scan();
    const auto pose = RtobAlignment().Align(&map, &scan_vehicle, rtob::to_cpose2d(guess));
    EXPECT_THAT(to_pose2(pose->getMeanVal()), IsNearPose(truth, 0.001, 0.0009));
}

TEST(RtobAlignment, FindsThePoseInAMultiMetricMap)
{
    mrpt::maps::CMultiMetricMap maps;
    maps.maps.push_back(std::make_shared<RtobMap>(rtob_map()));
    const auto scan_vehicle = scan();
    const auto pose = RtobAlignment().Align(&maps, &scan_vehicle, rtob::to_cpose2d(guess));
    EXPECT_THAT(to_pose2(pose->getMeanVal()), IsNearPose(truth, 0.001, 0.0009));
}

TEST(RtobAlignment, ShiftOfTheWorldShiftsThePose)
{
    const Pose2 shift{1000, -2000, 2.0};
    const Pose2 truth_far = rtob::compose(shift, truth), guess_far = rtob::compose(shift, guess);
    RtobMap map;
    map.insertScan(map.tick(1), truth_far, room_4x3().scan_vehicle(truth).view());
    const auto scan_vehicle = scan();
    const auto pose = RtobAlignment().Align(&map, &scan_vehicle, rtob::to_cpose2d(guess_far));
    // Floats 2 km from the origin are 0.1 mm apart.
    EXPECT_THAT(to_pose2(pose->getMeanVal()), IsNearPose(truth_far, 0.001, 0.0009));
}

TEST(RtobAlignment, ReturnsTheGuessWhereNothingIsNear)
{
    const RtobMap map = rtob_map();
    const auto scan_vehicle = scan();
    RtobAlignmentResult result;
    RtobAlignment alignment;
    const auto pose = alignment.Align(&map, &scan_vehicle, CPose2D(100, 100, 1), result);
    EXPECT_THAT(to_pose2(pose->getMeanVal()), IsNearPose(Pose2{100, 100, 1}, 0.0, 1e-15));
    EXPECT_EQ(result.pairs, 0u);

    const RtobMap empty;
    alignment.Align(&empty, &scan_vehicle, CPose2D(), result);
    EXPECT_EQ(result.pairs, 0u);
    const CSimplePointsMap no_scan;
    alignment.Align(&map, &no_scan, CPose2D(), result);
    EXPECT_EQ(result.paired_share, 0.0);
}

TEST(RtobAlignment, GivesACovarianceOfFullRank)
{
    const RtobMap map = rtob_map();
    const auto scan_vehicle = scan();
    const auto pose = RtobAlignment().Align(&map, &scan_vehicle, rtob::to_cpose2d(guess));
    mrpt::math::CMatrixDouble33 covariance;
    mrpt::poses::CPose2D mean;
    pose->getCovarianceAndMean(covariance, mean);
    EXPECT_GT(covariance.det(), 0);
    EXPECT_LT(covariance(0, 0), 1e-4);  // four walls fix the pose to less than a centimetre
}

TEST(RtobAlignment, RefusesOtherMaps)
{
    const mrpt::maps::COccupancyGridMap2D grid;
    const auto scan_vehicle = scan();
    RtobAlignment alignment;
    EXPECT_THROW(alignment.Align(&grid, &scan_vehicle, CPose2D()), std::invalid_argument);
    EXPECT_THROW(alignment.Align(&scan_vehicle, &grid, CPose2D()), std::invalid_argument);
    EXPECT_THROW(alignment.Align(nullptr, &scan_vehicle, CPose2D()), std::invalid_argument);
}

TEST(RtobAlignment, AlignsInThePlaneAtTheGuessesHeight)
{
    const RtobMap map = rtob_map();
    const auto scan_vehicle = scan();
    RtobAlignment alignment;
    const auto pose =
        alignment.Align3D(&map, &scan_vehicle, CPose3D(guess.x, guess.y, 0.7, guess.yaw, 0, 0));
    const CPose3D mean = pose->getMeanVal();
    EXPECT_THAT(to_pose2(CPose2D(mean)), IsNearPose(truth, 0.001, 0.0009));
    EXPECT_DOUBLE_EQ(mean.z(), 0.7);
    EXPECT_THROW(
        alignment.Align3D(&map, &scan_vehicle, CPose3D(0, 0, 0, 0, 0.1, 0)), std::invalid_argument);
}

TEST(Conversions, KeepPosesAndWrapYaw)
{
    EXPECT_THAT(to_pose2(CPose2D(1, 2, 3)), IsNearPose(Pose2{1, 2, 3}, 0.0, 0.0));
    EXPECT_NEAR(to_pose2(mrpt::math::TPose2D(1, 2, 7)).yaw, 7 - 2 * M_PI, 1e-15);
    const auto pose = rtob::to_tpose2d({1, 2, -3});
    EXPECT_EQ(pose.x, 1);
    EXPECT_EQ(pose.y, 2);
    EXPECT_EQ(pose.phi, -3);
    EXPECT_EQ(rtob::to_cpose2d({1, 2, -3}).phi(), -3);
}

// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <mrpt/maps/CMultiMetricMap.h>
#include <mrpt/maps/CSimpleMap.h>
#include <mrpt/slam/CMetricMapBuilderICP.h>
#include <rtob/map/conversions.h>
#include <rtob/map/rtob_map.h>

#include "near_pose.h"
#include "room_mrpt.h"

#include <memory>

using rtob::Pose2;
using rtob::RtobMap;
using rtob::test::IsNearPose;
using rtob::test::mrpt_laser;
using rtob::test::room_4x3;
using rtob::test::scan_observation;

namespace
{
/// Through the room in 60 steps of 2 cm and half a degree.
Pose2 pose_at_step(int k)
{
    return {1.0 + 0.02 * k, 1.0 + 0.005 * k, 0.0087 * k};
}

std::unique_ptr<mrpt::slam::CMetricMapBuilderICP> builder_with_rtob_map()
{
    auto builder = std::make_unique<mrpt::slam::CMetricMapBuilderICP>();
    mrpt::maps::TSetOfMetricMapInitializers maps;
    RtobMap::TMapDefinition definition;
    definition.creationOpts.draw.points = 2000;
    definition.insertionOpts.minDistBetweenLaserPoints = 0;
    maps.push_back(definition);
    builder->ICP_options.mapInitializers = maps;
    builder->ICP_options.insertionLinDistance = 0;
    builder->ICP_options.insertionAngDistance = 0;
    builder->ICP_options.localizationLinDistance = 0;
    builder->ICP_options.localizationAngDistance = 0;
    builder->ICP_options.minICPgoodnessToAccept = 0.5;
    builder->ICP_params.corresponding_points_decimation = 1;
    builder->ICP_params.thresholdDist = 0.2;
    builder->ICP_params.smallestThresholdDist = 0.02;
    builder->setVerbosityLevel(mrpt::system::LVL_ERROR);
    builder->initialize();
    return builder;
}
}  // namespace

TEST(RtobMapInMetricMapBuilderIcp, FollowsTheVehicle)
{
    const auto builder = builder_with_rtob_map();
    constexpr int steps = 60;
    for (int k = 0; k < steps; ++k)
        builder->processObservation(std::make_shared<mrpt::obs::CObservation2DRangeScan>(
            scan_observation(room_4x3(), pose_at_step(k), 0.1 * k, mrpt_laser())));

    // The builder's map begins at the first pose.
    const Pose2 moved = rtob::between(pose_at_step(0), pose_at_step(steps - 1));
    // 2 cm and half a degree over 1.2 m without odometry.
    EXPECT_THAT(
        rtob::to_pose2(mrpt::poses::CPose2D(builder->getCurrentPoseEstimation()->getMeanVal())),
        IsNearPose(moved, 0.02, 0.009));
    const auto map = builder->getCurrentlyBuiltMetricMap()->mapByClass<RtobMap>();
    ASSERT_TRUE(map);
    EXPECT_EQ(map->scans().size(), static_cast<std::size_t>(steps));
    EXPECT_NEAR(map->clock().now(), 0.1 * (steps - 1), 1e-5);

    // The run's observations make the same map again.
    mrpt::maps::CSimpleMap run;
    builder->getCurrentlyBuiltMap(run);
    RtobMap again;
    again.insertionOptions.minDistBetweenLaserPoints = 0;
    again.loadFromSimpleMap(run);
    EXPECT_EQ(again.size(), map->size());
    EXPECT_EQ(again.scans().size(), map->scans().size());
}

// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <mrpt/maps/CMultiMetricMap.h>
#include <mrpt/maps/COccupancyGridMap2D.h>
#include <mrpt/poses/CPosePDFGaussian.h>
#include <mrpt/slam/CICP.h>
#include <rtob/map/conversions.h>
#include <rtob/map/rtob_map.h>

#include "near_pose.h"
#include "room_mrpt.h"

#include <cstdint>
#include <memory>
#include <set>

using mrpt::maps::CSimplePointsMap;
using mrpt::maps::TMatchingExtraResults;
using mrpt::maps::TMatchingParams;
using mrpt::poses::CPose2D;
using mrpt::tfest::TMatchingPairList;
using rtob::Pose2;
using rtob::RtobMap;
using rtob::RtobMapOptions;
using rtob::test::IsNearPose;
using rtob::test::points_map;
using rtob::test::room_4x3;

namespace
{
const Pose2 where_mapped{1.5, 1.0, 0.1};

/// A map of which every point is drawn, so that MRPT's own matching is the truth.
RtobMap fully_drawn_map()
{
    RtobMapOptions options;
    options.density.density = rtob::Density::Uniform;
    options.draw.points = 3600;
    RtobMap map(options);
    for (int k = 0; k < 5; ++k)
    {
        const Pose2 pose{where_mapped.x + 0.05 * k, where_mapped.y, where_mapped.yaw};
        map.insertScan(map.tick(0.1 * k), pose, room_4x3().scan_vehicle(pose).view());
    }
    return map;
}

struct Matching
{
    TMatchingPairList pairs;
    TMatchingExtraResults extra;
};

Matching match(
    const mrpt::maps::CMetricMap& map, const CSimplePointsMap& scan, const Pose2& pose,
    const TMatchingParams& params)
{
    Matching m;
    map.determineMatching2D(&scan, rtob::to_cpose2d(pose), m.pairs, params, m.extra);
    return m;
}

void expect_as_mrpt(const TMatchingParams& params, const Pose2& guess)
{
    const RtobMap map = fully_drawn_map();
    const CSimplePointsMap plain(static_cast<const mrpt::maps::CPointsMap&>(map));
    const auto scan = points_map(room_4x3().scan_vehicle(where_mapped));
    const Matching ours = match(map, scan, guess, params),
                   theirs = match(plain, scan, guess, params);
    EXPECT_GT(theirs.pairs.size(), 10u);  // or nothing is compared
    ASSERT_EQ(ours.pairs.size(), theirs.pairs.size());
    EXPECT_NEAR(ours.extra.correspondencesRatio, theirs.extra.correspondencesRatio, 1e-6);
    EXPECT_NEAR(ours.extra.sumSqrDist, theirs.extra.sumSqrDist, 1e-5);
    for (std::size_t i = 0; i < ours.pairs.size(); ++i)
    {
        const auto a = ours.pairs[i], b = theirs.pairs[i];
        ASSERT_EQ(+a.localIdx, +b.localIdx);
        ASSERT_NEAR(a.errorSquareAfterTransformation, b.errorSquareAfterTransformation, 1e-5);
        ASSERT_EQ(+a.local.x, +b.local.x);
        ASSERT_EQ(+a.global.x, map.points().x[a.globalIdx]);
        ASSERT_EQ(+a.global.y, map.points().y[a.globalIdx]);
    }
}
}  // namespace

TEST(RtobMapMatching, PairsAsMrptDoes)
{
    TMatchingParams params;
    params.maxDistForCorrespondence = 0.2f;
    expect_as_mrpt(params, {1.6, 0.9, 0.15});
}

TEST(RtobMapMatching, WidensTheRadiusWithTheDistanceFromThePivot)
{
    TMatchingParams params;
    params.maxDistForCorrespondence = 0.02f;
    params.maxAngularDistForCorrespondence = 0.2f;
    params.angularDistPivotPoint = {1.6, 0.9, 0};
    expect_as_mrpt(params, {1.6, 0.9, 0.25});
}

TEST(RtobMapMatching, LooksAtEveryNthPointFromTheOffset)
{
    TMatchingParams params;
    params.maxDistForCorrespondence = 0.2f;
    params.decimation_other_map_points = 7;
    params.offset_other_map_points = 3;
    expect_as_mrpt(params, {1.6, 0.9, 0.15});
}

TEST(RtobMapMatching, KeepsOnePairForEachPointOfTheMapWhenAsked)
{
    TMatchingParams params;
    params.maxDistForCorrespondence = 0.2f;
    params.onlyUniqueRobust = true;
    const RtobMap map = fully_drawn_map();
    const auto scan = points_map(room_4x3().scan_vehicle(where_mapped));
    const Matching unique = match(map, scan, {1.6, 0.9, 0.15}, params);
    std::set<std::uint32_t> seen;
    for (const auto& pair : unique.pairs) EXPECT_TRUE(seen.insert(pair.globalIdx).second);
    params.onlyUniqueRobust = false;
    EXPECT_LT(unique.pairs.size(), match(map, scan, {1.6, 0.9, 0.15}, params).pairs.size());
    EXPECT_GT(unique.pairs.size(), 10u);
}

TEST(RtobMapMatching, FindsNothingInOrForAnEmptyMap)
{
    const auto scan = points_map(room_4x3().scan_vehicle(where_mapped));
    EXPECT_TRUE(match(RtobMap(), scan, where_mapped, {}).pairs.empty());
    const Matching none = match(fully_drawn_map(), CSimplePointsMap(), where_mapped, {});
    EXPECT_TRUE(none.pairs.empty());
    EXPECT_EQ(none.extra.correspondencesRatio, 0);
}

TEST(RtobMapMatching, RefusesWhatItCannotMatch)
{
    const RtobMap map = fully_drawn_map();
    const auto scan = points_map(room_4x3().scan_vehicle(where_mapped));
    TMatchingParams params;
    params.decimation_other_map_points = 0;
    EXPECT_THROW(match(map, scan, {}, params), std::invalid_argument);
    params = {};
    params.onlyUniqueRobust = true;
    params.onlyKeepTheClosest = false;
    EXPECT_THROW(match(map, scan, {}, params), std::invalid_argument);
    TMatchingPairList pairs;
    TMatchingExtraResults extra;
    const mrpt::maps::COccupancyGridMap2D grid;
    EXPECT_THROW(
        map.determineMatching2D(&grid, CPose2D(), pairs, {}, extra), std::invalid_argument);
}

TEST(RtobMapSample, StaysForTheSameScanOnly)
{
    RtobMapOptions options;
    options.density.density = rtob::Density::Uniform;
    options.draw.points = 100;
    options.draw.mode = rtob::DrawMode::Independent;  // strata of 18 points often agree
    RtobMap map(options);
    for (int k = 0; k < 5; ++k)
        map.insertScan(map.tick(k), where_mapped, room_4x3().scan_vehicle(where_mapped).view());
    const auto scan = room_4x3().scan_vehicle({1.5, 1.1, 0.1});
    const auto other = room_4x3().scan_vehicle({1.5, 1.2, 0.1});

    const auto first = map.sampleFor(scan.view(), {1.5, 1.0, 0}).indices;
    EXPECT_EQ(first.size(), 100u);
    EXPECT_EQ(map.sampleFor(scan.view(), {1.6, 1.0, 0.1}).origin_x, 1.5);  // kept, not drawn anew
    EXPECT_EQ(map.sampleFor(scan.view(), {1.6, 1.0, 0.1}).indices, first);
    EXPECT_NE(map.sampleFor(other.view(), {1.5, 1.0, 0}).indices, first);
    // It follows from seed, map and scan: asked again, and asked of a copy, it is the same.
    EXPECT_EQ(map.sampleFor(scan.view(), {1.5, 1.0, 0}).indices, first);
    EXPECT_EQ(RtobMap(map).sampleFor(scan.view(), {1.5, 1.0, 0}).indices, first);
    // Far away it is drawn for where the vehicle is now.
    EXPECT_EQ(map.sampleFor(scan.view(), {50, 0, 0}).origin_x, 50);
}

TEST(RtobMapSample, IsDrawnAnewWhenTheMapGrows)
{
    RtobMap map = fully_drawn_map();
    const auto scan = room_4x3().scan_vehicle(where_mapped);
    EXPECT_EQ(map.sampleFor(scan.view(), where_mapped).points.size(), 5u * 360u);
    map.insertScan(map.tick(10), where_mapped, scan.view());
    EXPECT_EQ(map.sampleFor(scan.view(), where_mapped).points.size(), 6u * 360u);
}

TEST(RtobMapDistance, IsThatOfTheSampleWhileOneIsKept)
{
    RtobMapOptions options;
    options.density.density = rtob::Density::Window;
    options.density.window_s = 1;
    RtobMap map(options);
    rtob::Points old_point, new_point;
    old_point.add(0, 0);
    new_point.add(3, 4);
    map.insertScan(map.tick(0), {}, old_point.view());
    map.insertScan(map.tick(9), {}, new_point.view());
    EXPECT_FLOAT_EQ(map.squareDistanceToClosestCorrespondence(0, 0), 0);  // of all points

    match(map, points_map(new_point), {}, {});  // draws: the window holds the new scan only
    EXPECT_FLOAT_EQ(map.squareDistanceToClosestCorrespondence(0, 0), 25);
    EXPECT_NEAR(map.squareDistanceToClosestCorrespondence(3, 4.1f), 0.01, 1e-5);
    map.insertScan(map.tick(9), {}, new_point.view());
    EXPECT_FLOAT_EQ(map.squareDistanceToClosestCorrespondence(0, 0), 0);
}

namespace
{
Pose2 aligned_by_cicp(mrpt::slam::TICPAlgorithm algorithm, const Pose2& truth, const Pose2& guess)
{
    mrpt::slam::CICP icp;
    icp.options.ICP_algorithm = algorithm;
    icp.options.corresponding_points_decimation = 1;
    icp.options.thresholdDist = 0.3;
    icp.options.thresholdAng = 0;
    icp.options.smallestThresholdDist = 0.02;
    icp.options.maxIterations = 100;
    const RtobMap map = fully_drawn_map();
    const auto scan = points_map(room_4x3().scan_vehicle(truth));
    mrpt::slam::CICP::TReturnInfo info;
    const auto pose = icp.Align(&map, &scan, rtob::to_cpose2d(guess), info);
    EXPECT_GT(info.goodness, 0.9);
    return rtob::to_pose2(pose->getMeanVal());
}
}  // namespace

// 1 cm and 0.3 degrees: neighbouring points of a wall lie up to 5 cm apart, and pairs of points
// leave a little of that.
TEST(RtobMapInCicp, ClassicFindsTheOffset)
{
    const Pose2 truth{1.55, 1.0, 0.1};
    EXPECT_THAT(
        aligned_by_cicp(mrpt::slam::icpClassic, truth, {1.6, 0.93, 0.14}),
        IsNearPose(truth, 0.01, 0.005));
}

TEST(RtobMapInCicp, LevenbergMarquardtFindsTheOffset)
{
    const Pose2 truth{1.55, 1.0, 0.1};
    EXPECT_THAT(
        aligned_by_cicp(mrpt::slam::icpLevenbergMarquardt, truth, {1.6, 0.93, 0.14}),
        IsNearPose(truth, 0.01, 0.005));
}

TEST(RtobMapInMultiMetricMap, IsWhatTheMultiMetricMapMatches)
{
    mrpt::maps::CMultiMetricMap maps;
    const auto map = std::make_shared<RtobMap>(fully_drawn_map());
    maps.maps.push_back(map);
    const auto scan = points_map(room_4x3().scan_vehicle(where_mapped));
    const auto direct = match(*map, scan, {1.6, 0.9, 0.15}, {});
    const auto through = match(maps, scan, {1.6, 0.9, 0.15}, {});
    EXPECT_GT(direct.pairs.size(), 10u);
    EXPECT_EQ(through.pairs.size(), direct.pairs.size());
    EXPECT_EQ(through.extra.sumSqrDist, direct.extra.sumSqrDist);
}

// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <near_pose.h>
#include <rtob/map/rtob_map.h>

#include <stdexcept>
#include <vector>

namespace rtob
{
namespace
{
constexpr double kPi = 3.14159265358979323846;

/// Two points ahead of the vehicle, 1 m and 2 m away.
Points ahead()
{
    Points points;
    points.add(1, 0);
    points.add(2, 0);
    return points;
}

RtobMap three_scans()
{
    RtobMap map;
    for (int k = 0; k < 3; ++k) map.insertScan(map.tick(k), {10.0 * k, 0, 0}, ahead().view());
    return map;
}

TEST(RtobMapMoveScans, PointsGoWithTheirScans)
{
    RtobMap map = three_scans();
    map.moveScans(1, {{10, 5, 0}, {20, 0, kPi / 2}});
    EXPECT_THAT(map.scans().pose(0), test::IsNearPose(Pose2{}, 0.0, 0.0));
    EXPECT_THAT(map.scans().pose(1), test::IsNearPose(Pose2({10, 5, 0}), 0.0, 0.0));
    EXPECT_THAT(map.scans().pose(2), test::IsNearPose(Pose2({20, 0, kPi / 2}), 0.0, 0.0));
    const std::vector<double> x{1, 2, 11, 12, 20, 20}, y{0, 0, 5, 5, 1, 2};
    ASSERT_EQ(map.size(), x.size());
    for (std::size_t i = 0; i < x.size(); ++i)
    {
        EXPECT_NEAR(map.points().x[i], x[i], 1e-5) << i;
        EXPECT_NEAR(map.points().y[i], y[i], 1e-5) << i;
    }
}

TEST(RtobMapMoveScans, AreFoundWhereTheyAreNow)
{
    RtobMap map = three_scans();
    map.moveScans(2, {{500, 500, 0}});
    std::vector<ScanRange> ranges;
    map.view().visits.query({499, 499, 501, 501}, map.scans(), 10, ranges);
    ASSERT_EQ(ranges.size(), 1u);
    EXPECT_EQ(ranges[0].first, 2u);
    map.view().visits.query({19, -1, 21, 1}, map.scans(), 10, ranges);
    EXPECT_TRUE(ranges.empty());
}

TEST(RtobMapMoveScans, RefusesMorePosesThanScans)
{
    RtobMap map = three_scans();
    EXPECT_THROW(map.moveScans(2, {{0, 0, 0}, {1, 0, 0}}), std::invalid_argument);
    EXPECT_EQ(map.scans().x(2), 20);
}
}  // namespace
}  // namespace rtob

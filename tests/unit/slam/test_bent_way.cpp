// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <near_pose.h>
#include <rtob/slam/bent_way.h>

#include <cmath>
#include <vector>

using namespace rtob;
using rtob::test::IsNearPose;

namespace
{
/// A way of scans, as the table and the travel log keep it.
struct Way
{
    ScanTable scans;
    TravelLog travel;

    void add(const Pose2& pose)
    {
        scans.append(static_cast<double>(scans.size()), pose, 1);
        travel.inserted(pose);
    }
};

/// Scans at x = 0, 1 ... 10 m.
Way straight_way()
{
    Way way;
    for (int i = 0; i <= 10; ++i) way.add({1.0 * i, 0, 0});
    return way;
}

std::vector<Pose2> bent(const Way& way, std::size_t first, const Pose2& end, const Pose2& end_now)
{
    std::vector<Pose2> poses;
    bend_way(way.scans, way.travel, first, end, end_now, poses);
    return poses;
}
}  // namespace

TEST(BendWay, AShiftGrowsAlongTheWay)
{
    const auto poses = bent(straight_way(), 0, {10, 0, 0}, {10, 2, 0});
    ASSERT_EQ(poses.size(), 11u);
    for (int i = 0; i <= 10; ++i)
        EXPECT_THAT(poses[i], IsNearPose(Pose2({1.0 * i, 0.2 * i, 0}), 1e-6, 0));
}

TEST(BendWay, TheBeginningStays)
{
    const Way way = straight_way();
    const auto poses = bent(way, 4, {10, 0, 0}, {10, 3, 0.1});
    ASSERT_EQ(poses.size(), 7u);  // scans 4 to 10
    EXPECT_THAT(poses.front(), IsNearPose(way.scans.pose(4), 0, 0));
}

TEST(BendWay, TheEndIsMetInPlaceAndHeading)
{
    Way way;  // a quarter of a circle
    for (int i = 0; i <= 50; ++i)
    {
        const double turn = 0.0314 * i;
        way.add({10 * std::sin(turn), 10 - 10 * std::cos(turn), turn});
    }
    const Pose2 end = way.scans.pose(50), end_now = compose(end, {0.7, -0.4, 0.2});
    EXPECT_THAT(bent(way, 0, end, end_now).back(), IsNearPose(end_now, 1e-6, 1e-9));
}

TEST(BendWay, AHeadingThatCreptIsTakenBackWhereItArose)
{
    // A straight drive of 100 m whose heading crept by 0.1 rad, evenly: it was believed an arc.
    Way way;
    Pose2 pose;
    for (int i = 0; i <= 100; ++i)
    {
        way.add(pose);
        pose = compose(pose, {1, 0, 0.001});
    }
    const auto poses = bent(way, 0, way.scans.pose(100), {100, 0, 0});
    for (int i = 0; i <= 100; ++i)
        EXPECT_THAT(poses[i], IsNearPose(Pose2({1.0 * i, 0, 0}), 0.02, 1e-4)) << i;
}

TEST(BendWay, NothingIsMovedByNothing)
{
    const Way way = straight_way();
    const auto poses = bent(way, 2, {10.5, 0, 0.3}, {10.5, 0, 0.3});
    for (std::size_t k = 0; k < poses.size(); ++k)
        EXPECT_THAT(poses[k], IsNearPose(way.scans.pose(2 + k), 1e-9, 1e-12));
}

TEST(BendWay, AWayOfOneScanMovesAsAWhole)
{
    const auto poses = bent(straight_way(), 10, {10, 0, 0}, {10, 1, 0});
    ASSERT_EQ(poses.size(), 1u);
    EXPECT_THAT(poses[0], IsNearPose(Pose2({10, 1, 0}), 1e-9, 1e-9));
}

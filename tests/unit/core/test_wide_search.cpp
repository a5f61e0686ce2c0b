// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <rtob/core/wide_search.h>
#include <worlds.h>

using namespace rtob;
using namespace rtob::test;

namespace
{
// Half a cell of 0.1 m in x and in y, and half a step of yaw at the world's few metres.
constexpr double kTolerance_m = 0.15, kTolerance_rad = 0.05;

/// The reference is denser than the scan, as a map is.
Points seen_from(const Room& room, const Pose2& pose_map_vehicle, std::size_t beams)
{
    Laser laser;
    laser.beams = beams;
    laser.step_rad = 2 * M_PI / static_cast<double>(beams);
    return moved(room.scan_vehicle(pose_map_vehicle, laser), {0, 0, pose_map_vehicle.yaw});
}
}  // namespace

TEST(WideSearch, FindsCorrectionsThatIcpDoesNotReach)
{
    for (const World& world : worlds())
    {
        const Pose2& truth = world.pose_map_vehicle;
        const Points reference = seen_from(world.room, truth, 3600);
        for (const Pose2& off : {Pose2{1.2, -0.7, 0.4}, Pose2{-1.0, 0.9, -0.6}, Pose2{0, 0, 0}})
        {
            SCOPED_TRACE(world.name);
            // The scan as pre-aligned by a guess that is wrong by `off`.
            Points scan = world.room.scan_vehicle(truth);
            scan = moved(scan, {0, 0, truth.yaw - off.yaw});
            Points shifted = moved(reference, {off.x, off.y, 0});
            WideSearch search;
            const SearchResult found = search.search(scan.view(), shifted.view(), {1.5, 0.8});
            EXPECT_NEAR(found.correction.x, off.x, kTolerance_m);
            EXPECT_NEAR(found.correction.y, off.y, kTolerance_m);
            EXPECT_NEAR(wrap_angle(found.correction.yaw - off.yaw), 0, kTolerance_rad);
            EXPECT_GT(found.score, 0.6);  // a point in the cell beside the right one counts half
        }
    }
}

TEST(WideSearch, StaysInItsWindow)
{
    const World world = l_shape();
    const Points reference = seen_from(world.room, world.pose_map_vehicle, 3600);
    const Points shifted = moved(reference, {2.0, 0, 0});
    const Points scan =
        moved(world.room.scan_vehicle(world.pose_map_vehicle), {0, 0, world.pose_map_vehicle.yaw});
    WideSearch search;
    const SearchResult found = search.search(scan.view(), shifted.view(), {0.5, 0.1});
    EXPECT_LE(std::abs(found.correction.x), 0.5 + 1e-9);
    EXPECT_LE(std::abs(found.correction.y), 0.5 + 1e-9);
    EXPECT_LT(found.score, 0.6);
}

TEST(WideSearch, FindsNothingInNothing)
{
    WideSearch search;
    Points some;
    some.add(1, 1);
    EXPECT_EQ(search.search(Points().view(), some.view(), {}).score, 0);
    EXPECT_EQ(search.search(some.view(), Points().view(), {}).score, 0);
}

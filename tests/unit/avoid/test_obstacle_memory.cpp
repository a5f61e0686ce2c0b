// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <guard_world.h>
#include <rtob/avoid/obstacle_memory.h>

using namespace rtob;
using namespace rtob::test;

namespace
{
/// A post 1 m ahead, in a room that is seen all around.
Room room_with_post(bool has_post)
{
    std::vector<Wall> walls{{-2, -2, 2, -2}, {2, -2, 2, 2}, {2, 2, -2, 2}, {-2, 2, -2, -2}};
    if (has_post) walls.push_back({1, -0.1, 1, 0.1});
    return Room(walls);
}

ScanPicture picture_of(const RoomScan& seen)
{
    DeadReckoning reckoning;
    reckoning.add(0, standing());
    ScanPicture picture{GuardOptions()};
    EXPECT_TRUE(picture.take(seen.scan, reckoning));
    return picture;
}

ScanPicture post_picture()
{
    const RoomScan seen(room_with_post(true), {}, 0);
    return picture_of(seen);
}
}  // namespace

TEST(ObstacleMemory, KeepsNothingThatTheNewestScanShows)
{
    ObstacleMemory memory{GuardOptions()};
    memory.add(post_picture(), {}, 0);
    EXPECT_EQ(memory.points_map().size, 360u);
    memory.update(post_picture(), {}, 0.1);
    EXPECT_EQ(memory.points_map().size, 0u);
}

TEST(ObstacleMemory, ForgetsWhatIsSeenFreeAndKeepsWhatIsHidden)
{
    ObstacleMemory memory{GuardOptions()};
    memory.add(post_picture(), {}, 0);
    // The post is gone; the front is not looked at, and something stands before the wall behind.
    RoomScan later(room_with_post(false), {}, 0);
    for (std::size_t beam = 0; beam < 4; ++beam) later.ranges_m[beam] = 0;
    for (std::size_t beam = 170; beam < 190; ++beam) later.ranges_m[beam] = 0.5F;
    memory.update(picture_of(later), {}, 0.1);
    const PointsView left = memory.points_map();
    std::size_t post = 0, wall_behind = 0;
    for (std::size_t i = 0; i < left.size; ++i)
    {
        post += left.x[i] > 0.9F && left.x[i] < 1.1F ? 1 : 0;
        wall_behind += left.x[i] < -1.9F ? 1 : 0;
    }
    EXPECT_GE(post, 3u);  // the beams 0 to 3 and their neighbours; the others saw it free
    EXPECT_LE(post, 6u);
    EXPECT_GE(wall_behind, 18u);
    EXPECT_EQ(left.size, post + wall_behind);
}

TEST(ObstacleMemory, FadesWithTime)
{
    GuardOptions options;
    options.memory_s = 5;
    ObstacleMemory memory(options);
    memory.add(post_picture(), {}, 10);
    const ScanPicture nothing{GuardOptions()};
    memory.update(nothing, {}, 14.9);
    EXPECT_EQ(memory.points_map().size, 360u);
    memory.update(nothing, {}, 15.1);
    EXPECT_EQ(memory.points_map().size, 0u);
}

TEST(ObstacleMemory, ForgetsTheOldestWhenFullAndWhatIsFar)
{
    GuardOptions options;
    options.memory_points = 400;
    ObstacleMemory memory(options);
    memory.add(post_picture(), {}, 0);
    memory.add(post_picture(), {100, 0, 0}, 1);
    const ScanPicture nothing{GuardOptions()};
    memory.update(nothing, {50, 0, 0}, 1);
    EXPECT_EQ(memory.points_map().size, 0u);
    memory.add(post_picture(), {}, 0);
    memory.add(post_picture(), {1, 0, 0}, 1);
    memory.update(nothing, {0.5, 0, 0}, 1);
    ASSERT_EQ(memory.points_map().size, 400u);
    float farthest = 0;
    for (std::size_t i = 40; i < 400; ++i) farthest = std::max(farthest, memory.points_map().x[i]);
    EXPECT_NEAR(farthest, 3, 0.01);  // the whole of the newer scan is there
}

TEST(ObstacleMemory, LiesInMap)
{
    ObstacleMemory memory{GuardOptions()};
    memory.add(post_picture(), {5, 3, M_PI / 2}, 0);
    // The post, 1 m ahead of a vehicle that looks along y.
    EXPECT_NEAR(memory.points_map().x[0], 5, 1e-5);
    EXPECT_NEAR(memory.points_map().y[0], 4, 1e-5);
}

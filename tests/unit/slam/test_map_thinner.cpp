// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <rtob/slam/map_thinner.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace rtob
{
namespace
{
constexpr int kCap = 10'000;
constexpr std::uint32_t kPoints = 100;  // of each scan

/// A vehicle at these poses, one after the other.
template <class PoseOf>
ScanTable scans_at(int count, const PoseOf& pose_of)
{
    ScanTable scans;
    for (int k = 0; k < count; ++k) scans.append(0.1 * k, pose_of(k), kPoints);
    return scans;
}

std::size_t kept(const std::vector<char>& keep)
{
    return static_cast<std::size_t>(std::count(keep.begin(), keep.end(), 1));
}

TEST(MapThinner, WithoutACapItIsNeverDue)
{
    const MapThinner thinner(0);
    EXPECT_FALSE(thinner.isDue(RtobMap(), 1'000'000));
}

TEST(MapThinner, IsDueBeforeTheCapIsPassed)
{
    const MapThinner thinner(kCap);
    EXPECT_FALSE(thinner.isDue(RtobMap(), kCap));
    EXPECT_TRUE(thinner.isDue(RtobMap(), kCap + 1));
}

TEST(MapThinner, KeepsTheNewestAndTheOldestOfEachPlace)
{
    // Ten rounds over ten places, 10 m from each other.
    const auto scans = scans_at(100, [](int k) { return Pose2{10.0 * (k % 10), 0, 0}; });
    MapThinner thinner(kCap);
    const auto& keep = thinner.choose(scans);
    EXPECT_LE(kept(keep) * kPoints, kCap * 8 / 10);
    EXPECT_GT(kept(keep) * kPoints, kCap * 6 / 10);
    for (int k = 0; k < 10; ++k) EXPECT_TRUE(keep[static_cast<std::size_t>(k)]) << k;
    for (int k = 80; k < 100; ++k) EXPECT_TRUE(keep[static_cast<std::size_t>(k)]) << k;
}

TEST(MapThinner, TakesFromWhereMostScansAre)
{
    // 60 scans at rest, then 40 on the way.
    const auto scans = scans_at(100, [](int k) { return Pose2{std::max(0, k - 60) * 1.0, 0, 0}; });
    MapThinner thinner(kCap);
    const auto& keep = thinner.choose(scans);
    EXPECT_LE(kept(keep) * kPoints, kCap * 8 / 10);
    for (int k = 61; k < 100; ++k) EXPECT_TRUE(keep[static_cast<std::size_t>(k)]) << k;
    EXPECT_TRUE(keep[0]);
    EXPECT_GT(std::count(keep.begin(), keep.begin() + 60, 1), 20);
}

TEST(MapThinner, OnGroundWithoutEndPlacesGetLarger)
{
    const auto scans = scans_at(1000, [](int k) { return Pose2{5.0 * k, 0, 0}; });
    MapThinner thinner(kCap);
    const auto& keep = thinner.choose(scans);
    EXPECT_LE(kept(keep) * kPoints, kCap * 8 / 10);
    EXPECT_GT(kept(keep) * kPoints, kCap * 3 / 10);
    // The old ground is not forgotten as a whole.
    EXPECT_GT(std::count(keep.begin(), keep.begin() + 500, 1), 5);
}

TEST(MapThinner, AMapUnderTheCapStaysThereForEver)
{
    RtobMap map;
    TravelLog travel;
    MapBelief belief;
    MapThinner thinner(kCap);
    thinner.makeRoom(map, travel, belief);
    const std::size_t room = map.points().size;
    EXPECT_EQ(room, 0U);
    Points points;
    for (std::uint32_t k = 0; k < kPoints; ++k) points.add(1, static_cast<float>(k));
    const float* const where = map.points().x;
    for (int k = 0; k < 20'000; ++k)
    {
        const Pose2 pose{5 * std::cos(0.01 * k), 5 * std::sin(0.01 * k), wrap_angle(0.01 * k)};
        if (thinner.isDue(map, points.size()))
        {
            const auto& keep = thinner.choose(map.scans());
            map.keepOnly(keep);
            travel.keepOnly(keep);
        }
        map.insertScan(map.tick(0.1 * k), pose, points.view());
        travel.inserted(pose);
        ASSERT_LE(map.size(), static_cast<std::size_t>(kCap));
    }
    EXPECT_EQ(map.points().x, where) << "the memory is the one of the beginning";
    EXPECT_NO_THROW((void)map.view());
    // 0.05 m a step, and what was travelled counts although its scans are gone.
    EXPECT_NEAR(travel.path(), 0.05 * 20'000, 1.0);
    EXPECT_EQ(travel.scansBefore(0), map.scans().size() - 1);
}
}  // namespace
}  // namespace rtob

// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <guard_world.h>
#include <rtob/avoid/scan_picture.h>

using namespace rtob;
using namespace rtob::test;

namespace
{
DeadReckoning moving(const VehicleMotion& motion)
{
    DeadReckoning reckoning;
    for (int i = 0; i <= 10; ++i) reckoning.add(0.1 * i, motion);
    return reckoning;
}

ScanPicture picture_of(RoomScan& seen, const GuardOptions& options = {})
{
    ScanPicture picture(options);
    EXPECT_TRUE(picture.take(seen.scan, moving(standing())));
    return picture;
}

/// In the middle of a room of 4 m x 4 m.
Room square_room()
{
    return Room({{-2, -2, 2, -2}, {2, -2, 2, 2}, {2, 2, -2, 2}, {-2, 2, -2, -2}});
}
}  // namespace

TEST(ScanPicture, TellsFreeFromSeenFromHidden)
{
    RoomScan seen(square_room(), {}, 0.5);
    const ScanPicture picture = picture_of(seen);
    EXPECT_EQ(picture.hits().size(), 360u);
    EXPECT_EQ(picture.sightOf(1.5F, 0.3F), Sight::Free);
    EXPECT_EQ(picture.sightOf(2.05F, 0.3F), Sight::Seen);
    EXPECT_EQ(picture.sightOf(1.95F, -0.9F), Sight::Seen);
    EXPECT_EQ(picture.sightOf(2.5F, 0.3F), Sight::Hidden);
}

// A beam to the wall on either side of the post does not make what is behind the post free.
TEST(ScanPicture, HidesWhatIsBehindAnEdge)
{
    auto walls = square_room().walls();
    walls.push_back({1, -0.2, 1, 0.2});
    RoomScan seen(Room(walls), {}, 0.5);
    const ScanPicture picture = picture_of(seen);
    EXPECT_EQ(picture.sightOf(1.6F, 0.0F), Sight::Hidden);
    EXPECT_EQ(picture.sightOf(1.6F, 0.33F), Sight::Hidden);  // one beam passes, one does not
    EXPECT_EQ(picture.sightOf(1.6F, 0.6F), Sight::Free);
}

TEST(ScanPicture, WithoutReturnNothingIsKnownOrEverythingIsFree)
{
    const Room one_wall({{2, -3, 2, 3}});
    RoomScan seen(one_wall, {}, 0.5, false);
    EXPECT_EQ(picture_of(seen).sightOf(-1, 0), Sight::Hidden);
    EXPECT_TRUE(picture_of(seen).isUnknown(M_PI, 0.1));
    EXPECT_FALSE(picture_of(seen).isUnknown(0, 0.1));
    GuardOptions options;
    options.no_return_is_free = true;
    EXPECT_EQ(picture_of(seen, options).sightOf(-1, 0), Sight::Free);
    EXPECT_FALSE(picture_of(seen, options).isUnknown(M_PI, 0.1));
    EXPECT_GT(picture_of(seen, options).horizon().size(), 100u);
}

TEST(ScanPicture, PassesOverNarrowHolesOnly)
{
    GuardOptions options;
    options.max_hole_deg = 6;
    RoomScan seen(square_room(), {}, 0.5);
    for (std::size_t beam = 100; beam < 106; ++beam) seen.ranges_m[beam] = 0;
    EXPECT_FALSE(picture_of(seen, options).isUnknown(M_PI * 103 / 180, 0.2));
    seen.ranges_m[106] = seen.ranges_m[107] = NAN;
    EXPECT_TRUE(picture_of(seen, options).isUnknown(M_PI * 103 / 180, 0.0));
    EXPECT_FALSE(picture_of(seen, options).isUnknown(M_PI * 103 / 180 + 0.3, 0.2));
    EXPECT_TRUE(picture_of(seen, options).isUnknown(M_PI * 103 / 180 + 0.3, 0.3));
}

TEST(ScanPicture, FindsAHoleAcrossTheFirstBearing)
{
    RoomScan seen(square_room(), {}, 0.5);
    for (std::size_t beam = 0; beam < 5; ++beam) seen.ranges_m[beam] = 0;
    for (std::size_t beam = 355; beam < 360; ++beam) seen.ranges_m[beam] = 0;
    EXPECT_TRUE(picture_of(seen).isUnknown(0, 0));
    EXPECT_TRUE(picture_of(seen).isUnknown(-0.05, 0));
    EXPECT_TRUE(picture_of(seen).isUnknown(2 * M_PI - 0.05, 0));
    EXPECT_FALSE(picture_of(seen).isUnknown(0.5, 0.2));
}

TEST(ScanPicture, IsEmptyWhenTheSensorIsCovered)
{
    RoomScan seen(square_room(), {}, 0.5);
    std::fill(seen.ranges_m.begin(), seen.ranges_m.end(), 0.0F);
    EXPECT_TRUE(picture_of(seen).isEmpty());
}

// 1 m/s towards the wall at x = 2, beams from 0.4 s to 0.9 s of travel: each is put to where it was
// taken, so that the wall stays a line, 2 - 0.9 m ahead of the vehicle at the end of the sweep.
TEST(ScanPicture, PutsEachBeamWhereItWasTaken)
{
    const Room wall({{2, -9, 2, 9}});
    const DeadReckoning reckoning = moving(flying(1, 0));
    std::vector<float> ranges_m(61);
    GuardScan scan;
    scan.stamp_s = 0.4;
    scan.sweep_s = 0.5;
    scan.first_bearing_rad = -0.5;
    scan.step_rad = 1.0 / 60;
    for (std::size_t i = 0; i < ranges_m.size(); ++i)
    {
        const double x = 0.4 + 0.5 * static_cast<double>(i) / 60;
        ranges_m[i] = static_cast<float>(
            wall.range(x, 0, scan.first_bearing_rad + scan.step_rad * static_cast<double>(i)));
    }
    scan.ranges_m = ranges_m.data();
    scan.beams = ranges_m.size();
    ScanPicture picture{GuardOptions()};
    ASSERT_TRUE(picture.take(scan, reckoning));
    ASSERT_EQ(picture.hits().size(), 61u);
    for (const float x : picture.hits().x) EXPECT_NEAR(x, 2 - 0.9, 1e-5);
}

TEST(ScanPicture, RefusesAScanOfAnotherTime)
{
    RoomScan seen(square_room(), {}, 100);
    ScanPicture picture{GuardOptions()};
    EXPECT_FALSE(picture.take(seen.scan, moving(standing())));
    EXPECT_TRUE(picture.isEmpty());
}

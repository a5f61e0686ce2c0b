// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <rtob/map/rtob_map.h>
#include <rtob/slam/relocaliser.h>

#include <optional>

#include "house.h"
#include "near_pose.h"

namespace rtob
{
namespace
{
using test::IsNearPose;

RtobMap map_of(const test::Room& room, const std::vector<Pose2>& poses)
{
    RtobMap map;
    double time_s = 0;
    for (const Pose2& pose : poses)
        map.insertScan(map.tick(time_s += 0.1), pose, room.scan_vehicle(pose).view());
    return map;
}

RtobMap map_of_the_house()
{
    std::vector<Pose2> poses;
    for (int k = 0; k < test::house_lap_scans; k += 4) poses.push_back(test::pose_in_house(k));
    return map_of(test::house(), poses);
}

struct Found
{
    std::optional<Pose2> pose;
    int scans = 0;
};

/// Follows the vehicle through the house from a scan on.
Found find_in_house(
    Relocaliser& relocaliser, const RtobMap& map, int first, bool has_odometry, int most = 10)
{
    Found found;
    while (!found.pose && found.scans < most)
    {
        const int scan = first + found.scans++;
        const auto motion = between(test::pose_in_house(scan - 1), test::pose_in_house(scan));
        const auto place = relocaliser.take(
            map.view(), test::house().scan_vehicle(test::pose_in_house(scan)),
            has_odometry ? std::optional(motion) : std::nullopt);
        if (place) found.pose = place->pose_map_vehicle;
    }
    return found;
}

TEST(Relocaliser, FindsTheVehicleFromAnywhere)
{
    const RtobMap map = map_of_the_house();
    Relocaliser relocaliser({}, {});
    for (const bool has_odometry : {false, true})
        for (int first = 2; first < test::house_lap_scans; first += 37)
        {
            relocaliser.restart();
            const Found found = find_in_house(relocaliser, map, first, has_odometry);
            ASSERT_TRUE(found.pose) << first;
            EXPECT_GE(found.scans, RelocaliseOptions().confirm_scans);
            EXPECT_THAT(
                *found.pose, IsNearPose(test::pose_in_house(first + found.scans - 1), 0.05, 0.02))
                << first;
        }
}

/// The search takes several scans, in which the vehicle drives on.
TEST(Relocaliser, FindsItWithLittleWorkAScan)
{
    const RtobMap map = map_of_the_house();
    RelocaliseOptions options;
    options.looks_per_scan = 300'000;
    for (const bool has_odometry : {false, true})
    {
        Relocaliser relocaliser(options, {});
        const Found found = find_in_house(relocaliser, map, 100, has_odometry, 60);
        ASSERT_TRUE(found.pose);
        EXPECT_GT(found.scans, options.confirm_scans);
        EXPECT_THAT(
            *found.pose, IsNearPose(test::pose_in_house(100 + found.scans - 1), 0.05, 0.02));
    }
}

/// Follows it for so many scans, with a place that is claimed for it and explains this share of
/// each.
PlaceLead lead_over(const Pose2& pose_first_claimed, double explained_share, int scans)
{
    const RtobMap map = map_of_the_house();
    Relocaliser relocaliser({}, {});
    Pose2 tracked;
    for (int k = 0; k < scans; ++k)
    {
        tracked = compose(
            pose_first_claimed, between(test::pose_in_house(60), test::pose_in_house(60 + k)));
        (void)relocaliser.take(
            map.view(), test::house().scan_vehicle(test::pose_in_house(60 + k)), std::nullopt,
            tracked);
    }
    EXPECT_GT(relocaliser.scansFollowed(), 0);
    return relocaliser.leadOver(
        tracked, PlaceEvidence::logMisfit(explained_share) * relocaliser.scansFollowed());
}

TEST(Relocaliser, ATrackedPlaceStandsAgainstAllOthersWhereItIsRight)
{
    const PlaceLead lead = lead_over(test::pose_in_house(60), 0.5, 6);
    EXPECT_EQ(lead.over_tracked, 0) << "the best place is the tracked one";
    EXPECT_EQ(lead.over_others, 0);
}

TEST(Relocaliser, ATrackedPlaceFallsWhereItIsWrong)
{
    const Pose2 other_room = test::pose_in_house(260);
    EXPECT_EQ(lead_over(other_room, 0.6, 1).over_tracked, 0) << "not confirmed yet";
    // The right place leaves some 3 cm of each point; where 0.4 of them find nothing within 20 cm,
    // the mean square is larger by exp(2.8).
    const PlaceLead lead = lead_over(other_room, 0.6, 4);
    EXPECT_GT(lead.over_tracked, 4 * 2.0);
    EXPECT_LT(lead.over_tracked, 4 * 5.0);
    EXPECT_GT(lead.over_others, 0);
    // Where the tracked place explains as much, there is next to no lead.
    EXPECT_LT(lead_over(other_room, 1, 4).over_tracked, 0.5 * lead.over_tracked);
}

/// A room that looks the same after half a turn. Its walls lie in the middle of raster cells: on
/// their borders, the rounding of each point would tell the places apart.
TEST(Relocaliser, BelievesNeitherOfTwoPlacesThatLookAlike)
{
    constexpr double x0 = 0.05, x1 = 8.05, y0 = 0.05, y1 = 5.05;
    const test::Room room({{x0, y0, x1, y0}, {x1, y0, x1, y1}, {x1, y1, x0, y1}, {x0, y1, x0, y0}});
    const RtobMap map = map_of(room, {{2, 2, 0}, {4, 2.5, 1}, {6, 3, 2}});
    Relocaliser relocaliser({}, {});
    for (int k = 0; k < 30; ++k)
        EXPECT_FALSE(relocaliser.take(map.view(), room.scan_vehicle({3, 2, 0.5}), Pose2{})) << k;
}

TEST(Relocaliser, FindsNothingInAnotherWorld)
{
    const RtobMap map = map_of_the_house();
    std::vector<test::Wall> walls;
    test::add_circle(walls, 0, 0, 5);
    const Points elsewhere = test::Room(walls).scan_vehicle({});
    Relocaliser relocaliser({}, {});
    for (int k = 0; k < 20; ++k)
        EXPECT_FALSE(relocaliser.take(map.view(), elsewhere, Pose2{})) << k;
}

TEST(RelocaliseOptions, RefusesWhatMakesNoSense)
{
    RelocaliseOptions options;
    EXPECT_NO_THROW(options.validate());
    options.max_scans = options.confirm_scans - 1;
    EXPECT_THROW(options.validate(), std::invalid_argument);
    options = {};
    options.min_score = 0;
    EXPECT_THROW(options.validate(), std::invalid_argument);
}
}  // namespace
}  // namespace rtob

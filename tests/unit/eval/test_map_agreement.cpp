// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <rtob/eval/map_agreement.h>
#include <rtob/eval/map_overlay.h>

#include <cmath>
#include <limits>

#include "near_pose.h"

namespace rtob::test
{
namespace
{
constexpr double kSpacing_m = 0.02;

void add_wall(Points& points, double x0, double y0, double x1, double y1)
{
    const double length_m = std::hypot(x1 - x0, y1 - y0);
    const int steps = static_cast<int>(std::lround(length_m / kSpacing_m));
    for (int k = 0; k <= steps; ++k)
    {
        const double share = static_cast<double>(k) / steps;
        points.add(
            static_cast<float>(x0 + share * (x1 - x0)), static_cast<float>(y0 + share * (y1 - y0)));
    }
}

/// An L of 28 m of walls that fits itself in one way only.
Points l_shaped_room()
{
    Points points;
    add_wall(points, -1, -1, 5, -1);
    add_wall(points, 5, -1, 5, 2);
    add_wall(points, 5, 2, 2, 2);
    add_wall(points, 2, 2, 2, 7);
    add_wall(points, 2, 7, -1, 7);
    add_wall(points, -1, 7, -1, -1);
    return points;
}

Points seen_from(const Pose2& pose_map_other, const Points& points_map)
{
    const double c = std::cos(pose_map_other.yaw), s = std::sin(pose_map_other.yaw);
    Points points;
    for (std::size_t i = 0; i < points_map.size(); ++i)
    {
        const double x = points_map.x[i] - pose_map_other.x, y = points_map.y[i] - pose_map_other.y;
        points.add(static_cast<float>(c * x + s * y), static_cast<float>(c * y - s * x));
    }
    return points;
}

TEST(MapAgreement, FindsHowAMapIsTurnedAndShifted)
{
    const Points reference = l_shaped_room();
    for (const Pose2& pose : {Pose2{}, Pose2{1.2, -0.7, 2.0}, Pose2{-2.5, 3, -3.1}})
    {
        const auto agreement = map_agreement(seen_from(pose, reference).view(), reference.view());
        // Points 2 cm apart, of which one in 5 cm is kept: some mm are left.
        EXPECT_THAT(agreement.pose_reference_estimate, IsNearPose(pose, 0.01, 0.005));
        EXPECT_EQ(agreement.estimate_share, 1);
        EXPECT_EQ(agreement.reference_share, 1);
        EXPECT_LT(agreement.mean_distance_m, 0.03);
    }
}

TEST(MapAgreement, WhatOnlyOneMapHoldsIsNotShared)
{
    const Points room = l_shaped_room();
    Points more = room;
    add_wall(more, 12, -1, 12, 6);  // 7 m beside 28 m
    const auto agreement = map_agreement(room.view(), more.view());
    EXPECT_THAT(agreement.pose_reference_estimate, IsNearPose(Pose2{}, 0.01, 0.005));
    EXPECT_EQ(agreement.estimate_share, 1);
    EXPECT_NEAR(agreement.reference_share, 28.0 / 35.0, 0.01);
    const auto swapped = map_agreement(more.view(), room.view());
    EXPECT_NEAR(swapped.estimate_share, 28.0 / 35.0, 0.01);
    EXPECT_EQ(swapped.reference_share, 1);
}

TEST(MapAgreement, AWallSeenAThousandTimesCountsOnce)
{
    Points often = l_shaped_room();
    for (int k = 0; k < 1000; ++k) add_wall(often, 5, -1, 5, 2);
    Points moved_wall = l_shaped_room();
    add_wall(moved_wall, 3, -1, 3, 2);  // 3 m that the other map does not hold
    const auto agreement = map_agreement(moved_wall.view(), often.view());
    EXPECT_NEAR(agreement.estimate_share, 1 - 2.8 / 31, 0.01);  // its ends touch the room's walls
    EXPECT_LT(agreement.reference_cells, 700U);                 // 28 m in cells of 5 cm
}

TEST(MapAgreement, NeedsPointsAndLengths)
{
    const Points room = l_shaped_room();
    EXPECT_THROW(static_cast<void>(map_agreement({}, room.view())), std::invalid_argument);
    EXPECT_THROW(static_cast<void>(map_agreement(room.view(), {})), std::invalid_argument);
    Points nowhere;
    nowhere.add(std::numeric_limits<float>::quiet_NaN(), 0);
    EXPECT_THROW(
        static_cast<void>(map_agreement(nowhere.view(), room.view())), std::invalid_argument);
    MapAgreementOptions options;
    options.tolerance_m = 0;
    EXPECT_THROW(
        static_cast<void>(map_agreement(room.view(), room.view(), options)), std::invalid_argument);
}

/// Pixels of the picture that are clearly of one ink.
struct Inks
{
    int red = 0, blue = 0, both = 0;
};

Inks inks_of(const Points& reference, const Points& estimate)
{
    MapOverlayInput input;
    input.points_reference = reference.view();
    input.points_estimate = estimate.view();
    const cv::Mat picture = draw_map_overlay(input);
    Inks inks;
    for (int row = 0; row < picture.rows; ++row)
        for (int column = 0; column < picture.cols; ++column)
        {
            const auto& bgr = picture.at<cv::Vec3b>(row, column);
            const bool is_blue = bgr[0] > bgr[2] + 100, is_red = bgr[2] > bgr[0] + 100;
            inks.blue += is_blue;
            inks.red += is_red;
            inks.both += bgr[0] < 110 && bgr[1] < 110 && bgr[2] < 110;
        }
    return inks;
}

TEST(MapOverlay, OneMapOnItselfIsOfNeitherColour)
{
    const Points room = l_shaped_room();
    const Inks same = inks_of(room, room);
    const Inks apart = inks_of(room, seen_from({0.5, 0.5, 0}, room));
    EXPECT_EQ(same.red + same.blue, 0);
    EXPECT_GT(same.both, 1000);
    EXPECT_GT(apart.red, 1000);
    EXPECT_GT(apart.blue, 1000);
    EXPECT_LT(apart.both, same.both / 10);
}
}  // namespace
}  // namespace rtob::test

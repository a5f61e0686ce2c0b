// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <rtob/slam/map_options.h>

#include <stdexcept>

#include "near_pose.h"

namespace rtob
{
namespace
{
MapOptions with_pose(const std::string& text)
{
    MapOptions options;
    options.file = "a.rtob";
    options.initial_pose = text;
    return options;
}

TEST(MapOptions, TheInitialPoseIsInMetresAndDegrees)
{
    EXPECT_FALSE(with_pose("").initialPose());
    const auto pose = with_pose("1.5,-2,90").initialPose();
    ASSERT_TRUE(pose);
    EXPECT_THAT(*pose, test::IsNearPose(Pose2{1.5, -2, 1.5707963267948966}, 1e-12, 1e-12));
}

TEST(MapOptions, AnythingElseIsNoPose)
{
    for (const char* text : {"1", "1,2", "1,2,3,4", "1,2,3,", ",,", "a,b,c", "1,2,inf", "1;2;3"})
        EXPECT_THROW(with_pose(text).validate(), std::invalid_argument) << text;
    EXPECT_NO_THROW(with_pose("0,0,-180").validate());
}

TEST(MapOptions, LocalisingNeedsAMapAndACapNeedsRoom)
{
    MapOptions options;
    options.localize = true;
    EXPECT_THROW(options.validate(), std::invalid_argument);
    options.file = "a.rtob";
    EXPECT_NO_THROW(options.validate());
    options.max_points = 9999;
    EXPECT_THROW(options.validate(), std::invalid_argument);
    MapOptions pose_without_map;
    pose_without_map.initial_pose = "0,0,0";
    EXPECT_THROW(pose_without_map.validate(), std::invalid_argument);
}
}  // namespace
}  // namespace rtob

// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/core/pose2.h>
#include <cstdio>

int main()
{
    const rtob::Pose2 pose_map_vehicle{2.0, 1.0, 0.5};
    const rtob::Pose2 pose_vehicle_laser{0.1, 0.0, 0.0};
    const rtob::Pose2 pose_map_laser = rtob::compose(pose_map_vehicle, pose_vehicle_laser);
    std::printf("laser at %.3f %.3f m\n", pose_map_laser.x, pose_map_laser.y);
}

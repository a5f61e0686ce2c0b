// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/io/log_reader.h>
#include <rtob/slam/slam.h>

#include <cstdio>

int main(int argc, char** argv)
{
    if (argc != 2) return std::fputs("Usage: minimal LOG\n", stderr), 2;
    rtob::Slam slam;
    const auto log = rtob::open_log(argv[1]);
    while (const auto entry = log->next())
    {
        if (entry->motion) slam.observe(*entry->motion);
        if (!entry->observation) continue;
        if (const auto* report = slam.observe(*entry->observation))
        {
            const rtob::Pose2& pose = report->pose_map_vehicle;
            std::printf("%.6f %.3f %.3f %.4f\n", report->stamp_s, pose.x, pose.y, pose.yaw);
        }
    }
}

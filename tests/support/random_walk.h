// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/core/pose2.h>

#include <random>
#include <vector>

namespace rtob::test
{
/// A walk with turns, one pose a second from t = 1e9 s.
inline std::vector<StampedPose2> random_walk(std::size_t n, unsigned seed)
{
    std::mt19937 generator(seed);
    std::uniform_real_distribution<double> step(-1, 1);
    std::vector<StampedPose2> walk{{1e9, {}}};
    while (walk.size() < n)
    {
        const double ahead = step(generator), aside = step(generator), turn = step(generator);
        walk.push_back({walk.back().time_s + 1, compose(walk.back().pose, {ahead, aside, turn})});
    }
    return walk;
}

/// The same trajectory seen from another map.
inline std::vector<StampedPose2> seen_from(
    const Pose2& pose_other_map, std::vector<StampedPose2> trajectory)
{
    for (auto& stamped : trajectory) stamped.pose = compose(pose_other_map, stamped.pose);
    return trajectory;
}
}  // namespace rtob::test

// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <Eigen/Core>
#include <vector>

namespace rtob
{
/// A point that the vehicle's middle must not come nearer to than keep_m; seen from the vehicle.
struct NearObstacle
{
    Eigen::Vector2d place_vehicle = Eigen::Vector2d::Zero();
    double keep_m = 0;
};
using NearObstacles = std::vector<NearObstacle>;
}  // namespace rtob

// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/slam/guess_errors.h>

#include <algorithm>
#include <cmath>

namespace rtob
{
namespace
{
// The quantile that is followed, and by how much a scan moves it: a tenth up or a hundredth down.
constexpr double kQuantile = 0.9, kRate = 0.1;
// What matching itself scatters by: no guess is known to be better.
constexpr double kLeast_m = 0.01, kLeast_rad = 0.005;
// Unusual is what exceeds the quantile so many times, and then some.
constexpr double kTimes = 3, kMargin_m = 0.05, kMargin_rad = 0.02;

double followed(double quantile, double value, double least)
{
    const double rate = kRate * (value > quantile ? kQuantile : kQuantile - 1);
    return std::max(least, quantile * std::exp(rate));
}
}  // namespace

void GuessErrors::learn(const Pose2& error)
{
    usual_m_ = followed(usual_m_, std::hypot(error.x, error.y), kLeast_m);
    usual_rad_ = followed(usual_rad_, std::abs(error.yaw), kLeast_rad);
}

bool GuessErrors::isUnusual(const Pose2& error) const
{
    return std::hypot(error.x, error.y) > kMargin_m + kTimes * usual_m_ ||
           std::abs(error.yaw) > kMargin_rad + kTimes * usual_rad_;
}
}  // namespace rtob

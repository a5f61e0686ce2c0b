// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/core/pose2.h>
#include <Eigen/Core>

namespace rtob
{
/// The places of MotionState's mean and covariance.
enum MotionIndex : int
{
    kX = 0,     ///< in map [m]
    kY,         ///< in map [m]
    kYaw,       ///< in map [rad]; not wrapped, so that it is a smooth function of time
    kForward,   ///< velocity along the vehicle's x axis [m/s]
    kLeft,      ///< velocity along the vehicle's y axis [m/s]
    kTurn,      ///< yaw rate [rad/s]
    kGyroBias,  ///< what the gyro says too much [rad/s]
    kOdomX,     ///< where the vehicle was, in map, when odometry last told its pose
    kOdomY,
    kOdomYaw,
    kMotionSize
};

using MotionVector = Eigen::Matrix<double, kMotionSize, 1>;
using MotionMatrix = Eigen::Matrix<double, kMotionSize, kMotionSize>;

/// A velocity in the plane along the vehicle's own axes.
struct Twist2
{
    double forward_mps = 0, left_mps = 0, turn_radps = 0;
};

/// The pose that is reached from the origin with a constant twist.
[[nodiscard]] Pose2 carried(const Twist2& twist, double time_s);

/// What is known of the vehicle's motion at one time.
///
/// Velocity and yaw rate are states, and not inputs that odometry, flow or gyro would give: so each
/// of these sensors may be there or not, at any rate, and two that tell the same are weighed. The
/// gyro's bias is one, since a constant rate error is what cheap gyros have, and a few scan poses
/// show it. The pose of the last odometry reading is kept, because odometry measures the way
/// between two poses: the filter then takes it for exactly that, whatever scans said in between.
struct MotionState
{
    double time_s = 0;
    MotionVector mean = MotionVector::Zero();
    MotionMatrix covariance = MotionMatrix::Zero();
    bool has_odometry_pose = false;  ///< kOdomX and so on mean something

    [[nodiscard]] Pose2 pose() const { return {mean[kX], mean[kY], wrap_angle(mean[kYaw])}; }
    [[nodiscard]] Eigen::Matrix3d poseCovariance() const
    {
        return covariance.topLeftCorner<3, 3>();
    }
    [[nodiscard]] Twist2 twist() const { return {mean[kForward], mean[kLeft], mean[kTurn]}; }
};

/// How fast the motion changes: densities of white noise.
struct MotionNoise
{
    double speed_change = 1;      ///< m/s after 1 s, along each axis, one sigma
    double turn_change = 1;       ///< rad/s after 1 s, one sigma
    double gyro_bias_change = 0;  ///< rad/s after 1 s, one sigma
};

/// The state later, if the vehicle goes on turning and moving as it does, give or take the noise.
/// @param time_s not before the state's; an earlier one changes nothing
void predict(MotionState& state, double time_s, const MotionNoise& noise);
}  // namespace rtob

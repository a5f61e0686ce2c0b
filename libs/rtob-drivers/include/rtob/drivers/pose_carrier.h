// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/core/pose2.h>
#include <Eigen/Core>

#include <cstdint>
#include <optional>

namespace rtob
{
/// A pose as it is sent on.
struct TimedPose
{
    double time_s = 0;  ///< what moment it is of
    Pose2 pose_map_vehicle;
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();  ///< x, y, yaw
    Pose2 velocity_vehicle;                                ///< per second, vehicle frame
    std::uint8_t resets = 0;                               ///< grows with every jump
};

/// Carries the last pose on between two scans at constant velocity, its covariance growing. Never
/// repeats an old pose under a new time.
class PoseCarrier
{
 public:
    explicit PoseCarrier(double max_extrapolation_s = 0.3) : max_s_(max_extrapolation_s) {}

    /// A scan was matched. A pose that its forerunner's motion does not explain counts as a jump.
    void matched(double time_s, const Pose2& pose_map_vehicle, const Eigen::Matrix3d& covariance);
    /// The vehicle does not know where it is.
    void lost();

    /// The pose of the last scan.
    [[nodiscard]] const std::optional<TimedPose>& last() const { return last_; }
    /// The pose at this time; nothing where the last one is too old, or later.
    [[nodiscard]] std::optional<TimedPose> at(double time_s) const;

 private:
    double max_s_;
    std::optional<TimedPose> last_;
    bool has_velocity_ = false;
    bool was_lost_ = false;
    std::uint8_t resets_ = 0;
};
}  // namespace rtob

// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/core/pose2.h>
#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <optional>

namespace rtob
{
/// How the vehicle moves, as its own sensors measure it.
struct VehicleMotion
{
    Eigen::Vector2d velocity_vehicle = Eigen::Vector2d::Zero();  ///< m/s, x ahead, y to the left
    double yaw_rate_radps = 0;                                   ///< counter-clockwise
};

/// The vehicle's pose over the last seconds, summed up from measured velocities: good for the age
/// of a scan, and independent of SLAM. Its frame, odom, starts anywhere.
class DeadReckoning
{
 public:
    /// A measurement of this moment. A time before the last one, or a gap, starts anew.
    /// @return whether poses before this moment are still connected to those after it
    bool add(double time_s, const VehicleMotion& motion);

    /// Where the vehicle was, or will soon be if it goes on as it does; none outside of what is
    /// remembered.
    [[nodiscard]] std::optional<Pose2> poseAt(double time_s) const;

    [[nodiscard]] bool hasStarted() const { return size_ > 0; }
    [[nodiscard]] const Pose2& newest() const { return sample(0).pose_odom_vehicle; }

    static constexpr double kLongestGap_s = 1.0;

 private:
    static constexpr std::size_t kCapacity = 128;
    struct Sample
    {
        double time_s = 0;
        VehicleMotion motion;
        Pose2 pose_odom_vehicle;
    };
    /// @param back 0 is the newest
    [[nodiscard]] const Sample& sample(std::size_t back) const
    {
        return samples_[(next_ + kCapacity - 1 - back) % kCapacity];
    }
    void push(const Sample& added);

    std::array<Sample, kCapacity> samples_;
    std::size_t next_ = 0, size_ = 0;
};
}  // namespace rtob

// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <mrpt/obs/CObservation.h>
#include <mrpt/obs/CObservationOdometry.h>
#include <rtob/fusion/motion_filter.h>
#include <rtob/fusion/sensor_watch.h>

#include <array>
#include <optional>
#include <string>

namespace rtob
{
/// Feeds the motion filter from MRPT's observations, and a scan's time to it from stamps that need
/// not be right. Of sensors that tell the same, the first is used while it lives.
///
///     fusion.observe(observation);      // whatever comes
///     fusion.beginScan(stamp_s);        // a scan: predicted() is now where it was taken
///     fusion.settle(pose, covariance, matched);
class MotionFusion
{
 public:
    explicit MotionFusion(const FusionOptions& options = {});

    void observe(const mrpt::obs::CObservation& observation);
    /// Odometry as the motion since the last one, of no known time: it counts as of the next scan.
    void addMotion(const Pose2& pose_prev_now);

    /// Whether a sensor has told of turns or velocity by itself: odometry alone does not.
    [[nodiscard]] bool hasMotionSensor() const { return has_motion_sensor_; }

    void beginScan(double stamp_s);
    [[nodiscard]] MotionState predicted() const;
    /// @param matched the pose was measured, with this covariance.
    void settle(const Pose2& pose_map_vehicle, const Eigen::Matrix3d& covariance, bool matched);

    /// Starts from here with the next scan.
    void reset(const Pose2& pose_map_vehicle);

    [[nodiscard]] const SensorWatch& watch(MotionSensor sensor) const
    {
        return watches_[static_cast<std::size_t>(sensor)];
    }
    /// Time of the newest reading that was used, by the log's stamps [s].
    [[nodiscard]] double newest() const { return filter_.newest(); }

 private:
    [[nodiscard]] bool isSource(MotionSensor sensor, const mrpt::obs::CObservation& observation);
    void start(double time_s);
    bool add(MotionSensor sensor, const Measurement& reading);
    void observeOdometry(double time_s, const mrpt::obs::CObservationOdometry& odometry);
    void addOdometry(double time_s, const Pose2& pose_odom_vehicle);
    [[nodiscard]] Measurement yawRate(double time_s, double rate_radps) const;
    [[nodiscard]] Measurement velocity(double time_s, const Eigen::Vector2d& velocity_mps) const;
    [[nodiscard]] Measurement twist(double time_s, const Twist2& told) const;
    [[nodiscard]] Measurement way(double time_s, const Pose2& pose_prev_now) const;

    FusionOptions options_;
    MotionFilter filter_;
    std::array<SensorWatch, enum_names(MotionSensor{}).size()> watches_;
    std::array<std::string, enum_names(MotionSensor{}).size()> sources_;  ///< labels
    bool has_motion_sensor_ = false;
    Pose2 pose_map_last_;  ///< settled on; where the filter starts
    double scan_s_ = 0;    ///< of the scan in work, in the filter's time
    std::optional<Pose2> odometry_last_;
    Pose2 motion_sum_;            ///< of addMotion(): a pose in a frame of its own
    bool motion_is_new_ = false;  ///< since the last scan
};
}  // namespace rtob

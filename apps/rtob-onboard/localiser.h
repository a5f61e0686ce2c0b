// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <mrpt/obs/CObservationRobotPose.h>
#include <rtob/slam/slam.h>

#include <optional>

#include "run/run_options.h"
#include "run/scan_mounts.h"

namespace rtob
{
/// Runs the pipeline on observations as they come, by the rules by which `rtob-slam run` reads a
/// log: the same observations in the same order give the same poses.
class Localiser
{
 public:
    /// Begins in the map that [Map] names, if it names one. Throws std::runtime_error when that
    /// cannot be read.
    explicit Localiser(const RunConfig& config);

    /// @return the report of a scan that was localised, or null
    const ScanReport* take(const mrpt::obs::CObservation& observation);

    /// When the last beam of the scan that was taken last was measured; its stamp where the log
    /// does not say how long it took.
    [[nodiscard]] double lastBeamTime() const { return last_beam_s_; }
    /// How long the beams of that scan took; 0 where nobody tells.
    [[nodiscard]] double sweep() const { return last_beam_s_ - stamp_s_; }
    /// The moment of the last pose: a scan that is not straightened fits best where the vehicle was
    /// in the middle of the sweep.
    [[nodiscard]] double poseTime() const { return 0.5 * (stamp_s_ + last_beam_s_); }
    [[nodiscard]] const Slam& slam() const { return slam_; }
    /// pose_vehicle_laser behind each scan of the map.
    [[nodiscard]] std::vector<Pose2> mountsOfMap() const { return mounts_.of(slam_.map().scans()); }

 private:
    bool use_odometry_;
    SensorChoice sensor_;
    Slam slam_;
    std::optional<double> sweep_s_;
    mrpt::Clock::time_point sweep_stamp_{};
    double stamp_s_ = 0, last_beam_s_ = 0;
    ScanMounts mounts_;
};

/// The result as it stands in the log: label "rtob.pose".
[[nodiscard]] mrpt::obs::CObservationRobotPose::Ptr pose_observation(
    const ScanReport& report, double time_s);
}  // namespace rtob

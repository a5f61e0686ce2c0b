// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <rtob/slam/motion_fusion.h>
#include <rtob/slam/prealignment.h>
#include <rtob/slam/scan_geometry.h>
#include <rtob/slam/vehicle_level.h>

#include <optional>

namespace rtob
{
/// What all sensors but the laser tell, and what it means for a scan: the guess of its pose
/// (sec. 2.1.2) and how its beams lie in the plane.
class MotionSense
{
 public:
    MotionSense(
        PrealignSource source, const FusionOptions& fusion, const ScanGeometryOptions& geometry);

    void observe(const mrpt::obs::CObservation& observation);
    void addMotion(const Pose2& pose_prev_now);

    void beginScan(double stamp_s, const mrpt::obs::CObservation2DRangeScan& scan);
    /// Whether the guess comes from here, and not from the plain ways of Prealignment.
    [[nodiscard]] bool decides() const;
    [[nodiscard]] MotionState predicted() const { return fusion_.predicted(); }
    /// @param twist of the vehicle, where this does not decide
    [[nodiscard]] ScanGeometry geometry(
        const mrpt::poses::CPose3D& pose_vehicle_laser, const Twist2& twist) const;
    void settle(const Pose2& pose_map_vehicle, const Eigen::Matrix3d& covariance, bool matched);
    void reset(const Pose2& pose_map_vehicle) { fusion_.reset(pose_map_vehicle); }

    [[nodiscard]] const SensorWatch& watch(MotionSensor sensor) const;
    /// What is wrong with a sensor, for people; empty: nothing, or it is not there.
    [[nodiscard]] std::string complaint(MotionSensor sensor) const;

 private:
    [[nodiscard]] bool listens() const;

    PrealignSource source_;
    ScanGeometryOptions geometry_options_;
    MotionFusion fusion_;
    VehicleLevel level_;
    mrpt::Clock::time_point sweep_stamp_{};   ///< of the scan that sweep_s_ is for
    std::optional<double> recorded_sweep_s_;  ///< of the scan to come
    SweepTiming timing_;                      ///< of the scan in work
    double scan_s_ = 0;                       ///< when the scan in work was taken
};
}  // namespace rtob

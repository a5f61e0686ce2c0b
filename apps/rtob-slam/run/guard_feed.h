// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <rtob/avoid/velocity_guard.h>
#include <rtob/slam/scan_report.h>
#include <rtob/slam/slam_options.h>

#include <optional>
#include <vector>

namespace rtob
{
/// Brings scans and poses as the pipeline has them into the guard's form.
class GuardFeed
{
 public:
    explicit GuardFeed(const SlamOptions& options);

    /// Beams that mean nothing, that see the vehicle itself or that [ScanFilter] drops are none.
    /// Valid until the next call.
    /// @param sweep_s from the first beam to the last; 0 where it is not known
    [[nodiscard]] const GuardScan& scanOf(
        const mrpt::obs::CObservation2DRangeScan& scan, double sweep_s);

    /// @param pose_s the moment of the report's pose
    [[nodiscard]] static MapPose poseOf(const ScanReport& report, double pose_s);

    /// Takes a pose for what motion() says.
    void add(const MapPose& pose);
    /// How the vehicle moved between the last two poses; nothing where it was lost, or long ago.
    [[nodiscard]] std::optional<VehicleMotion> motion(double now_s) const;

 private:
    ScanFilterOptions filter_;
    AngleMask mask_;
    SensorChoice sensor_;
    std::vector<float> ranges_m_;
    GuardScan scan_;
    MapPose last_, before_last_;
};
}  // namespace rtob

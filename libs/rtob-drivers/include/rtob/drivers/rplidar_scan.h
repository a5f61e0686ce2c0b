// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/poses/CPose3D.h>
#include <rtob/drivers/beam_grid.h>
#include <rtob/drivers/rplidar_options.h>
#include <rtob/map/angle_mask.h>

#include <string>

namespace rtob
{
/// Makes MRPT's scans of whole revolutions. Beam 0 is the first one that was taken, at the device's
/// front; the scan's own x axis, the middle of its beams, is therefore the device's rear, and its
/// sensorPose is turned by 180 degrees against the mount.
class RplidarScanMaker
{
 public:
    RplidarScanMaker(
        const RplidarOptions& options, const mrpt::poses::CPose3D& pose_vehicle_device,
        std::string label);

    /// @param device_range_m how far the device sees, unless the options say
    [[nodiscard]] mrpt::obs::CObservation2DRangeScan::Ptr make(
        const RplidarRevolution& revolution, double device_range_m);

 private:
    [[nodiscard]] bool isMasked(double bearing_deg) const;

    RplidarOptions options_;
    AngleMask mask_;
    mrpt::poses::CPose3D pose_vehicle_laser_;
    std::string label_;
    BeamGrid grid_;
};
}  // namespace rtob

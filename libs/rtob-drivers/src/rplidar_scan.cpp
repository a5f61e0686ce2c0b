// SPDX-License-Identifier: BSD-3-Clause
#include <mrpt/core/bits_math.h>
#include <rtob/drivers/rplidar_scan.h>

namespace rtob
{
namespace
{
mrpt::poses::CPose3D turned_to_rear(
    const mrpt::poses::CPose3D& pose_vehicle_device, bool upside_down)
{
    const mrpt::poses::CPose3D hanging(0, 0, 0, 0, 0, upside_down ? M_PI : 0.0);
    const mrpt::poses::CPose3D pose_device_laser(0, 0, 0, M_PI, 0, 0);
    return pose_vehicle_device + hanging + pose_device_laser;
}
}  // namespace

RplidarScanMaker::RplidarScanMaker(
    const RplidarOptions& options, const mrpt::poses::CPose3D& pose_vehicle_device,
    std::string label)
    : options_(options),
      mask_(options.mask_deg),
      pose_vehicle_laser_(turned_to_rear(pose_vehicle_device, options.upside_down)),
      label_(std::move(label)),
      grid_(options.beams)
{
}

mrpt::obs::CObservation2DRangeScan::Ptr RplidarScanMaker::make(
    const RplidarRevolution& revolution, double device_range_m)
{
    const auto gridded = grid_.grid(revolution);
    const double max_range_m = options_.max_range_m > 0 ? options_.max_range_m : device_range_m;
    auto scan = mrpt::obs::CObservation2DRangeScan::Create();
    scan->timestamp = mrpt::Clock::fromDouble(revolution.start_s);
    scan->sensorLabel = label_;
    scan->sensorPose = pose_vehicle_laser_;
    scan->rightToLeft = !options_.clockwise;
    scan->aperture = static_cast<float>(mrpt::DEG2RAD(360 - gridded.stepDeg()));
    scan->maxRange = static_cast<float>(max_range_m);
    scan->stdError = 0.01f;
    scan->resizeScan(gridded.ranges_m.size());
    for (std::size_t i = 0; i < gridded.ranges_m.size(); ++i)
    {
        const double bearing_deg = (static_cast<double>(i) + 0.5) * gridded.stepDeg();
        const float range_m = gridded.ranges_m[i];
        const bool is_seen = range_m > 0 && range_m >= options_.min_range_m &&
                             range_m <= max_range_m && !isMasked(bearing_deg);
        scan->setScanRange(i, is_seen ? range_m : 0.0f);
        scan->setScanRangeValidity(i, is_seen);
    }
    return scan;
}

bool RplidarScanMaker::isMasked(double bearing_deg) const
{
    return mask_.contains(mrpt::DEG2RAD(bearing_deg));
}
}  // namespace rtob

// SPDX-License-Identifier: BSD-3-Clause
#include "localiser.h"

#include <mrpt/obs/CObservationOdometry.h>
#include <rtob/io/scan_timing.h>
#include <rtob/map/conversions.h>
#include <rtob/slam/map_file.h>

#include <array>

namespace rtob
{
Localiser::Localiser(const RunConfig& config)
    : use_odometry_(config.run.use_odometry), sensor_(config.slam.sensor), slam_(config.slam)
{
    enter_map(slam_);
}

const ScanReport* Localiser::take(const mrpt::obs::CObservation& observation)
{
    if (const auto timing = read_timing_record(observation))
    {
        sweep_s_ = timing->sweep_s;
        sweep_stamp_ = observation.timestamp;
        return slam_.observe(observation);
    }
    const auto* scan = dynamic_cast<const mrpt::obs::CObservation2DRangeScan*>(&observation);
    if (scan == nullptr)
    {
        const bool is_odometry =
            dynamic_cast<const mrpt::obs::CObservationOdometry*>(&observation) != nullptr;
        return is_odometry && !use_odometry_ ? nullptr : slam_.observe(observation);
    }
    if (!sensor_.uses(*scan)) return nullptr;
    last_beam_s_ = stamp_s_ = mrpt::Clock::toDouble(scan->timestamp);
    if (sweep_s_ && sweep_stamp_ == scan->timestamp) last_beam_s_ += *sweep_s_;
    const ScanReport& report = slam_.process(*scan);
    const auto mount = sensor_.mountOf(*scan);
    mounts_.add(report, {mount.x(), mount.y(), mount.yaw()});
    return &report;
}

mrpt::obs::CObservationRobotPose::Ptr pose_observation(const ScanReport& report, double time_s)
{
    auto observation = mrpt::obs::CObservationRobotPose::Create();
    observation->timestamp = mrpt::Clock::fromDouble(time_s);
    observation->sensorLabel = "rtob.pose";
    observation->pose.mean = mrpt::poses::CPose3D(to_cpose2d(report.pose_map_vehicle));
    constexpr std::array<int, 3> places{0, 1, 3};  // x, y and yaw of x, y, z, yaw, pitch, roll
    observation->pose.cov.setZero();
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column)
            observation->pose.cov(
                places[static_cast<std::size_t>(row)], places[static_cast<std::size_t>(column)]) =
                report.covariance(row, column);
    return observation;
}
}  // namespace rtob

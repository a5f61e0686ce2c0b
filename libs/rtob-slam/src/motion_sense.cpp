// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/io/scan_timing.h>
#include <rtob/slam/motion_sense.h>

namespace rtob
{
MotionSense::MotionSense(
    PrealignSource source, const FusionOptions& fusion, const ScanGeometryOptions& geometry)
    : source_(source), geometry_options_(geometry), fusion_(fusion), level_(fusion)
{
}

bool MotionSense::listens() const
{
    return source_ == PrealignSource::Auto || source_ == PrealignSource::Fusion;
}

bool MotionSense::decides() const
{
    return source_ == PrealignSource::Fusion ||
           (source_ == PrealignSource::Auto && fusion_.hasMotionSensor());
}

void MotionSense::observe(const mrpt::obs::CObservation& observation)
{
    if (const auto timing = read_timing_record(observation))
    {
        recorded_sweep_s_ = timing->sweep_s;
        sweep_stamp_ = observation.timestamp;
    }
    level_.observe(observation);
    if (listens()) fusion_.observe(observation);
}

void MotionSense::addMotion(const Pose2& pose_prev_now)
{
    if (listens()) fusion_.addMotion(pose_prev_now);
}

void MotionSense::beginScan(double stamp_s, const mrpt::obs::CObservation2DRangeScan& scan)
{
    if (sweep_stamp_ != scan.timestamp) recorded_sweep_s_.reset();
    timing_ = sweep_timing(recorded_sweep_s_, geometry_options_);
    scan_s_ = stamp_s + timing_.pose_after_stamp_s;
    if (decides()) fusion_.beginScan(scan_s_);
}

ScanGeometry MotionSense::geometry(
    const mrpt::poses::CPose3D& pose_vehicle_laser, const Twist2& twist) const
{
    return scan_geometry(
        pose_vehicle_laser, level_.tiltAt(scan_s_), level_.heightAt(scan_s_), timing_,
        decides() ? predicted().twist() : twist, geometry_options_);
}

void MotionSense::settle(
    const Pose2& pose_map_vehicle, const Eigen::Matrix3d& covariance, bool matched)
{
    if (decides())
        fusion_.settle(pose_map_vehicle, covariance, matched);
    else
        fusion_.reset(pose_map_vehicle);  // should a sensor turn up: it starts here
}

const SensorWatch& MotionSense::watch(MotionSensor sensor) const
{
    switch (sensor)
    {
        case MotionSensor::Attitude:
            return level_.attitude();
        case MotionSensor::Altimeter:
            return level_.altimeter();
        default:
            return fusion_.watch(sensor);
    }
}

std::string MotionSense::complaint(MotionSensor sensor) const
{
    const SensorWatch& sensor_watch = watch(sensor);
    return sensor_watch.readings() > 0 ? sensor_watch.complaint(scan_s_) : std::string();
}
}  // namespace rtob

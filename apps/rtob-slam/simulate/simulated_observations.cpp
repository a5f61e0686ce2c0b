// SPDX-License-Identifier: BSD-3-Clause
#include "simulate/simulated_observations.h"

#include <mrpt/core/bits_math.h>

#include <cmath>

namespace rtob
{
namespace
{
/// Whole ticks of 100 ns: the same on every machine and version of MRPT.
mrpt::Clock::time_point stamp_of(double time_s)
{
    constexpr std::int64_t ticks_1601_to_1970 = 116'444'736'000'000'000;
    constexpr auto epoch_ticks = static_cast<std::int64_t>(kSimulationEpoch_s) * 10'000'000;
    return mrpt::Clock::time_point(mrpt::Clock::duration(
        ticks_1601_to_1970 + epoch_ticks + static_cast<std::int64_t>(std::llround(time_s * 1e7))));
}

template <class Observation>
std::shared_ptr<Observation> labelled(const char* label, double time_s)
{
    auto observation = Observation::Create();
    observation->sensorLabel = label;
    observation->timestamp = stamp_of(time_s);
    return observation;
}
}  // namespace

mrpt::obs::CObservation2DRangeScan::Ptr observation_of(
    const sim::LaserScan& scan, const sim::LaserOptions& laser)
{
    auto observation = labelled<mrpt::obs::CObservation2DRangeScan>("LASER", scan.time_s);
    const auto beams = scan.ranges_m.size();
    observation->aperture =
        static_cast<float>(std::abs(scan.step_rad) * static_cast<double>(beams - 1));
    observation->rightToLeft = scan.step_rad > 0;
    observation->maxRange = static_cast<float>(laser.max_range_m);
    observation->stdError = static_cast<float>(laser.noise_m);
    observation->resizeScan(beams);
    for (std::size_t i = 0; i < beams; ++i)
    {
        observation->setScanRange(i, scan.ranges_m[i]);
        observation->setScanRangeValidity(i, scan.ranges_m[i] > 0);
    }
    return observation;
}

mrpt::obs::CObservationIMU::Ptr observation_of(const sim::ImuReading& reading)
{
    using namespace mrpt::obs;
    auto observation = labelled<CObservationIMU>("IMU", reading.time_s);
    observation->set(IMU_WZ, reading.yaw_rate_radps);
    observation->set(IMU_X_ACC, reading.ax_mps2);
    observation->set(IMU_Y_ACC, reading.ay_mps2);
    observation->set(IMU_Z_ACC, reading.az_mps2);
    observation->set(IMU_ROLL, reading.roll_rad);
    observation->set(IMU_PITCH, reading.pitch_rad);
    return observation;
}

mrpt::obs::CObservationOdometry::Ptr observation_of(const sim::OdometryReading& reading)
{
    auto observation = labelled<mrpt::obs::CObservationOdometry>("odometry", reading.time_s);
    const auto& pose = reading.pose_odom_vehicle;
    observation->odometry = {pose.x, pose.y, pose.yaw};
    return observation;
}

mrpt::obs::CObservationIMU::Ptr observation_of(const sim::FlowReading& reading)
{
    auto observation = labelled<mrpt::obs::CObservationIMU>("FLOW", reading.time_s);
    observation->set(mrpt::obs::IMU_X_VEL, reading.forward_mps);
    observation->set(mrpt::obs::IMU_Y_VEL, reading.left_mps);
    return observation;
}

mrpt::obs::CObservationRange::Ptr observation_of(const sim::AltimeterReading& reading)
{
    auto observation = labelled<mrpt::obs::CObservationRange>("ALTIMETER", reading.time_s);
    observation->minSensorDistance = 0;
    observation->maxSensorDistance = 100;
    observation->sensorConeApperture = static_cast<float>(mrpt::DEG2RAD(2.0));
    mrpt::obs::CObservationRange::TMeasurement measurement;
    measurement.sensorPose = {0, 0, 0, 0, M_PI / 2, 0};  // x of the sensor points to the floor
    measurement.sensedDistance = static_cast<float>(reading.height_m);
    observation->sensedData.push_back(measurement);
    return observation;
}
}  // namespace rtob

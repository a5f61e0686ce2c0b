// SPDX-License-Identifier: BSD-3-Clause
#include <mrpt/core/bits_math.h>
#include <mrpt/obs/CObservationOdometry.h>
#include <rtob/map/conversions.h>
#include <rtob/slam/motion_fusion.h>
#include <rtob/slam/motion_readings.h>

#include <cmath>

namespace rtob
{
namespace
{
constexpr double kLongestCoast_s = 1;  // a velocity is not carried on for longer without a reading
constexpr double kNoStep_s = 1e-6;     // two lasers share a stamp; time goes on all the same
constexpr double kLongestStep_s = 10;  // from scan to scan: beyond, the clock was set

// The way of standing wheels, one sigma: a covariance must be positive.
constexpr double kLeastWay_m = 0.001, kLeastTurn_rad = 0.001;

constexpr double square(double value)
{
    return value * value;
}
}  // namespace

MotionFusion::MotionFusion(const FusionOptions& options) : options_(options), filter_(options) {}

/// Whether readings of this sensor are taken from this observation's device. Two gyros that were
/// one and the same device would count twice.
bool MotionFusion::isSource(MotionSensor sensor, const mrpt::obs::CObservation& observation)
{
    std::string& label = sources_[static_cast<std::size_t>(sensor)];
    SensorWatch& watch = watches_[static_cast<std::size_t>(sensor)];
    if (watch.readings() > 0 && label == observation.sensorLabel) return true;
    if (watch.readings() > 0 && !watch.isSilent(filter_.newest())) return false;
    label = observation.sensorLabel;
    watch.restartClock();
    return true;
}

void MotionFusion::observe(const mrpt::obs::CObservation& observation)
{
    const double time_s = stamp_of(observation);
    const auto rate = yaw_rate_in(observation);
    if (rate && isSource(MotionSensor::Gyro, observation))
        add(MotionSensor::Gyro, yawRate(time_s, *rate));
    const auto flow = flow_in(observation);
    has_motion_sensor_ = has_motion_sensor_ || ((rate || flow) && std::isfinite(time_s));
    if (flow && isSource(MotionSensor::Flow, observation))
        add(MotionSensor::Flow, velocity(time_s, *flow));
    const auto* odometry = dynamic_cast<const mrpt::obs::CObservationOdometry*>(&observation);
    if (odometry != nullptr && isSource(MotionSensor::Odometry, observation))
        observeOdometry(time_s, *odometry);
}

void MotionFusion::addMotion(const Pose2& pose_prev_now)
{
    motion_sum_ = compose(motion_sum_, pose_prev_now);
    motion_is_new_ = true;
}

/// @return whether the filter has it
bool MotionFusion::add(MotionSensor sensor, const Measurement& reading)
{
    SensorWatch& watch = watches_[static_cast<std::size_t>(sensor)];
    const double newest_s =
        filter_.started() ? filter_.newest() : std::numeric_limits<double>::quiet_NaN();
    if (watch.admit(reading, newest_s) != ReadingFate::Used) return false;
    if (!filter_.started())
    {
        watch.refused(ReadingFate::NotFused);
        return false;
    }
    const auto innovation =
        sensor == MotionSensor::Scans ? filter_.addPose(reading) : filter_.add(reading);
    if (innovation)
        watch.took(*innovation);
    else
        watch.refused(ReadingFate::TooLate);
    return innovation.has_value();
}

/// Some sources fill in velocities only.
void MotionFusion::observeOdometry(double time_s, const mrpt::obs::CObservationOdometry& odometry)
{
    const Pose2 pose_odom_vehicle = to_pose2(odometry.odometry);
    const bool stands = odometry_last_ && pose_odom_vehicle.x == odometry_last_->x &&
                        pose_odom_vehicle.y == odometry_last_->y &&
                        pose_odom_vehicle.yaw == odometry_last_->yaw;
    const auto& velocity = odometry.velocityLocal;
    const bool moves = velocity.vx != 0 || velocity.vy != 0 || velocity.omega != 0;
    if (stands && odometry.hasVelocities && moves)
        add(MotionSensor::Odometry, twist(time_s, {velocity.vx, velocity.vy, velocity.omega}));
    else
        addOdometry(time_s, pose_odom_vehicle);
}

void MotionFusion::addOdometry(double time_s, const Pose2& pose_odom_vehicle)
{
    Measurement reading;
    reading.kind = Measurement::Kind::WayBegin;
    reading.time_s = time_s;
    reading.value << pose_odom_vehicle.x, pose_odom_vehicle.y, pose_odom_vehicle.yaw;
    if (odometry_last_) reading = way(time_s, between(*odometry_last_, pose_odom_vehicle));
    if (add(MotionSensor::Odometry, reading)) odometry_last_ = pose_odom_vehicle;
}

Measurement MotionFusion::yawRate(double time_s, double rate_radps) const
{
    Measurement reading{Measurement::Kind::YawRate, time_s, {rate_radps, 0, 0}, {}};
    reading.covariance.setIdentity();
    reading.covariance(0, 0) = square(mrpt::DEG2RAD(options_.gyro_noise_degps));
    return reading;
}

Measurement MotionFusion::velocity(double time_s, const Eigen::Vector2d& velocity_mps) const
{
    Measurement reading{
        Measurement::Kind::Velocity, time_s, {velocity_mps.x(), velocity_mps.y(), 0}, {}};
    const double variance = square(options_.flow_noise_mps) +
                            square(options_.flow_scale_error) * velocity_mps.squaredNorm();
    reading.covariance = Eigen::Vector3d(variance, variance, 1).asDiagonal();
    return reading;
}

Measurement MotionFusion::way(double time_s, const Pose2& pose_prev_now) const
{
    Measurement reading{
        Measurement::Kind::Way, time_s, {pose_prev_now.x, pose_prev_now.y, pose_prev_now.yaw}, {}};
    const double way_m = std::hypot(pose_prev_now.x, pose_prev_now.y);
    const double turns = way_m + std::abs(pose_prev_now.yaw) / mrpt::DEG2RAD(90.0);
    const double along = square(kLeastWay_m) + square(options_.odometry_noise_m) * way_m;
    const double turned =
        square(kLeastTurn_rad) + square(mrpt::DEG2RAD(options_.odometry_noise_deg)) * turns;
    reading.covariance = Eigen::Vector3d(along, along, turned).asDiagonal();
    return reading;
}

/// As if the way of 1 s had been told, divided by 1 s.
Measurement MotionFusion::twist(double time_s, const Twist2& told) const
{
    Measurement reading = way(time_s, {told.forward_mps, told.left_mps, told.turn_radps});
    reading.kind = Measurement::Kind::Twist;
    return reading;
}

void MotionFusion::start(double time_s)
{
    filter_.start(
        time_s, pose_map_last_,
        Eigen::Vector3d(
            square(options_.scan_noise_m), square(options_.scan_noise_m),
            square(mrpt::DEG2RAD(options_.scan_noise_deg)))
            .asDiagonal());
    odometry_last_.reset();
}

/// Stamps of scans repeat, step back and jump: a scan is never earlier than the one before it.
/// Where stamps start anew, so does the filter.
void MotionFusion::beginScan(double stamp_s)
{
    const double step_s = stamp_s - scan_s_;
    const bool is_other_clock = step_s < -options_.history_s || step_s > kLongestStep_s;
    if (filter_.started() && is_other_clock)
        for (SensorWatch& watch : watches_) watch.restartClock();
    const bool is_alone = stamp_s - filter_.newest() > kLongestCoast_s;
    const bool is_forgotten = stamp_s < filter_.oldest();
    if (is_other_clock || is_alone || is_forgotten) filter_.stop();
    scan_s_ = filter_.started() && !(step_s > 0) ? scan_s_ + kNoStep_s : stamp_s;
    if (!filter_.started() && std::isfinite(scan_s_)) start(scan_s_);
    if (motion_is_new_) addOdometry(scan_s_, motion_sum_);
    motion_is_new_ = false;
}

MotionState MotionFusion::predicted() const
{
    if (filter_.started()) return filter_.at(scan_s_);
    MotionState state;
    state.mean.head<3>() << pose_map_last_.x, pose_map_last_.y, pose_map_last_.yaw;
    state.covariance.setIdentity();
    return state;
}

void MotionFusion::settle(
    const Pose2& pose_map_vehicle, const Eigen::Matrix3d& covariance, bool matched)
{
    pose_map_last_ = pose_map_vehicle;
    if (!matched) return;
    Measurement pose{
        Measurement::Kind::Pose,
        scan_s_,
        {pose_map_vehicle.x, pose_map_vehicle.y, pose_map_vehicle.yaw},
        covariance};
    pose.covariance.diagonal() += Eigen::Vector3d(
        square(options_.scan_noise_m), square(options_.scan_noise_m),
        square(mrpt::DEG2RAD(options_.scan_noise_deg)));
    add(MotionSensor::Scans, pose);
}

void MotionFusion::reset(const Pose2& pose_map_vehicle)
{
    pose_map_last_ = pose_map_vehicle;
    filter_.stop();
}
}  // namespace rtob

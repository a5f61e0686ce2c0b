// SPDX-License-Identifier: BSD-3-Clause
#include <mrpt/core/bits_math.h>
#include <mrpt/obs/CObservationIMU.h>
#include <rtob/core/option_checks.h>
#include <rtob/drivers/autopilot.h>
#include <rtob/drivers/autopilot_frames.h>
#include <rtob/drivers/autopilot_pose.h>

#include <algorithm>
#include <cmath>

namespace rtob
{
namespace
{
constexpr double kHeartbeat_s = 1, kQuestion_s = 0.5;
constexpr std::uint8_t kOnboardController = 18, kNoAutopilot = 8, kActive = 4, kMavlink2 = 3;
constexpr std::uint8_t kAutopilotComponent = 1, kLooksDown = 25;
constexpr double kMilliG = 9.80665e-3;

std::int64_t nanoseconds(double time_s)
{
    return static_cast<std::int64_t>(std::llround(1e9 * time_s));
}

void set_motion(
    mrpt::obs::CObservationIMU& imu, const Vector3& acceleration_frd, const Vector3& turn_frd)
{
    using namespace mrpt::obs;
    const Vector3 acceleration = turn_over(acceleration_frd), turn = turn_over(turn_frd);
    imu.set(IMU_X_ACC, acceleration.x);
    imu.set(IMU_Y_ACC, acceleration.y);
    imu.set(IMU_Z_ACC, acceleration.z);
    imu.set(IMU_ROLL_VEL, turn.x);
    imu.set(IMU_PITCH_VEL, turn.y);
    imu.set(IMU_YAW_VEL, turn.z);
}
}  // namespace

void AutopilotOptions::validate() const
{
    const auto begins = [this](const char* with) { return link.rfind(with, 0) == 0; };
    require(
        link.empty() || begins("/") || begins("udp:") || begins("udpin:"), "link", link,
        "a serial port such as /dev/autopilot, or udp:HOST:PORT");
    require(baud >= 1200, "baud", baud, ">= 1200");
    require(pose_hz >= 0 && pose_hz <= 100, "pose_hz", pose_hz, "0 to 100");
    require(system_id >= 1 && system_id <= 255, "system_id", system_id, "1 to 255");
    require(component_id >= 1 && component_id <= 255, "component_id", component_id, "1 to 255");
    require(
        max_extrapolation_s >= 0.05 && max_extrapolation_s <= 1, "max_extrapolation_s",
        max_extrapolation_s, "0.05 to 1");
}

Autopilot::Autopilot(const AutopilotOptions& options, std::string label)
    : options_(options),
      label_(std::move(label)),
      sender_{
          static_cast<std::uint8_t>(options.system_id),
          static_cast<std::uint8_t>(options.component_id), 0},
      carrier_(options.max_extrapolation_s)
{
    options_.validate();
}

void Autopilot::receive(ByteView bytes, double now_s)
{
    reader_.push(bytes);
    while (const auto frame = reader_.take()) take(*frame, now_s);
}

void Autopilot::take(const MavlinkFrame& frame, double now_s)
{
    using mavlink::message_of;
    if (const auto heartbeat = message_of<mavlink::Heartbeat>(frame))
    {
        if (frame.component == kAutopilotComponent) last_heartbeat_s_ = now_s;
    }
    else if (const auto sync = message_of<mavlink::Timesync>(frame))
        answer(*sync, now_s);
    else if (const auto attitude = message_of<mavlink::Attitude>(frame))
        take(*attitude, now_s);
    else if (const auto imu = message_of<mavlink::HighresImu>(frame))
        take(*imu, now_s);
    else if (const auto scaled = message_of<mavlink::ScaledImu>(frame))
        take(*scaled, now_s);
    else if (const auto flow = message_of<mavlink::OpticalFlowRad>(frame))
        take(*flow, now_s);
    else if (const auto distance = message_of<mavlink::DistanceSensor>(frame))
        take(*distance, now_s);
    else if (const auto position = message_of<mavlink::LocalPositionNed>(frame))
        news_.position = {*position, now_s};
    else if (const auto manual = message_of<mavlink::ManualControl>(frame))
        news_.manual = {*manual, now_s};
    else if (const auto rc = message_of<mavlink::RcChannels>(frame))
        news_.rc = {*rc, now_s};
}

void Autopilot::answer(const mavlink::Timesync& sync, double now_s)
{
    if (sync.tc1 != 0)
        time_sync_.answered(sync.ts1, sync.tc1, nanoseconds(now_s));
    else
        send(mavlink::Timesync{nanoseconds(now_s), sync.ts1, 0, 0});
}

/// The time of the autopilot's clock as ours; while the clocks are not known, the time of arrival.
double Autopilot::ours(double other_s, double now_s) const
{
    return time_sync_.toOurs(nanoseconds(other_s)).value_or(now_s);
}

void Autopilot::add(mrpt::obs::CObservation::Ptr observation, double time_s, const char* what)
{
    constexpr std::size_t most_waiting = 1000;  // of one who does not ask
    if (observations_.size() >= most_waiting || !std::isfinite(time_s)) return;
    observation->timestamp = mrpt::Clock::fromDouble(time_s);
    observation->sensorLabel = label_ + "." + what;
    observations_.push_back(std::move(observation));
}

void Autopilot::take(const mavlink::Attitude& attitude, double now_s)
{
    news_.attitude = {attitude, now_s};
    using namespace mrpt::obs;
    const auto angles = turn_over(RollPitchYaw{attitude.roll, attitude.pitch, attitude.yaw});
    const auto turn =
        turn_over(Vector3{attitude.rollspeed, attitude.pitchspeed, attitude.yawspeed});
    auto imu = CObservationIMU::Create();
    imu->set(IMU_ROLL, angles.roll);
    imu->set(IMU_PITCH, angles.pitch);
    imu->set(IMU_YAW, angles.yaw);
    imu->set(IMU_ROLL_VEL, turn.x);
    imu->set(IMU_PITCH_VEL, turn.y);
    imu->set(IMU_YAW_VEL, turn.z);
    add(imu, ours(1e-3 * attitude.time_boot_ms, now_s), "attitude");
}

void Autopilot::take(const mavlink::HighresImu& message, double now_s)
{
    auto imu = mrpt::obs::CObservationIMU::Create();
    set_motion(
        *imu, {message.xacc, message.yacc, message.zacc},
        {message.xgyro, message.ygyro, message.zgyro});
    add(imu, ours(1e-6 * static_cast<double>(message.time_usec), now_s), "imu");
}

void Autopilot::take(const mavlink::ScaledImu& message, double now_s)
{
    auto imu = mrpt::obs::CObservationIMU::Create();
    set_motion(
        *imu, {kMilliG * message.xacc, kMilliG * message.yacc, kMilliG * message.zacc},
        {1e-3 * message.xgyro, 1e-3 * message.ygyro, 1e-3 * message.zgyro});
    add(imu, ours(1e-3 * message.time_boot_ms, now_s), "imu");
}

/// The picture turns with the vehicle, too: the gyro's part is taken off before the rest, times the
/// height, is a speed.
void Autopilot::take(const mavlink::OpticalFlowRad& flow, double now_s)
{
    if (flow.distance <= 0 || flow.integration_time_us == 0 || flow.quality == 0) return;
    const double per_second = 1e6 / flow.integration_time_us;
    const double ahead_mps =
        (flow.integrated_y - flow.integrated_ygyro) * per_second * flow.distance;
    const double right_mps =
        -(flow.integrated_x - flow.integrated_xgyro) * per_second * flow.distance;
    const Vector3 velocity = turn_over(Vector3{ahead_mps, right_mps, 0});
    auto imu = mrpt::obs::CObservationIMU::Create();
    imu->set(mrpt::obs::IMU_X_VEL, velocity.x);
    imu->set(mrpt::obs::IMU_Y_VEL, velocity.y);
    add(imu, ours(1e-6 * static_cast<double>(flow.time_usec), now_s), "flow");
}

/// Only downwards, as a height: MRPT's programs would take other ranges for laser points.
void Autopilot::take(const mavlink::DistanceSensor& distance, double now_s)
{
    const bool is_valid = distance.current_distance > distance.min_distance &&
                          distance.current_distance < distance.max_distance;
    if (distance.orientation != kLooksDown || !is_valid) return;
    auto imu = mrpt::obs::CObservationIMU::Create();
    imu->set(mrpt::obs::IMU_ALTITUDE, 0.01 * distance.current_distance);
    add(imu, ours(1e-3 * distance.time_boot_ms, now_s), "height");
}

void Autopilot::poll(double now_s)
{
    if (now_s >= next_heartbeat_s_)
    {
        mavlink::Heartbeat heartbeat;
        heartbeat.type = kOnboardController;
        heartbeat.autopilot = kNoAutopilot;
        heartbeat.system_status = kActive;
        heartbeat.mavlink_version = kMavlink2;
        send(heartbeat);
        next_heartbeat_s_ = now_s + kHeartbeat_s;
    }
    if (now_s >= next_question_s_)
    {
        send(mavlink::Timesync{0, nanoseconds(now_s), 0, 0});
        next_question_s_ = now_s + kQuestion_s;
    }
    if (options_.pose_hz == 0 || now_s < next_pose_s_) return;
    if (const auto pose = carrier_.at(now_s)) sendPose(*pose);
    // From the last due time on, not from now: or the rate would sag. Not to catch up after a
    // pause.
    next_pose_s_ = std::max(next_pose_s_ + 1 / options_.pose_hz, now_s);
}

void Autopilot::matched(
    double time_s, const Pose2& pose_map_vehicle, const Eigen::Matrix3d& covariance)
{
    const double before_s = carrier_.last() ? carrier_.last()->time_s : -1;
    carrier_.matched(time_s, pose_map_vehicle, covariance);
    if (options_.pose_hz == 0 && carrier_.last()->time_s > before_s) sendPose(*carrier_.last());
}

void Autopilot::lost()
{
    carrier_.lost();
}

void Autopilot::sendPose(const TimedPose& pose)
{
    const double heading_rad = mrpt::DEG2RAD(options_.heading_deg);
    if (options_.message == PoseMessage::Odometry)
        send(odometry_of(pose, heading_rad));
    else
        send(vision_estimate_of(pose, heading_rad));
    ++poses_sent_;
}

void Autopilot::say(int severity, const std::string& text)
{
    mavlink::Statustext message;
    message.severity = static_cast<std::uint8_t>(std::clamp(severity, 0, 7));
    std::copy_n(text.begin(), std::min(text.size(), message.text.size()), message.text.begin());
    send(message);
}

Bytes Autopilot::takeBytes()
{
    Bytes bytes = std::move(to_send_);
    to_send_.clear();
    return bytes;
}

std::vector<mrpt::obs::CObservation::Ptr> Autopilot::takeObservations()
{
    auto observations = std::move(observations_);
    observations_.clear();
    return observations;
}
}  // namespace rtob

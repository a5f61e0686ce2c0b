// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <mrpt/obs/CObservation.h>
#include <rtob/drivers/autopilot_news.h>
#include <rtob/drivers/autopilot_options.h>
#include <rtob/drivers/mavlink_codec.h>
#include <rtob/drivers/pose_carrier.h>
#include <rtob/drivers/time_sync.h>

#include <string>
#include <vector>

namespace rtob
{
/// The talk with a flight controller over MAVLink 2: poses, heartbeat, time and texts out; what it
/// senses in, as observations of MRPT. Bytes in, bytes out, no input or output of its own. Times
/// are UNIX seconds.
class Autopilot
{
 public:
    explicit Autopilot(const AutopilotOptions& options, std::string label = "AUTOPILOT");

    void receive(ByteView bytes, double now_s);
    /// What is due now: heartbeat, questions for the time, and poses where they are carried on.
    /// Call it at least twice as often as poses are wanted.
    void poll(double now_s);

    /// A scan was matched; its time is that of the pose.
    void matched(double time_s, const Pose2& pose_map_vehicle, const Eigen::Matrix3d& covariance);
    /// The vehicle is lost: no poses until it is found.
    void lost();
    /// Shown by ground stations. Severities: 2 critical, 4 warning, 6 info.
    void say(int severity, const std::string& text);
    /// Sends any message as ours, e.g. a commanded velocity.
    template <class Message>
    void send(const Message& message)
    {
        const Bytes frame = sender_.encode(message);
        to_send_.insert(to_send_.end(), frame.begin(), frame.end());
    }

    [[nodiscard]] Bytes takeBytes();
    [[nodiscard]] std::vector<mrpt::obs::CObservation::Ptr> takeObservations();
    /// Of the pilot's sticks and of the vehicle's motion, as it came.
    [[nodiscard]] const AutopilotNews& news() const { return news_; }
    [[nodiscard]] const MavlinkCounters& counters() const { return reader_.counters(); }
    [[nodiscard]] const TimeSync& timeSync() const { return time_sync_; }
    [[nodiscard]] bool hearsHeartbeat(double now_s) const { return now_s - last_heartbeat_s_ < 3; }
    [[nodiscard]] std::uint64_t posesSent() const { return poses_sent_; }

 private:
    void take(const MavlinkFrame& frame, double now_s);
    void answer(const mavlink::Timesync& sync, double now_s);
    void add(mrpt::obs::CObservation::Ptr observation, double time_s, const char* what);
    void take(const mavlink::Attitude& attitude, double now_s);
    void take(const mavlink::HighresImu& imu, double now_s);
    void take(const mavlink::ScaledImu& imu, double now_s);
    void take(const mavlink::OpticalFlowRad& flow, double now_s);
    void take(const mavlink::DistanceSensor& distance, double now_s);
    void sendPose(const TimedPose& pose);
    [[nodiscard]] double ours(double other_s, double now_s) const;

    AutopilotOptions options_;
    std::string label_;
    mavlink::Sender sender_;
    MavlinkReader reader_;
    TimeSync time_sync_;
    PoseCarrier carrier_;
    AutopilotNews news_;
    Bytes to_send_;
    std::vector<mrpt::obs::CObservation::Ptr> observations_;
    double next_heartbeat_s_ = 0, next_question_s_ = 0, next_pose_s_ = 0;
    double last_heartbeat_s_ = -1e9;
    std::uint64_t poses_sent_ = 0;
};
}  // namespace rtob

// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/drivers/mavlink_sensor_messages.h>

#include <array>
#include <cstdint>

/// The messages of MAVLink's common set that are sent or read here. Each lists its fields once, in
/// the order on the wire, by the names of the protocol: the checksum that both ends must share is
/// made of these names. Fields after extension() were added later: they may be missing, and count
/// for no checksum.
namespace rtob::mavlink
{
struct Heartbeat
{
    static constexpr std::uint32_t id = 0;
    static constexpr const char* name = "HEARTBEAT";
    std::uint32_t custom_mode = 0;
    std::uint8_t type = 0, autopilot = 0, base_mode = 0, system_status = 0, mavlink_version = 3;

    template <class Self, class Visit>
    static void fields(Self& s, Visit&& v)
    {
        v("custom_mode", s.custom_mode), v("type", s.type), v("autopilot", s.autopilot);
        v("base_mode", s.base_mode), v("system_status", s.system_status);
        v("mavlink_version", s.mavlink_version);
    }
};

struct SetPositionTargetLocalNed
{
    static constexpr std::uint32_t id = 84;
    static constexpr const char* name = "SET_POSITION_TARGET_LOCAL_NED";
    std::uint32_t time_boot_ms = 0;
    float x = 0, y = 0, z = 0, vx = 0, vy = 0, vz = 0, afx = 0, afy = 0, afz = 0;
    float yaw = 0, yaw_rate = 0;
    std::uint16_t type_mask = 0;
    std::uint8_t target_system = 0, target_component = 0, coordinate_frame = 0;

    template <class Self, class Visit>
    static void fields(Self& s, Visit&& v)
    {
        v("time_boot_ms", s.time_boot_ms), v("x", s.x), v("y", s.y), v("z", s.z);
        v("vx", s.vx), v("vy", s.vy), v("vz", s.vz), v("afx", s.afx), v("afy", s.afy);
        v("afz", s.afz), v("yaw", s.yaw), v("yaw_rate", s.yaw_rate), v("type_mask", s.type_mask);
        v("target_system", s.target_system), v("target_component", s.target_component);
        v("coordinate_frame", s.coordinate_frame);
    }
};

/// In NED, or any frame with z down.
struct VisionPositionEstimate
{
    static constexpr std::uint32_t id = 102;
    static constexpr const char* name = "VISION_POSITION_ESTIMATE";
    std::uint64_t usec = 0;
    float x = 0, y = 0, z = 0, roll = 0, pitch = 0, yaw = 0;
    std::array<float, 21> covariance{};
    std::uint8_t reset_counter = 0;

    template <class Self, class Visit>
    static void fields(Self& s, Visit&& v)
    {
        v("usec", s.usec), v("x", s.x), v("y", s.y), v("z", s.z);
        v("roll", s.roll), v("pitch", s.pitch), v("yaw", s.yaw);
        v.extension();
        v("covariance", s.covariance), v("reset_counter", s.reset_counter);
    }
};

struct Timesync
{
    static constexpr std::uint32_t id = 111;
    static constexpr const char* name = "TIMESYNC";
    std::int64_t tc1 = 0;  ///< ns; 0 in a request
    std::int64_t ts1 = 0;  ///< ns; the asker's time
    std::uint8_t target_system = 0, target_component = 0;

    template <class Self, class Visit>
    static void fields(Self& s, Visit&& v)
    {
        v("tc1", s.tc1), v("ts1", s.ts1);
        v.extension();
        v("target_system", s.target_system), v("target_component", s.target_component);
    }
};

struct Statustext
{
    static constexpr std::uint32_t id = 253;
    static constexpr const char* name = "STATUSTEXT";
    std::uint8_t severity = 6;
    std::array<char, 50> text{};
    std::uint16_t chunk_id = 0;
    std::uint8_t chunk_seq = 0;

    template <class Self, class Visit>
    static void fields(Self& s, Visit&& v)
    {
        v("severity", s.severity), v("text", s.text);
        v.extension();
        v("id", s.chunk_id), v("chunk_seq", s.chunk_seq);
    }
};

struct ObstacleDistance
{
    static constexpr std::uint32_t id = 330;
    static constexpr const char* name = "OBSTACLE_DISTANCE";
    std::uint64_t time_usec = 0;
    std::array<std::uint16_t, 72> distances{};         ///< cm; 65535: not known
    std::uint16_t min_distance = 0, max_distance = 0;  ///< cm
    std::uint8_t sensor_type = 0, increment = 0;
    float increment_f = 0, angle_offset = 0;  ///< deg, clockwise
    std::uint8_t frame = 0;

    template <class Self, class Visit>
    static void fields(Self& s, Visit&& v)
    {
        v("time_usec", s.time_usec), v("distances", s.distances);
        v("min_distance", s.min_distance), v("max_distance", s.max_distance);
        v("sensor_type", s.sensor_type), v("increment", s.increment);
        v.extension();
        v("increment_f", s.increment_f), v("angle_offset", s.angle_offset), v("frame", s.frame);
    }
};

struct Odometry
{
    static constexpr std::uint32_t id = 331;
    static constexpr const char* name = "ODOMETRY";
    std::uint64_t time_usec = 0;
    float x = 0, y = 0, z = 0;
    std::array<float, 4> q{1, 0, 0, 0};  ///< w, x, y, z
    float vx = 0, vy = 0, vz = 0, rollspeed = 0, pitchspeed = 0, yawspeed = 0;
    std::array<float, 21> pose_covariance{}, velocity_covariance{};
    std::uint8_t frame_id = 0, child_frame_id = 0, reset_counter = 0, estimator_type = 0;
    std::int8_t quality = 0;

    template <class Self, class Visit>
    static void fields(Self& s, Visit&& v)
    {
        v("time_usec", s.time_usec), v("x", s.x), v("y", s.y), v("z", s.z), v("q", s.q);
        v("vx", s.vx), v("vy", s.vy), v("vz", s.vz), v("rollspeed", s.rollspeed);
        v("pitchspeed", s.pitchspeed), v("yawspeed", s.yawspeed);
        v("pose_covariance", s.pose_covariance);
        v("velocity_covariance", s.velocity_covariance);
        v("frame_id", s.frame_id), v("child_frame_id", s.child_frame_id);
        v.extension();
        v("reset_counter", s.reset_counter), v("estimator_type", s.estimator_type);
        v("quality", s.quality);
    }
};

/// All of them, for tables.
template <class Visit>
void for_each_message(Visit&& visit)
{
    visit(Heartbeat()), visit(ScaledImu()), visit(Attitude()), visit(LocalPositionNed());
    visit(RcChannels()), visit(ManualControl()), visit(SetPositionTargetLocalNed()),
        visit(VisionPositionEstimate());
    visit(HighresImu()), visit(OpticalFlowRad()), visit(Timesync()), visit(DistanceSensor());
    visit(Statustext()), visit(ObstacleDistance()), visit(Odometry());
}
}  // namespace rtob::mavlink

// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <cstdint>

/// What a flight controller tells: its attitude, its sensors, its pilot. See mavlink_messages.h.
namespace rtob::mavlink
{
struct ScaledImu
{
    static constexpr std::uint32_t id = 26;
    static constexpr const char* name = "SCALED_IMU";
    std::uint32_t time_boot_ms = 0;
    std::int16_t xacc = 0, yacc = 0, zacc = 0;     ///< mG
    std::int16_t xgyro = 0, ygyro = 0, zgyro = 0;  ///< mrad/s
    std::int16_t xmag = 0, ymag = 0, zmag = 0;
    std::int16_t temperature = 0;

    template <class Self, class Visit>
    static void fields(Self& s, Visit&& v)
    {
        v("time_boot_ms", s.time_boot_ms);
        v("xacc", s.xacc), v("yacc", s.yacc), v("zacc", s.zacc);
        v("xgyro", s.xgyro), v("ygyro", s.ygyro), v("zgyro", s.zgyro);
        v("xmag", s.xmag), v("ymag", s.ymag), v("zmag", s.zmag);
        v.extension();
        v("temperature", s.temperature);
    }
};

struct Attitude
{
    static constexpr std::uint32_t id = 30;
    static constexpr const char* name = "ATTITUDE";
    std::uint32_t time_boot_ms = 0;
    float roll = 0, pitch = 0, yaw = 0;                 ///< rad, body FRD in NED
    float rollspeed = 0, pitchspeed = 0, yawspeed = 0;  ///< rad/s

    template <class Self, class Visit>
    static void fields(Self& s, Visit&& v)
    {
        v("time_boot_ms", s.time_boot_ms), v("roll", s.roll), v("pitch", s.pitch), v("yaw", s.yaw);
        v("rollspeed", s.rollspeed), v("pitchspeed", s.pitchspeed), v("yawspeed", s.yawspeed);
    }
};

/// Where it believes to be.
struct LocalPositionNed
{
    static constexpr std::uint32_t id = 32;
    static constexpr const char* name = "LOCAL_POSITION_NED";
    std::uint32_t time_boot_ms = 0;
    float x = 0, y = 0, z = 0;     ///< m
    float vx = 0, vy = 0, vz = 0;  ///< m/s

    template <class Self, class Visit>
    static void fields(Self& s, Visit&& v)
    {
        v("time_boot_ms", s.time_boot_ms), v("x", s.x), v("y", s.y), v("z", s.z);
        v("vx", s.vx), v("vy", s.vy), v("vz", s.vz);
    }
};

struct RcChannels
{
    static constexpr std::uint32_t id = 65;
    static constexpr const char* name = "RC_CHANNELS";
    std::uint32_t time_boot_ms = 0;
    std::array<std::uint16_t, 18> chan{};  ///< us; 65535: not there
    std::uint8_t chancount = 0, rssi = 0;

    template <class Self, class Visit>
    static void fields(Self& s, Visit&& v)
    {
        constexpr std::array<const char*, 18> names{
            "chan1_raw",  "chan2_raw",  "chan3_raw",  "chan4_raw",  "chan5_raw",  "chan6_raw",
            "chan7_raw",  "chan8_raw",  "chan9_raw",  "chan10_raw", "chan11_raw", "chan12_raw",
            "chan13_raw", "chan14_raw", "chan15_raw", "chan16_raw", "chan17_raw", "chan18_raw"};
        v("time_boot_ms", s.time_boot_ms);
        for (std::size_t i = 0; i < names.size(); ++i) v(names[i], s.chan[i]);
        v("chancount", s.chancount), v("rssi", s.rssi);
    }
};

struct ManualControl
{
    static constexpr std::uint32_t id = 69;
    static constexpr const char* name = "MANUAL_CONTROL";
    std::int16_t x = 0, y = 0, z = 0, r = 0;  ///< ahead, right, up, turn: -1000 to 1000
    std::uint16_t buttons = 0;
    std::uint8_t target = 0;
    std::uint16_t buttons2 = 0;
    std::uint8_t enabled_extensions = 0;
    std::array<std::int16_t, 8> more{};  ///< further axes

    template <class Self, class Visit>
    static void fields(Self& s, Visit&& v)
    {
        v("x", s.x), v("y", s.y), v("z", s.z), v("r", s.r), v("buttons", s.buttons);
        v("target", s.target);
        v.extension();
        v("buttons2", s.buttons2), v("enabled_extensions", s.enabled_extensions);
        constexpr std::array<const char*, 8> names{"s",    "t",    "aux1", "aux2",
                                                   "aux3", "aux4", "aux5", "aux6"};
        for (std::size_t i = 0; i < names.size(); ++i) v(names[i], s.more[i]);
    }
};

struct HighresImu
{
    static constexpr std::uint32_t id = 105;
    static constexpr const char* name = "HIGHRES_IMU";
    std::uint64_t time_usec = 0;
    float xacc = 0, yacc = 0, zacc = 0;     ///< m/s^2, FRD
    float xgyro = 0, ygyro = 0, zgyro = 0;  ///< rad/s
    float xmag = 0, ymag = 0, zmag = 0, abs_pressure = 0, diff_pressure = 0;
    float pressure_alt = 0, temperature = 0;
    std::uint16_t fields_updated = 0;
    std::uint8_t sensor = 0;

    template <class Self, class Visit>
    static void fields(Self& s, Visit&& v)
    {
        v("time_usec", s.time_usec), v("xacc", s.xacc), v("yacc", s.yacc), v("zacc", s.zacc);
        v("xgyro", s.xgyro), v("ygyro", s.ygyro), v("zgyro", s.zgyro);
        v("xmag", s.xmag), v("ymag", s.ymag), v("zmag", s.zmag);
        v("abs_pressure", s.abs_pressure), v("diff_pressure", s.diff_pressure);
        v("pressure_alt", s.pressure_alt), v("temperature", s.temperature);
        v("fields_updated", s.fields_updated);
        v.extension();
        v("id", s.sensor);
    }
};

struct OpticalFlowRad
{
    static constexpr std::uint32_t id = 106;
    static constexpr const char* name = "OPTICAL_FLOW_RAD";
    std::uint64_t time_usec = 0;
    std::uint32_t integration_time_us = 0;
    float integrated_x = 0, integrated_y = 0;  ///< rad, right-hand rule
    float integrated_xgyro = 0, integrated_ygyro = 0, integrated_zgyro = 0;  ///< rad
    std::uint32_t time_delta_distance_us = 0;
    float distance = -1;  ///< m; negative: not known
    std::int16_t temperature = 0;
    std::uint8_t sensor_id = 0, quality = 0;

    template <class Self, class Visit>
    static void fields(Self& s, Visit&& v)
    {
        v("time_usec", s.time_usec), v("integration_time_us", s.integration_time_us);
        v("integrated_x", s.integrated_x), v("integrated_y", s.integrated_y);
        v("integrated_xgyro", s.integrated_xgyro), v("integrated_ygyro", s.integrated_ygyro);
        v("integrated_zgyro", s.integrated_zgyro);
        v("time_delta_distance_us", s.time_delta_distance_us), v("distance", s.distance);
        v("temperature", s.temperature), v("sensor_id", s.sensor_id), v("quality", s.quality);
    }
};

struct DistanceSensor
{
    static constexpr std::uint32_t id = 132;
    static constexpr const char* name = "DISTANCE_SENSOR";
    std::uint32_t time_boot_ms = 0;
    std::uint16_t min_distance = 0, max_distance = 0, current_distance = 0;  ///< cm
    std::uint8_t type = 0, sensor = 0, orientation = 0, covariance = 0;
    float horizontal_fov = 0, vertical_fov = 0;
    std::array<float, 4> quaternion{};
    std::uint8_t signal_quality = 0;

    template <class Self, class Visit>
    static void fields(Self& s, Visit&& v)
    {
        v("time_boot_ms", s.time_boot_ms), v("min_distance", s.min_distance);
        v("max_distance", s.max_distance), v("current_distance", s.current_distance);
        v("type", s.type), v("id", s.sensor), v("orientation", s.orientation);
        v("covariance", s.covariance);
        v.extension();
        v("horizontal_fov", s.horizontal_fov), v("vertical_fov", s.vertical_fov);
        v("quaternion", s.quaternion), v("signal_quality", s.signal_quality);
    }
};
}  // namespace rtob::mavlink

// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <mrpt/poses/CPose3D.h>
#include <rtob/map/options_io.h>

#include <algorithm>
#include <array>

namespace rtob
{
/// The keys that any sensor's section may have, read by MRPT or by whom starts the sensor.
constexpr std::array<const char*, 16> kCommonSensorKeys{
    "driver",          "process_rate", "max_queue_len", "sensorLabel",
    "grab_decimation", "pose_x",       "pose_y",        "pose_z",
    "pose_yaw",        "pose_pitch",   "pose_roll",     "rawlog-grabber-ignore",
    "restart_after_s", "sweep_s",      "stamp_late_s",  "verbose"};

/// Sets the options whose keys stand in a sensor's section; refuses keys that nobody reads.
template <class T>
void load_sensor_options(
    const mrpt::config::CConfigFileBase& config, const std::string& section, T& options)
{
    T loaded = options;
    try
    {
        for (const auto& key : config_keys(config, section))
        {
            const auto is_key = [&](const char* known) { return key == known; };
            if (std::any_of(kCommonSensorKeys.begin(), kCommonSensorKeys.end(), is_key)) continue;
            set_option(loaded, key, config_value(config, section, key));
        }
        loaded.validate();
    }
    catch (const std::invalid_argument& error)
    {
        // MRPT takes what stands in brackets for a place in its sources.
        throw std::runtime_error(
            config_name(config) + ", section " + section + ", " + error.what());
    }
    options = loaded;
}

/// pose_x, pose_y, pose_z [m], pose_yaw, pose_pitch, pose_roll [deg]: the sensor seen from the
/// vehicle; 0 where not given.
[[nodiscard]] mrpt::poses::CPose3D sensor_pose(
    const mrpt::config::CConfigFileBase& config, const std::string& section);
}  // namespace rtob

// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/fusion/sensor_watch.h>
#include <rtob/slam/motion_sense.h>

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace rtob
{
/// What became of one sensor's readings in a run.
struct SensorFigures
{
    MotionSensor sensor = MotionSensor::Gyro;
    SensorWatch watch;
    std::string complaint;  ///< what is wrong with it; empty: nothing
};

/// Of the sensors that the log had and the run used.
[[nodiscard]] std::vector<SensorFigures> sensor_figures(const MotionSense& motion);

/// Counts of what happened at all, lag, noise and verdict.
[[nodiscard]] nlohmann::ordered_json sensor_json(const SensorFigures& figures);
}  // namespace rtob

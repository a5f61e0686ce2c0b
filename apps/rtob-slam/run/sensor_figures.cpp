// SPDX-License-Identifier: BSD-3-Clause
#include "run/sensor_figures.h"

#include <rtob/core/enum_names.h>

#include <nlohmann/json.hpp>

namespace rtob
{
std::vector<SensorFigures> sensor_figures(const MotionSense& motion)
{
    std::vector<SensorFigures> figures;
    for (const auto& [sensor, name] : enum_names(MotionSensor{}))
        if (motion.watch(sensor).readings() > 0)
            figures.push_back({sensor, motion.watch(sensor), motion.complaint(sensor)});
    return figures;
}

nlohmann::ordered_json sensor_json(const SensorFigures& figures)
{
    const SensorWatch& watch = figures.watch;
    nlohmann::ordered_json json{
        {"verdict", figures.complaint.empty() ? "good" : figures.complaint},
        {"readings", watch.readings()}};
    for (const auto& [fate, name] : enum_names(ReadingFate{}))
        if (fate == ReadingFate::Used || watch.with(fate) > 0)
            json[std::string(name)] = watch.with(fate);
    if (watch.meanNis() > 0) json["mean_nis"] = watch.meanNis();  // of the filter's sensors
    json["mean_lag_s"] = watch.meanLag();
    json["longest_gap_s"] = watch.longestGap();
    return json;
}
}  // namespace rtob

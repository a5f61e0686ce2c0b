// SPDX-License-Identifier: BSD-3-Clause
#include <mrpt/core/bits_math.h>
#include <mrpt/system/string_utils.h>
#include <rtob/core/option_checks.h>
#include <rtob/slam/sensor_choice.h>

#include <algorithm>
#include <cmath>

namespace rtob
{
void SensorOptions::validate() const
{
    require(std::isfinite(mount_x_m), "mount_x_m", mount_x_m, "a number");
    require(std::isfinite(mount_y_m), "mount_y_m", mount_y_m, "a number");
    require(std::isfinite(mount_yaw_deg), "mount_yaw_deg", mount_yaw_deg, "a number");
}

SensorChoice::SensorChoice(const SensorOptions& options)
    : options_(options),
      mount_(
          options.mount_x_m, options.mount_y_m, 0, mrpt::DEG2RAD(options.mount_yaw_deg), 0,
          options.upside_down ? M_PI : 0.0)
{
    options_.validate();
    std::vector<std::string> labels;
    mrpt::system::tokenize(options_.labels, ",", labels);
    for (const std::string& label : labels)
        if (const auto name = mrpt::system::trim(label); !name.empty()) labels_.push_back(name);
}

bool SensorChoice::uses(const mrpt::obs::CObservation& observation) const
{
    return labels_.empty() ||
           std::find(labels_.begin(), labels_.end(), observation.sensorLabel) != labels_.end();
}

mrpt::poses::CPose3D SensorChoice::mountOf(const mrpt::obs::CObservation2DRangeScan& scan) const
{
    if (!options_.override_mount) return scan.sensorPose;
    // The log's yaw also holds half the field of view of lasers whose field is not symmetric.
    return mount_ + mrpt::poses::CPose3D(0, 0, 0, scan.sensorPose.yaw(), 0, 0);
}
}  // namespace rtob

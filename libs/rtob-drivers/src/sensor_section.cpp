// SPDX-License-Identifier: BSD-3-Clause
#include <mrpt/core/bits_math.h>
#include <rtob/drivers/sensor_section.h>

namespace rtob
{
namespace
{
double number_at(
    const mrpt::config::CConfigFileBase& config, const std::string& section, const char* key)
{
    double value = 0;
    if (!config.keyExists(section, key)) return value;
    try
    {
        parse_option(config_value(config, section, key), value);
    }
    catch (const std::invalid_argument& error)
    {
        throw std::runtime_error(
            config_name(config) + ", section " + section + ", key " + key + ": " + error.what());
    }
    return value;
}
}  // namespace

mrpt::poses::CPose3D sensor_pose(
    const mrpt::config::CConfigFileBase& config, const std::string& section)
{
    const auto at = [&](const char* key) { return number_at(config, section, key); };
    using mrpt::DEG2RAD;
    return {
        at("pose_x"),
        at("pose_y"),
        at("pose_z"),
        DEG2RAD(at("pose_yaw")),
        DEG2RAD(at("pose_pitch")),
        DEG2RAD(at("pose_roll"))};
}
}  // namespace rtob

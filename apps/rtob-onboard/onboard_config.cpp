// SPDX-License-Identifier: BSD-3-Clause
#include "onboard_config.h"

#include <rtob/core/option_checks.h>
#include <rtob/map/options_io.h>

#include <algorithm>

#include "sensor_runner.h"

namespace rtob
{
namespace
{
template <class Visit>
void visit_sections(OnboardConfig& config, Visit&& visit)
{
    RunConfig::sections(config.run, visit);
    OnboardConfig::sections(config, visit);
}

std::vector<std::string> own_sections()
{
    std::vector<std::string> names{"global"};  // rawlog-grabber's, which is not looked at
    OnboardConfig config;
    visit_sections(config, [&](const char* name, const auto&) { names.emplace_back(name); });
    return names;
}

bool contains(const std::vector<std::string>& names, const std::string& name)
{
    return std::find(names.begin(), names.end(), name) != names.end();
}

double number_of(
    const mrpt::config::CConfigFileBase& ini, const std::string& section, const char* key,
    double otherwise)
{
    if (!ini.keyExists(section, key)) return otherwise;
    double value = 0;
    try
    {
        parse_option(config_value(ini, section, key), value);
        require(value >= 0, key, value, ">= 0");
    }
    catch (const std::invalid_argument& error)
    {
        throw std::runtime_error(
            config_name(ini) + ", section [" + section + "], key " + key + ": " + error.what());
    }
    return value;
}

/// Whether there is such a driver, and whether it takes the section's keys.
void check_driver(
    const mrpt::config::CConfigFileBase& ini, const std::string& section, const std::string& where)
{
    const auto driver = create_quiet_sensor(config_value(ini, section, "driver"), where);
    try
    {
        driver->loadConfig(ini, section);
    }
    catch (const std::exception& error)
    {
        const std::string what = plain_message(error);
        const bool tells_where = what.rfind(config_name(ini), 0) == 0;  // as our own drivers do
        throw std::runtime_error(tells_where ? what : where + what);
    }
}

SensorSection sensor_of(const mrpt::config::CConfigFileBase& ini, const std::string& section)
{
    SensorSection sensor;
    sensor.name = section;
    sensor.driver = config_value(ini, section, "driver");
    sensor.sweep_s = number_of(ini, section, "sweep_s", 0);
    sensor.stamp_late_s = number_of(ini, section, "stamp_late_s", 0);
    if (ini.keyExists(section, "restart_after_s"))
        sensor.restart_after_s = number_of(ini, section, "restart_after_s", 0);
    if (ini.keyExists(section, "COM_port_LIN"))
        sensor.port = config_value(ini, section, "COM_port_LIN");
    const std::string where = config_name(ini) + ", section [" + section + "], ";
    if (!ini.keyExists(section, "process_rate"))
        throw std::runtime_error(
            where + "key process_rate is missing: how often the sensor is asked [Hz], e.g. 50");
    if (number_of(ini, section, "process_rate", 0) <= 0)
        throw std::runtime_error(where + "key process_rate: must be > 0");
    check_driver(ini, section, where);
    return sensor;
}

bool is_ignored(const mrpt::config::CConfigFileBase& ini, const std::string& section)
{
    bool ignored = false;
    if (ini.keyExists(section, "rawlog-grabber-ignore"))
        parse_option(config_value(ini, section, "rawlog-grabber-ignore"), ignored);
    return ignored;
}
/// What one section alone cannot know.
void check_pilot(const mrpt::config::CConfigFileBase& ini, const OnboardConfig& config)
{
    if (!config.pilot.enabled) return;
    const std::string where = config_name(ini) + ", section [Pilot], key ";
    if (config.autopilot.link.empty())
        throw std::runtime_error(
            where + "enabled: there is nobody to send velocities to; set [Autopilot] link");
    if (config.pilot.command_hz * config.run.vehicle.period_s < 2)
        throw std::runtime_error(
            where + "command_hz: must be at least 2 / [VehicleLimits] period_s");
}
}  // namespace

void OnboardOptions::validate() const
{
    require(!output_folder.empty(), "output_folder", output_folder, "a folder");
    require(
        max_waiting_scans >= 1 && max_waiting_scans <= 100, "max_waiting_scans", max_waiting_scans,
        "1 to 100");
    require(status_period_s >= 0, "status_period_s", status_period_s, ">= 0");
}

void CaptureOptions::validate() const
{
    require(flush_s >= 0.05 && flush_s <= 10, "flush_s", flush_s, "0.05 to 10");
    require(rotate_mb >= 1, "rotate_mb", rotate_mb, ">= 1");
}

void StateStreamOptions::validate() const
{
    require(udp_port <= 65535, "udp_port", udp_port, "0 to 65535");
    require(tcp_port <= 65535, "tcp_port", tcp_port, "0 to 65535");
}

OnboardConfig load_onboard_config(const mrpt::config::CConfigFileBase& ini)
{
    OnboardConfig config;
    std::vector<std::string> names;
    ini.getAllSections(names);
    auto known = own_sections();
    for (const auto& name : names)
        if (!contains(known, name) && ini.keyExists(name, "driver"))
        {
            known.push_back(name);
            if (!is_ignored(ini, name)) config.sensors.push_back(sensor_of(ini, name));
        }
    if (known.size() == own_sections().size())
        throw std::runtime_error(
            config_name(ini) +
            ": no section has a key `driver`, which makes it a sensor's: e.g. [Laser] with driver "
            "= "
            "RtobRplidar. config/onboard.ini is an example to begin with.");
    check_sections(ini, known);
    visit_sections(
        config,
        [&](const char* name, auto& options)
        {
            if (ini.sectionExists(name)) load_options(ini, name, options);
        });
    check_pilot(ini, config);
    config.run.slam.seed = config.run.run.seed;
    if (config.sensors.empty())
        throw std::runtime_error(
            config_name(ini) +
            ": all sensors are switched off. Take rawlog-grabber-ignore out of one section.");
    return config;
}
}  // namespace rtob

// SPDX-License-Identifier: BSD-3-Clause
#include <mrpt/core/initializer.h>
#include <rtob/drivers/log_player.h>
#include <rtob/drivers/register_drivers.h>
#include <rtob/drivers/rplidar_sensor.h>

#include <stdexcept>

namespace rtob
{
void register_drivers()
{
    RtobRplidar::doRegister();
    RtobLogPlayer::doRegister();
}

std::unique_ptr<mrpt::hwdrivers::CGenericSensor> create_sensor(
    const std::string& driver, const std::string& where)
{
    using mrpt::hwdrivers::CGenericSensor;
    register_drivers();
    std::unique_ptr<CGenericSensor> sensor(CGenericSensor::createSensor(driver));
    if (sensor) return sensor;
    throw std::runtime_error(
        where + "driver = " + driver +
        " is unknown. Known: RtobRplidar, RtobLogPlayer, and MRPT's, e.g. CHokuyoURG, CLMS100Eth, "
        "CSICKTim561Eth, CSickLaserSerial.");
}
}  // namespace rtob

MRPT_INITIALIZER(register_rtob_drivers)
{
    rtob::register_drivers();
}

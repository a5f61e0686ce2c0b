// SPDX-License-Identifier: BSD-3-Clause
#include <mrpt/core/initializer.h>
#include <rtob/drivers/register_drivers.h>
#include <rtob/drivers/rplidar_sensor.h>

namespace rtob
{
void register_drivers()
{
    RtobRplidar::doRegister();
}
}  // namespace rtob

MRPT_INITIALIZER(register_rtob_drivers)
{
    rtob::register_drivers();
}

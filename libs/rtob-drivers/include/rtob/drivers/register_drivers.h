// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <mrpt/hwdrivers/CGenericSensor.h>

#include <memory>
#include <string>

namespace rtob
{
/// Makes this library's sensors known to MRPT by their names. Loading the library as a plug-in
/// (`rawlog-grabber -p librtob-drivers.so`) does the same; a program that links it has to call
/// this, or the linker drops a library of which nothing is used. May be called again.
void register_drivers();

/// A sensor by the name of its driver. Throws std::runtime_error, which begins with `where`, for an
/// unknown name.
[[nodiscard]] std::unique_ptr<mrpt::hwdrivers::CGenericSensor> create_sensor(
    const std::string& driver, const std::string& where);
}  // namespace rtob

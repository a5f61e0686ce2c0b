// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>

namespace rtob
{
/// How a sensor that takes care of itself is doing.
struct SensorStatus
{
    bool is_connected = false;
    std::string device;   ///< "RPLidar A1M8, firmware 1.29, mode Express, 115200 baud"
    std::string problem;  ///< the last one; empty while all is well
    unsigned reconnects = 0;
};

/// Sensors of this project tell how they are; MRPT's own only whether they work. Any thread may
/// ask.
class TellsStatus
{
 public:
    virtual ~TellsStatus() = default;
    [[nodiscard]] virtual SensorStatus status() const = 0;
};
}  // namespace rtob

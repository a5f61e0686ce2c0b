// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <functional>

namespace rtob::devices
{
/// What an emulated laser sees: the distance [m] in this direction of the device (radians,
/// counter-clockwise from its front) at this moment (UNIX seconds); 0 where it sees nothing.
using RangeSource = std::function<double(double bearing_rad, double time_s)>;
}  // namespace rtob::devices

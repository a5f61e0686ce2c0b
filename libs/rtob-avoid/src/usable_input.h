// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/avoid/velocity_guard.h>

/// Whether what comes from outside can be worked with; false for whatever is no number.
namespace rtob
{
[[nodiscard]] bool is_usable(const VehicleMotion& motion);
[[nodiscard]] bool is_usable(const GuardScan& scan);
[[nodiscard]] bool is_usable(const MapPose& pose);
}  // namespace rtob

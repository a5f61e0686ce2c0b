// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/check/check_report.h>

#include <functional>
#include <string>

namespace rtob
{
/// Share of the work that is done, 0 to 1; false ends the check.
using CheckProgress = std::function<bool(double share)>;

/// Reads a log twice, in file order and an entry at a time: first for what each scan holds, then,
/// knowing what stands for "no return" and where the laser sees the vehicle, for how it moves. A
/// log that is damaged is checked up to there. Throws LogError for a missing or foreign file,
/// std::runtime_error for a log without a 2D laser scan and when `progress` ended the check.
[[nodiscard]] CheckReport check_log(
    const std::string& file, const CheckProgress& progress = [](double) { return true; });
}  // namespace rtob

// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <mrpt/config/CConfigFileBase.h>

#include <functional>
#include <ostream>

#include "live_results.h"

namespace rtob
{
/// Localises and captures live until `stop` says so; then writes the results. Status goes to `log`.
/// Throws std::runtime_error where the run cannot begin.
[[nodiscard]] LiveSummary run_live(
    const OnboardConfig& config, const mrpt::config::CConfigFileBase& ini, std::ostream& log,
    const std::function<bool()>& stop);
}  // namespace rtob

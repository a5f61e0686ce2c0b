// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <mrpt/config/CConfigFileBase.h>

#include <functional>
#include <ostream>

#include "onboard_config.h"

namespace rtob
{
/// Opens everything, listens for a few seconds, writes what it sees to `out` and closes it again.
/// @return whether all is as it should be for a flight
[[nodiscard]] bool check_onboard(
    const OnboardConfig& config, const mrpt::config::CConfigFileBase& ini, std::ostream& out,
    const std::function<bool()>& stop);
}  // namespace rtob

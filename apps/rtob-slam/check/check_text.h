// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/check/check_report.h>

#include <string>

namespace rtob
{
/// PASS, WARN and FAIL lines with their fixes, the suggested .ini and a line that sums up.
[[nodiscard]] std::string check_text(const std::string& log, const CheckReport& report);

/// The same for programs: figures by name, units in the names.
[[nodiscard]] std::string check_json(const std::string& log, const CheckReport& report);
}  // namespace rtob

// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>

namespace rtob
{
enum class ConvertTarget
{
    Rawlog,
    Carmen,
    Tum
};

/// What to write: `to` ("rawlog", "carmen", "tum") where it is not empty, otherwise as the output's
/// name ends. Throws UsageError that says what is possible.
[[nodiscard]] ConvertTarget convert_target(const std::string& output, const std::string& to);
}  // namespace rtob

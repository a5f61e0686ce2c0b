// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/core/pose2.h>

#include <string>
#include <vector>

namespace rtob
{
/// Those that one sensor observed; none when there is no such sensor. Throws LogError.
[[nodiscard]] std::vector<StampedPose2> read_rawlog_poses(const std::string& file);
}  // namespace rtob

// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/core/pose2.h>

#include <iosfwd>
#include <string>
#include <vector>

namespace rtob
{
/// TUM trajectories: a line "time_s x y z qx qy qz qw" a pose. Times to the microsecond, positions
/// to the micrometre, the turn to 1e-9; the same bytes in any locale.
void write_tum(std::ostream& out, const std::vector<StampedPose2>& poses);

/// As above; the file appears whole or not at all. Throws std::runtime_error.
void write_tum(const std::string& file, const std::vector<StampedPose2>& poses);

/// The poses in file order, seen from above: height, roll and pitch are dropped. Lines starting
/// with '#' and empty ones are passed over. Throws LogError with the line for anything else that is
/// not eight finite numbers with a unit quaternion.
[[nodiscard]] std::vector<StampedPose2> read_tum(const std::string& file);
}  // namespace rtob

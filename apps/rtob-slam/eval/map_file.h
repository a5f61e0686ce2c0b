// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/core/points.h>

#include <string>

namespace rtob
{
/// Whether the file begins as a PLY file does, the map.ply of a run for one. False, too, for a file
/// that cannot be read: whoever reads it next says so.
[[nodiscard]] bool is_ply_file(const std::string& file);

/// The points of a PLY file in ASCII, seen from above. Throws std::runtime_error naming the file
/// and the line.
[[nodiscard]] Points read_ply_points(const std::string& file);
}  // namespace rtob

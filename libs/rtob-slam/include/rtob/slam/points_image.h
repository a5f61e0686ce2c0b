// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <mrpt/img/CImage.h>
#include <rtob/core/points.h>
#include <rtob/core/scan_table.h>

namespace rtob
{
/// Points in black and the path of the scans in red on white, x to the right and y up; 5 cm a
/// pixel, more where the longer side would exceed 4000 pixels.
[[nodiscard]] mrpt::img::CImage points_image(const PointsView& points_map, const ScanTable& scans);
}  // namespace rtob

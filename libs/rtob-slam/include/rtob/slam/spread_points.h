// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/core/points.h>

#include <cstddef>

namespace rtob
{
/// At most so many of a scan's points, at equal steps along what the scan sees: near walls, which a
/// scan is crowded with, lose the most. Gaps count as no more than kGap_m.
/// @param points_vehicle in the order of their beams
void spread_points(const PointsView& points_vehicle, std::size_t most, Points& spread_vehicle);
}  // namespace rtob

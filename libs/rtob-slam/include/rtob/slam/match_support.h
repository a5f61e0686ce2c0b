// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/core/neighbour_grid.h>
#include <rtob/core/points.h>
#include <rtob/core/reference_draw.h>
#include <rtob/core/scan_table.h>

#include <cstddef>
#include <vector>

namespace rtob
{
/// Tells which scans of the map a match rests on.
class MatchSupport
{
 public:
    /// @param reference what was matched against.
    /// @param points_turned what was matched, with map axes, seen from (x, y) [m, map], where the
    /// match puts it.
    /// @return the newest scan that has points beside these, but for the newest tenth of the
    /// points; 0 where no point lies beside one.
    [[nodiscard]] std::size_t newest(
        const ScanTable& scans, const Reference& reference, const PointsView& points_turned,
        double x, double y);

 private:
    NeighbourGrid grid_;
    std::vector<std::size_t> scans_;  ///< one for each point that lies beside one
};
}  // namespace rtob

// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/core/neighbour_grid.h>
#include <vector>

namespace rtob
{
/// The local line through each reference point, fitted when it is first asked for.
class LineField
{
 public:
    struct Line
    {
        float normal_x = 0, normal_y = 0;  ///< unit; both 0 where the points make no line
        bool known = false;
    };

    void reset(const NeighbourGrid& grid, double radius_m);

    /// The line at a sorted point of the grid, which is that of reset().
    [[nodiscard]] const Line& at(const NeighbourGrid& grid, std::int32_t index);

 private:
    [[nodiscard]] Line fit(const NeighbourGrid& grid, std::int32_t index) const;

    float radius_m_ = 0;
    std::vector<Line> lines_;
};
}  // namespace rtob

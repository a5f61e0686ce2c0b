// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/slam/match_support.h>

#include <algorithm>

namespace rtob
{
namespace
{
constexpr float kBeside_m = 0.2f;
}  // namespace

std::size_t MatchSupport::newest(
    const ScanTable& scans, const Reference& reference, const PointsView& points_turned, double x,
    double y)
{
    grid_.build(reference.points.view(), kBeside_m);
    scans_.clear();
    const auto shift_x = static_cast<float>(x - reference.origin_x);
    const auto shift_y = static_cast<float>(y - reference.origin_y);
    for (std::size_t i = 0; i < points_turned.size; ++i)
    {
        const auto found =
            grid_.nearest(points_turned.x[i] + shift_x, points_turned.y[i] + shift_y, kBeside_m);
        if (found.index != NeighbourGrid::kNone)
            scans_.push_back(scans.scanOf(reference.indices[grid_.original(found.index)]));
    }
    if (scans_.empty()) return 0;
    const auto newest = scans_.begin() + static_cast<std::ptrdiff_t>(scans_.size() * 9 / 10);
    std::nth_element(scans_.begin(), newest, scans_.end());
    return *newest;
}
}  // namespace rtob

// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/map/match_sample.h>

#include <cmath>
#include <cstring>
#include <limits>

namespace rtob
{
namespace
{
// Grids are built a little larger than asked, so that rounding never asks for more than was built.
constexpr double kMargin = 1.01;

std::uint64_t mixed(std::uint64_t hash, float value)
{
    std::uint32_t bits = 0;
    std::memcpy(&bits, &value, sizeof bits);
    return (hash ^ bits) * 0x100000001b3;
}
}  // namespace

std::uint64_t scan_hash(const PointsView& points)
{
    std::uint64_t hash = 0xcbf29ce484222325;
    for (std::size_t i = 0; i < points.size; ++i)
        hash = mixed(mixed(hash, points.x[i]), points.y[i]);
    return hash;
}

bool MatchSample::isFor(
    std::uint64_t hash, const Pose2& pose_map_vehicle, double max_offset_m) const
{
    return hash_ == hash && std::hypot(
                                pose_map_vehicle.x - reference_.origin_x,
                                pose_map_vehicle.y - reference_.origin_y) <= max_offset_m;
}

Reference& MatchSample::renew(std::uint64_t hash)
{
    hash_ = hash;
    usual_radius_m_ = wide_radius_m_ = 0;
    return reference_;
}

void MatchSample::prepare(double usual_radius_m, double max_radius_m)
{
    // Matchers shrink their radius from iteration to iteration: the first grid serves them all.
    if (usual_radius_m > usual_radius_m_)
    {
        usual_radius_m_ = usual_radius_m * kMargin;
        usual_grid_.build(reference_.points.view(), usual_radius_m_);
    }
    if (max_radius_m > usual_radius_m_ && max_radius_m > wide_radius_m_)
    {
        wide_radius_m_ = max_radius_m * kMargin;
        wide_grid_.build(reference_.points.view(), wide_radius_m_);
    }
}

std::optional<MatchSample::Neighbour> MatchSample::nearest(
    double x_map, double y_map, double radius_m) const
{
    const auto x = static_cast<float>(x_map - reference_.origin_x);
    const auto y = static_cast<float>(y_map - reference_.origin_y);
    const auto near_radius = static_cast<float>(std::min(radius_m, usual_radius_m_));
    const NeighbourGrid* grid = &usual_grid_;
    auto found = grid->nearest(x, y, near_radius);
    if (found.index == NeighbourGrid::kNone && radius_m > usual_radius_m_)
    {
        grid = &wide_grid_;
        found = grid->nearest(x, y, static_cast<float>(radius_m));
    }
    if (found.index == NeighbourGrid::kNone) return std::nullopt;
    return Neighbour{grid->original(found.index), found.squared_distance};
}

double MatchSample::squaredDistance(double x_map, double y_map) const
{
    if (usual_radius_m_ > 0)
        if (const auto near = nearest(x_map, y_map, usual_radius_m_ / kMargin))
            return near->squared_distance;
    const double x = x_map - reference_.origin_x, y = y_map - reference_.origin_y;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < reference_.points.size(); ++i)
    {
        const double dx = reference_.points.x[i] - x, dy = reference_.points.y[i] - y;
        least = std::min(least, dx * dx + dy * dy);
    }
    return least;
}
}  // namespace rtob

// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/core/correspondences.h>
#include <rtob/core/simd.h>
#include <algorithm>
#include <cmath>

namespace rtob
{
namespace
{
// Looking a little farther than the last neighbour finds how far the next candidate is; of the
// order of a scan's last steps.
constexpr float kSlack_m = 0.01f;
// What rounding may add to a distance between points within 100 m of each other.
constexpr float kRounding_m = 2e-5f;
constexpr float kRoundUp = 1.00001f;

/// By how much all candidates but the neighbour are too far by now, at least.
RTOB_SIMD_CLONES void room_left(
    const PairColumns& c, std::size_t n, const float* searched_x, const float* searched_y,
    const float* gap_m, float radius_m, float* room_m)
{
    for (std::size_t i = 0; i < n; ++i)
    {
        const float dx = c.u[i] - c.x[i], dy = c.v[i] - c.y[i];
        const float sx = c.x[i] - searched_x[i], sy = c.y[i] - searched_y[i];
        const float distance_m = std::sqrt(dx * dx + dy * dy);
        const float needed_m = distance_m < radius_m ? distance_m : radius_m;
        room_m[i] = gap_m[i] - std::sqrt(sx * sx + sy * sy) - needed_m - kRounding_m;
    }
}
}  // namespace

void Correspondences::reserve(std::size_t scan_points)
{
    searched_at_.reserve(scan_points);
    neighbour_.reserve(scan_points);
    gap_m_.reserve(scan_points);
    room_m_.reserve(scan_points);
    unsettled_.reserve(scan_points);
    queries_.reserve(scan_points);
    reach_m_.reserve(scan_points);
    found_.reserve(scan_points);
}

void Correspondences::reset(std::size_t scan_points)
{
    searched_at_.x.resize(scan_points);
    searched_at_.y.resize(scan_points);
    neighbour_.assign(scan_points, NeighbourGrid::kNone);
    gap_m_.assign(scan_points, -1);  // nothing is known: to be searched
    room_m_.resize(scan_points);
    reach_m_.resize(scan_points);
    found_.resize(scan_points);
}

void Correspondences::find(
    IcpReference& reference, double max_distance_m, bool with_lines, PairTable& table)
{
    const auto radius_m = static_cast<float>(max_distance_m);
    room_left(
        table.columns(), table.scanPoints(), searched_at_.x.data(), searched_at_.y.data(),
        gap_m_.data(), radius_m, room_m_.data());
    choose(table, radius_m);
    reference.grid().nearestOfEach(
        queries_.view(), reach_m_.data(), radius_m, kSlack_m, found_.data());
    const PointsView points = reference.grid().points();
    for (std::size_t k = 0; k < unsettled_.size(); ++k)
    {
        const std::size_t i = unsettled_[k];
        const NeighbourGrid::Neighbour& found = found_[k];
        searched_at_.x[i] = queries_.x[k];
        searched_at_.y[i] = queries_.y[k];
        gap_m_[i] = std::sqrt(found.squared_gap);
        if (found.index == neighbour_[i]) continue;
        neighbour_[i] = found.index;
        if (found.index == NeighbourGrid::kNone)
        {
            table.leaveAlone(i);
            continue;
        }
        const LineField::Line line = with_lines ? reference.line(found.index) : LineField::Line();
        table.pair(i, {points.x[found.index], points.y[found.index], line.normal_x, line.normal_y});
    }
    table.measure(max_distance_m);
}

/// Chooses what is to be searched, and how far.
void Correspondences::choose(const PairTable& table, float radius_m)
{
    const PairColumns c = table.columns();
    unsettled_.clear();
    queries_.clear();
    for (std::size_t i = 0; i < table.scanPoints(); ++i)
    {
        if (room_m_[i] > 0) continue;
        const float dx = c.u[i] - c.x[i], dy = c.v[i] - c.y[i];
        reach_m_[unsettled_.size()] =
            neighbour_[i] == NeighbourGrid::kNone
                ? NeighbourGrid::kLikeBefore
                : std::min(radius_m, std::sqrt(dx * dx + dy * dy) * kRoundUp + kSlack_m);
        unsettled_.push_back(static_cast<std::uint32_t>(i));
        queries_.add(c.x[i], c.y[i]);
    }
}
}  // namespace rtob

// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/io/occupancy_raster.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace rtob
{
namespace
{
// A cell is drawn occupied when more than 2 of 9 rays that reached it end in it: along a wall seen
// at a grazing angle most rays of a cell pass. The bound lets a cell change its mind.
constexpr int hit_evidence = 7;
constexpr int miss_evidence = -2;
constexpr int evidence_bound = 120;
constexpr std::int64_t most_cells = std::int64_t{1} << 28;

void add_evidence(std::int8_t& cell, int evidence)
{
    cell = static_cast<std::int8_t>(std::clamp(cell + evidence, -evidence_bound, evidence_bound));
}
}  // namespace

OccupancyRaster::OccupancyRaster(double resolution_m) : resolution_m_(resolution_m)
{
    if (!(resolution_m > 0) || !std::isfinite(resolution_m))
        throw std::invalid_argument("OccupancyRaster: the resolution must be above 0 m");
}

OccupancyRaster::Cell OccupancyRaster::cell_at(double x_map, double y_map) const
{
    return {
        static_cast<std::int64_t>(std::floor(x_map / resolution_m_)),
        static_cast<std::int64_t>(std::floor(y_map / resolution_m_))};
}

void OccupancyRaster::add_scan(
    const Pose2& pose_map_vehicle, PointsView points_vehicle, double max_range_m,
    const Pose2& pose_vehicle_laser)
{
    const Pose2 pose_map_laser = compose(pose_map_vehicle, pose_vehicle_laser);
    collect_rays(pose_map_vehicle, pose_map_laser, points_vehicle, max_range_m);
    if (rays_.empty()) return;

    const Cell start = cell_at(pose_map_laser.x, pose_map_laser.y);
    Cell low = start, high = start;
    for (const auto& ray : rays_)
    {
        low = {std::min(low.x, ray.end.x), std::min(low.y, ray.end.y)};
        high = {std::max(high.x, ray.end.x), std::max(high.y, ray.end.y)};
    }
    make_room(low, high);
    for (const auto& ray : rays_) free_ray(start, ray.end);
    // After the passing rays, so that a neighbour's ray does not erase what this scan has hit.
    for (const auto& ray : rays_)
        if (ray.is_hit) add_evidence(at(ray.end), hit_evidence);
}

void OccupancyRaster::collect_rays(
    const Pose2& pose_map_vehicle, const Pose2& pose_map_laser, PointsView points_vehicle,
    double max_range_m)
{
    rays_.clear();
    // Farther out cell numbers would lose their meaning; NaN fails the comparison as well.
    constexpr double farthest_m = 1e6;
    const auto is_near = [](double x, double y)
    { return std::abs(x) < farthest_m && std::abs(y) < farthest_m; };
    if (!is_near(pose_map_laser.x, pose_map_laser.y)) return;
    const double c = std::cos(pose_map_vehicle.yaw), s = std::sin(pose_map_vehicle.yaw);
    for (std::size_t i = 0; i < points_vehicle.size; ++i)
    {
        const double x_vehicle = points_vehicle.x[i], y_vehicle = points_vehicle.y[i];
        const double dx = pose_map_vehicle.x + c * x_vehicle - s * y_vehicle - pose_map_laser.x;
        const double dy = pose_map_vehicle.y + s * x_vehicle + c * y_vehicle - pose_map_laser.y;
        if (!is_near(dx, dy)) continue;
        const double range_m = std::hypot(dx, dy);
        const bool is_hit = range_m <= max_range_m;
        const double share = is_hit ? 1 : max_range_m / range_m;
        rays_.push_back(
            {cell_at(pose_map_laser.x + share * dx, pose_map_laser.y + share * dy), is_hit});
    }
}

void OccupancyRaster::make_room(Cell low, Cell high)
{
    const bool empty = evidence_.empty();
    const Cell old_high{low_.x + width_ - 1, low_.y + height_ - 1};
    if (!empty && low.x >= low_.x && low.y >= low_.y && high.x <= old_high.x &&
        high.y <= old_high.y)
        return;

    // Grows by a quarter at once: copying must not become the cost of a long corridor.
    const std::int64_t margin = 64 + std::max(width_, height_) / 4;
    const auto grown = [empty](std::int64_t wanted, std::int64_t old, std::int64_t step)
    {
        const bool fits = !empty && (step < 0 ? wanted >= old : wanted <= old);
        return fits ? old : wanted + step;
    };
    const Cell new_low{grown(low.x, low_.x, -margin), grown(low.y, low_.y, -margin)};
    const Cell new_high{grown(high.x, old_high.x, margin), grown(high.y, old_high.y, margin)};
    const auto new_width = new_high.x - new_low.x + 1, new_height = new_high.y - new_low.y + 1;
    if (new_width > most_cells / new_height)
        throw std::length_error(
            "the map picture would exceed " + std::to_string(most_cells) +
            " cells: choose a coarser resolution than " + std::to_string(resolution_m_) + " m");

    std::vector<std::int8_t> evidence(static_cast<std::size_t>(new_width * new_height), 0);
    for (std::int64_t row = 0; row < height_; ++row)
    {
        const auto offset = (low_.y + row - new_low.y) * new_width + low_.x - new_low.x;
        std::copy_n(evidence_.begin() + row * width_, width_, evidence.begin() + offset);
    }
    evidence_ = std::move(evidence);
    low_ = new_low;
    width_ = new_width;
    height_ = new_height;
}

/// Every cell of the straight line (Bresenham) but its last.
void OccupancyRaster::free_ray(Cell from, Cell to)
{
    const std::int64_t dx = std::abs(to.x - from.x), dy = std::abs(to.y - from.y);
    const std::int64_t x_step = from.x < to.x ? 1 : -1;
    const std::int64_t y_step = from.y < to.y ? width_ : -width_;
    std::int8_t* cell = &at(from);
    std::int64_t error = dx - dy;
    for (std::int64_t steps = std::max(dx, dy); steps > 0; --steps)
    {
        add_evidence(*cell, miss_evidence);
        const std::int64_t twice = 2 * error;
        if (twice > -dy)
        {
            error -= dy;
            cell += x_step;
        }
        if (twice < dx)
        {
            error += dx;
            cell += y_step;
        }
    }
}

OccupancyImage OccupancyRaster::image() const
{
    std::int64_t left = width_, right = -1, bottom = height_, top = -1;
    for (std::int64_t row = 0; row < height_; ++row)
        for (std::int64_t column = 0; column < width_; ++column)
            if (evidence_[static_cast<std::size_t>(row * width_ + column)] != 0)
            {
                left = std::min(left, column);
                right = std::max(right, column);
                bottom = std::min(bottom, row);
                top = row;
            }
    if (top < 0) return {1, 1, resolution_m_, {}, {OccupancyImage::unknown}};

    OccupancyImage image;
    image.width = static_cast<std::size_t>(right - left + 1);
    image.height = static_cast<std::size_t>(top - bottom + 1);
    image.resolution_m = resolution_m_;
    image.origin.x = static_cast<double>(low_.x + left) * resolution_m_;
    image.origin.y = static_cast<double>(low_.y + bottom) * resolution_m_;
    image.pixels.reserve(image.width * image.height);
    for (std::int64_t row = top; row >= bottom; --row)
        for (std::int64_t column = left; column <= right; ++column)
        {
            const int evidence = evidence_[static_cast<std::size_t>(row * width_ + column)];
            image.pixels.push_back(
                evidence > 0   ? OccupancyImage::occupied
                : evidence < 0 ? OccupancyImage::free
                               : OccupancyImage::unknown);
        }
    return image;
}
}  // namespace rtob

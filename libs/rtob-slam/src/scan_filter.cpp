// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/core/option_checks.h>
#include <rtob/slam/scan_filter.h>

#include <cmath>

namespace rtob
{
namespace
{
/// Where a beam ended, with the axes of the level vehicle.
struct Hit
{
    double x, y, z;
};

Hit hit_of(const mrpt::poses::CPose3D& pose_laser, float cos, float sin, float range)
{
    const auto& rotation = pose_laser.getRotationMatrix();
    const double x = range * cos, y = range * sin;
    return {
        pose_laser.x() + rotation(0, 0) * x + rotation(0, 1) * y,
        pose_laser.y() + rotation(1, 0) * x + rotation(1, 1) * y,
        pose_laser.z() + rotation(2, 0) * x + rotation(2, 1) * y};
}
}  // namespace

void ScanFilterOptions::validate() const
{
    require(min_range_m >= 0, "min_range_m", min_range_m, ">= 0");
    require(max_range_m > min_range_m, "max_range_m", max_range_m, "> min_range_m");
    require(max_beams >= 10, "max_beams", max_beams, ">= 10");
    require(max_matched >= 10, "max_matched", max_matched, ">= 10");
    static_cast<void>(AngleMask(mask_deg));
}

BeamCounts& BeamCounts::operator+=(const BeamCounts& other)
{
    used += other.used;
    invalid += other.invalid;
    not_a_number += other.not_a_number;
    not_positive += other.not_positive;
    too_near += other.too_near;
    too_far += other.too_far;
    masked += other.masked;
    thinned += other.thinned;
    floor_or_ceiling += other.floor_or_ceiling;
    return *this;
}

ScanFilter::ScanFilter(const ScanFilterOptions& options)
    : options_(options), mask_(options.mask_deg)
{
    options_.validate();
}

void ScanFilter::lookUpDirections(const mrpt::obs::CObservation2DRangeScan& scan)
{
    const std::size_t beams = scan.getScanSize();
    if (directions_.size() == beams && aperture_rad_ == scan.aperture &&
        right_to_left_ == scan.rightToLeft)
        return;
    aperture_rad_ = scan.aperture;
    right_to_left_ = scan.rightToLeft;
    directions_.resize(beams);
    const double first_rad = (right_to_left_ ? -0.5 : 0.5) * scan.aperture;
    const double step_rad = beams < 2 ? 0.0 : -2 * first_rad / (static_cast<double>(beams) - 1);
    for (std::size_t i = 0; i < beams; ++i)
    {
        const double bearing_rad = first_rad + step_rad * static_cast<double>(i);
        directions_[i] = {
            static_cast<float>(std::cos(bearing_rad)), static_cast<float>(std::sin(bearing_rad)),
            mask_.contains(bearing_rad)};
    }
}

/// The beams follow each other in the order of their index; the pose is for the middle one.
void ScanFilter::lookUpMotion(const ScanGeometry& geometry, std::size_t beams)
{
    motion_.resize(beams);
    for (std::size_t i = 0; i < beams; ++i)
    {
        const double share = (static_cast<double>(i) + 0.5) / static_cast<double>(beams) - 0.5;
        motion_[i] = carried(geometry.twist, share * geometry.sweep_s);
    }
}

BeamCounts ScanFilter::filter(
    const mrpt::obs::CObservation2DRangeScan& scan, const ScanGeometry& geometry,
    Points& points_vehicle)
{
    lookUpDirections(scan);
    points_vehicle.clear();
    BeamCounts counts;
    const std::size_t beams = scan.getScanSize();
    const auto wanted = static_cast<std::size_t>(options_.max_beams);
    const std::size_t stride = (beams + wanted - 1) / wanted;
    const bool is_skewed = geometry.isSkewed();
    if (is_skewed) lookUpMotion(geometry, beams);
    for (std::size_t i = 0; i < beams; ++i)
    {
        const float range = scan.getScanRange(i);
        const Direction& direction = directions_[i];
        if (!std::isfinite(range))
            ++counts.not_a_number;
        else if (range <= 0)
            ++counts.not_positive;
        else if (!scan.getScanRangeValidity(i))
            ++counts.invalid;
        else if (direction.masked)
            ++counts.masked;
        else if (range < options_.min_range_m)
            ++counts.too_near;
        else if (range > options_.max_range_m)
            ++counts.too_far;
        else if (i % stride != 0)
            ++counts.thinned;
        else
        {
            const Hit hit = hit_of(geometry.pose_level_laser, direction.cos, direction.sin, range);
            if (hit.z < geometry.lowest_m || hit.z > geometry.highest_m)
            {
                ++counts.floor_or_ceiling;
                continue;
            }
            ++counts.used;
            const Pose2 at =
                is_skewed ? compose(motion_[i], {hit.x, hit.y, 0}) : Pose2{hit.x, hit.y, 0};
            points_vehicle.add(static_cast<float>(at.x), static_cast<float>(at.y));
        }
    }
    return counts;
}
}  // namespace rtob

// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/core/option_checks.h>
#include <rtob/slam/scan_filter.h>

#include <cmath>

namespace rtob
{
void ScanFilterOptions::validate() const
{
    require(min_range_m >= 0, "min_range_m", min_range_m, ">= 0");
    require(max_range_m > min_range_m, "max_range_m", max_range_m, "> min_range_m");
    require(max_beams >= 10, "max_beams", max_beams, ">= 10");
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

BeamCounts ScanFilter::filter(
    const mrpt::obs::CObservation2DRangeScan& scan, const mrpt::poses::CPose3D& pose_vehicle_laser,
    Points& points_vehicle)
{
    lookUpDirections(scan);
    points_vehicle.clear();
    BeamCounts counts;
    const std::size_t beams = scan.getScanSize();
    const auto wanted = static_cast<std::size_t>(options_.max_beams);
    const std::size_t stride = (beams + wanted - 1) / wanted;
    const auto& rotation = pose_vehicle_laser.getRotationMatrix();
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
            ++counts.used;
            const double x = range * direction.cos, y = range * direction.sin;
            points_vehicle.add(
                static_cast<float>(
                    pose_vehicle_laser.x() + rotation(0, 0) * x + rotation(0, 1) * y),
                static_cast<float>(
                    pose_vehicle_laser.y() + rotation(1, 0) * x + rotation(1, 1) * y));
        }
    }
    return counts;
}
}  // namespace rtob

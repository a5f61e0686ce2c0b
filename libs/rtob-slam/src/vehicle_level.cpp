// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/map/conversions.h>
#include <rtob/slam/vehicle_level.h>

#include <algorithm>
#include <cmath>

namespace rtob
{
namespace
{
constexpr std::size_t kKept = 512;       // readings: over a second of a fast autopilot's
constexpr double kFresh_s = 0.3;         // a reading says nothing of a time farther away
constexpr double kOverturned_rad = 1.4;  // no scan of such a vehicle shows the plane
constexpr double kRestless_m = 0.3;      // a table below the vehicle is a step in its height
}  // namespace

VehicleLevel::VehicleLevel(const FusionOptions& options)
    : max_climb_mps_(options.max_climb_mps), tilts_(kKept), heights_(kKept)
{
}

void VehicleLevel::observe(const mrpt::obs::CObservation& observation)
{
    const double time_s = stamp_of(observation);
    if (const auto tilt = tilt_in(observation)) addTilt(time_s, *tilt);
    if (const auto height_m = height_in(observation)) addHeight(time_s, *height_m);
}

void VehicleLevel::addTilt(double time_s, const Tilt& tilt)
{
    const bool is_plausible =
        std::abs(tilt.roll_rad) < kOverturned_rad && std::abs(tilt.pitch_rad) < kOverturned_rad;
    add(time_s, {tilt.roll_rad, tilt.pitch_rad}, is_plausible, attitude_, tilts_);
}

/// A height that jumped counts again once the vehicle could have climbed there.
void VehicleLevel::addHeight(double time_s, double height_m)
{
    bool is_plausible = height_m >= 0;
    if (!heights_.empty())
    {
        const double climb_s = time_s - heights_.back().time_s;
        const double most_m = kRestless_m + max_climb_mps_ * climb_s;
        is_plausible = is_plausible && std::abs(height_m - heights_.back().value.x()) <= most_m;
    }
    add(time_s, {height_m, 0}, is_plausible, altimeter_, heights_);
}

void VehicleLevel::add(
    double time_s, const Eigen::Vector2d& value, bool is_plausible, SensorWatch& watch,
    Readings& readings)
{
    const Measurement reading{
        Measurement::Kind::Velocity,
        time_s,
        {value.x(), value.y(), 0},
        Eigen::Matrix3d::Identity()};
    if (is_finite(reading) && !is_plausible)
    {
        watch.refused(ReadingFate::Implausible);
        return;
    }
    if (watch.admit(reading, time_s) != ReadingFate::Used) return;
    watch.took({});
    readings.push_back({time_s, value});
}

/// Between two readings, in proportion.
std::optional<Eigen::Vector2d> VehicleLevel::at(double time_s, const Readings& readings)
{
    const auto later = std::lower_bound(
        readings.begin(), readings.end(), time_s,
        [](const Reading& reading, double time) { return reading.time_s < time; });
    const bool has_later = later != readings.end() && later->time_s - time_s <= kFresh_s;
    const bool has_earlier =
        later != readings.begin() && time_s - std::prev(later)->time_s <= kFresh_s;
    if (has_earlier && has_later)
    {
        const Reading& earlier = *std::prev(later);
        const double share = (time_s - earlier.time_s) / (later->time_s - earlier.time_s);
        return (1 - share) * earlier.value + share * later->value;
    }
    if (has_later) return later->value;
    if (has_earlier) return std::prev(later)->value;
    return std::nullopt;
}

std::optional<Tilt> VehicleLevel::tiltAt(double time_s) const
{
    const auto tilt = at(time_s, tilts_);
    return tilt ? std::optional(Tilt{tilt->x(), tilt->y()}) : std::nullopt;
}

std::optional<double> VehicleLevel::heightAt(double time_s) const
{
    const auto height = at(time_s, heights_);
    return height ? std::optional(height->x()) : std::nullopt;
}
}  // namespace rtob

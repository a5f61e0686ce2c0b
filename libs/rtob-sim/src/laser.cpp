// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/core/option_checks.h>
#include <rtob/sim/laser.h>

#include <algorithm>
#include <utility>

namespace rtob::sim
{
namespace
{
constexpr double rad_per_deg = 3.14159265358979323846 / 180;
constexpr std::size_t bundle_beams = 32;  // small enough to leave most of a room out
constexpr double bundle_rad = 1.0;        // and narrow enough for Bundle, whatever the laser
constexpr double rounding_s = 1e-9;
constexpr int max_bounces = 8;

/// The beam at this bearing from a laser that is tilted as its vehicle.
Beam beam_from(const Pose3& pose_map, double bearing_rad)
{
    const double cb = std::cos(bearing_rad), sb = std::sin(bearing_rad);
    Point2 ahead{cb, sb};
    double up = 0;
    if (pose_map.roll != 0 || pose_map.pitch != 0)
    {
        const double rolled_up = sb * std::sin(pose_map.roll);
        const double cp = std::cos(pose_map.pitch), sp = std::sin(pose_map.pitch);
        ahead = {cb * cp + rolled_up * sp, sb * std::cos(pose_map.roll)};
        up = -cb * sp + rolled_up * cp;
    }
    const double c = std::cos(pose_map.yaw), s = std::sin(pose_map.yaw);
    const Point2 turned{c * ahead.x - s * ahead.y, s * ahead.x + c * ahead.y};
    const double in_plane = length(turned);
    return {{pose_map.x, pose_map.y}, pose_map.z, (1 / in_plane) * turned, up / in_plane};
}

double direction_rad(const Beam& beam)
{
    return std::atan2(beam.direction_map.y, beam.direction_map.x);
}

Bundle bundle_around(const std::vector<Beam>& beams, double max_range_m)
{
    const Beam &first = beams.front(), &last = beams.back();
    const double turn_rad = wrap_angle(direction_rad(last) - direction_rad(first));
    Bundle bundle;
    bundle.origin_map = first.origin_map;
    bundle.spread_m = length(last.origin_map - first.origin_map);
    bundle.from_rad = turn_rad < 0 ? direction_rad(last) : direction_rad(first);
    bundle.sweep_rad = std::abs(turn_rad);
    bundle.reach_m = max_range_m;
    return bundle;
}
}  // namespace

void LaserOptions::validate() const
{
    require(beams >= 1 && beams <= 100000, "beams", beams, "1 to 100000");
    require(rate_hz > 0, "rate_hz", rate_hz, "> 0");
    require(
        field_of_view_deg > 0 && field_of_view_deg <= 360, "field_of_view_deg", field_of_view_deg,
        "> 0 and at most 360");
    require(min_range_m >= 0, "min_range_m", min_range_m, ">= 0");
    require(max_range_m > min_range_m, "max_range_m", max_range_m, "> min_range_m");
    require(noise_m >= 0, "noise_m", noise_m, ">= 0");
    require(noise_per_m >= 0, "noise_per_m", noise_per_m, ">= 0");
    require(dropout >= 0 && dropout <= 1, "dropout", dropout, "0 to 1");
    require(stamp_at >= 0 && stamp_at <= 1, "stamp_at", stamp_at, "0 to 1");
}

double LaserOptions::step_rad() const
{
    return (clockwise ? -1 : 1) * field_of_view_deg * rad_per_deg / beams;
}

double LaserOptions::first_bearing_rad() const
{
    return -0.5 * step_rad() * (beams - 1);
}

Laser::Laser(const LaserOptions& options, std::uint64_t seed) : options_(options), noise_(seed, 1)
{
    options_.validate();
    startScan(0);
}

double Laser::beamTime() const
{
    return scan_.first_beam_s + static_cast<double>(scan_.ranges_m.size()) * scan_.beam_interval_s;
}

double Laser::stampTime() const
{
    return scan_.first_beam_s + options_.stamp_at * (options_.beams - 1) * scan_.beam_interval_s;
}

void Laser::startScan(double time_s)
{
    scan_ = {};
    scan_.first_beam_s = time_s;
    scan_.beam_interval_s = options_.beam_interval_s();
    scan_.first_bearing_rad = options_.first_bearing_rad();
    scan_.step_rad = options_.step_rad();
    scan_.time_s = stampTime();
    scan_.ranges_m.reserve(static_cast<std::size_t>(options_.beams));
    is_stamped_ = false;
}

void Laser::sweep(
    const Scene& scene, double from_s, const Pose3& from_map, double to_s, const Pose3& to_map)
{
    const auto pose_at = [&](double time_s) {
        return between(from_map, to_map, std::clamp((time_s - from_s) / (to_s - from_s), 0.0, 1.0));
    };
    const auto all_beams = static_cast<std::size_t>(options_.beams);
    const auto widest = static_cast<std::size_t>(bundle_rad / std::abs(options_.step_rad()));
    while (beamTime() < to_s - rounding_s)
    {
        poses_map_.clear();
        const auto room = std::min(
            all_beams - scan_.ranges_m.size(), std::clamp<std::size_t>(widest, 1, bundle_beams));
        for (double time_s = beamTime(); time_s < to_s - rounding_s && poses_map_.size() < room;
             time_s += scan_.beam_interval_s)
            poses_map_.push_back(pose_at(time_s));
        castBundle(scene, poses_map_);
        if (!is_stamped_ && scan_.time_s < to_s + rounding_s)
        {
            scan_.pose_map_vehicle = pose_at(scan_.time_s);
            is_stamped_ = true;
        }
        if (scan_.ranges_m.size() < all_beams) continue;
        finished_ = std::move(scan_);
        startScan(static_cast<double>(++turn_) * options_.period_s());
    }
}

std::optional<LaserScan> Laser::takeScan()
{
    return std::exchange(finished_, std::nullopt);
}

LaserScan Laser::snapshot(const Scene& scene, double time_s, const Pose3& pose_map)
{
    Laser still(*this);
    still.startScan(time_s);
    const double turn_s = still.options_.beams * still.scan_.beam_interval_s;
    still.sweep(scene, time_s, pose_map, time_s + turn_s, pose_map);
    noise_ = still.noise_;
    LaserScan scan = std::move(*still.finished_);
    scan.time_s = scan.first_beam_s = time_s;
    scan.beam_interval_s = 0;
    return scan;
}

void Laser::castBundle(const Scene& scene, const std::vector<Pose3>& poses_map)
{
    beams_.clear();
    const auto first_beam = scan_.ranges_m.size();
    for (std::size_t i = 0; i < poses_map.size(); ++i)
        beams_.push_back(beam_from(poses_map[i], scan_.bearing_rad(first_beam + i)));
    scene.select(bundle_around(beams_, options_.max_range_m), selection_);
    for (const auto& beam : beams_) scan_.ranges_m.push_back(measure(scene, beam));
}

float Laser::measure(const Scene& scene, Beam beam)
{
    double before_m = 0, passed_m = 0;  // in the plane: up to the last mirror, and the last glass
    const double stretch = std::sqrt(1 + beam.slope * beam.slope);
    for (int bounces = 0; bounces < max_bounces; ++bounces)
    {
        // Behind a mirror the beam leaves its bundle.
        const Hit hit =
            before_m > 0 ? scene.cast(beam, passed_m) : scene.cast(beam, selection_, passed_m);
        const double range_m = stretch * (before_m + hit.distance_m);
        if (range_m > options_.max_range_m) return 0;
        const bool is_ground = hit.normal_map.x == 0 && hit.normal_map.y == 0;
        const Surface surface = is_ground ? Surface{} : scene.world().objects[hit.object].surface;
        if (surface.isPlain()) return reading(range_m);
        if (noise_.happens(surface.transparency))
            passed_m = hit.distance_m;
        else if (noise_.happens(surface.mirror))
        {
            const double height_m = beam.height_at(hit.distance_m);
            beam.origin_map = beam.origin_map + hit.distance_m * beam.direction_map;
            beam.z_m = height_m;
            const double inward = dot(beam.direction_map, hit.normal_map);
            beam.direction_map = beam.direction_map - 2 * inward * hit.normal_map;
            before_m += hit.distance_m;
            passed_m = rounding_s;  // not the mirror itself again
        }
        else if (noise_.happens(surface.dropout))
            return 0;
        else
            return reading(range_m);
    }
    return 0;
}

float Laser::reading(double range_m)
{
    if (noise_.happens(options_.dropout)) return 0;
    const double sigma_m = options_.noise_m + options_.noise_per_m * range_m;
    const double measured_m = sigma_m > 0 ? range_m + noise_.gaussian(sigma_m) : range_m;
    const bool is_inside = measured_m >= options_.min_range_m && measured_m <= options_.max_range_m;
    return is_inside ? static_cast<float>(measured_m) : 0;
}
}  // namespace rtob::sim

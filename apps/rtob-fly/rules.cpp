// SPDX-License-Identifier: BSD-3-Clause
#include "rules.h"

#include <algorithm>
#include <cmath>

namespace rtob::fly
{
namespace
{
using Eigen::Vector2d;

constexpr double kPi = 3.14159265358979323846;
constexpr double kOldest_s = 0.5;  // of the data, with both

// PX4's defaults: CP_DELAY, CP_GUIDE_ANG, MPC_XY_P, MPC_JERK_AUTO; its cost of a deviation.
constexpr double kDelay_s = 0.4;
constexpr int kGuideSectors = 6;
constexpr double kPositionGain = 0.95;
constexpr double kJerk_mps3 = 4;
constexpr double kDeviationCost = 50;

// ArduPilot's defaults: AVOID_BACKUP_SPD, AVOID_BACKUP_DZ, the acceleration that it counts on.
constexpr double kBackup_mps = 0.75;
constexpr double kBackupDeadZone_m = 0.10;
constexpr double kAvoidAcceleration_mps2 = 1.0;
constexpr double kAvoidGain = 1.0;

Vector2d along(double bearing_rad)
{
    return {std::cos(bearing_rad), std::sin(bearing_rad)};
}

Vector2d capped(const Vector2d& wish, double fastest_mps)
{
    const double speed_mps = wish.norm();
    return speed_mps > fastest_mps ? Vector2d(wish * (fastest_mps / speed_mps)) : wish;
}

/// From which speed a vehicle stops in this distance, its jerk and acceleration limited.
double stopping_speed(double distance_m, double acceleration_mps2)
{
    const double b = 4 * acceleration_mps2 * acceleration_mps2 / kJerk_mps3;
    const double c = -2 * acceleration_mps2 * distance_m;
    return std::max(0.0, 0.5 * (-b + std::sqrt(b * b - 4 * c)));
}

/// Proportional near the target, then along a square root.
double square_root_controller(double distance_m, double gain, double acceleration_mps2)
{
    const double linear_m = acceleration_mps2 / (gain * gain);
    if (distance_m <= linear_m) return distance_m * gain;
    return std::sqrt(2 * acceleration_mps2 * (distance_m - linear_m / 2));
}

GuardDecision answer(const Vector2d& wish, const Vector2d& velocity)
{
    GuardDecision decision;
    decision.velocity_vehicle = velocity;
    const bool is_free = velocity == wish;
    decision.reason = is_free             ? GuardReason::Free
                      : velocity.isZero() ? GuardReason::Blocked
                                          : GuardReason::Slowed;
    return decision;
}
}  // namespace

SectorRanges::SectorRanges(int sectors) : sectors_(static_cast<std::size_t>(sectors)) {}

int SectorRanges::sectorAt(double bearing_rad) const
{
    const auto count = static_cast<double>(sectors_.size());
    const double turns = bearing_rad / (2 * kPi);
    return static_cast<int>(std::floor((turns - std::floor(turns)) * count + 0.5)) %
           static_cast<int>(count);
}

double SectorRanges::bearingOf(int sector) const
{
    return 2 * kPi * sector / static_cast<double>(sectors_.size());
}

const SectorRanges::Sector& SectorRanges::at(int sector) const
{
    const auto count = static_cast<int>(sectors_.size());
    return sectors_[static_cast<std::size_t>((sector % count + count) % count)];
}

void SectorRanges::take(const GuardScan& scan)
{
    for (Sector& sector : sectors_) sector = {};
    for (std::size_t i = 0; i < scan.beams; ++i)
    {
        const double bearing_rad = scan.first_bearing_rad + static_cast<double>(i) * scan.step_rad;
        Sector& sector = sectors_[static_cast<std::size_t>(sectorAt(bearing_rad))];
        // No return: nothing within reach, as far as these rules are told.
        const double range_m = scan.ranges_m[i] > 0 ? scan.ranges_m[i] : scan.max_range_m;
        if (sector.range_m == 0 || range_m < sector.range_m) sector = {range_m, bearing_rad};
    }
    time_s_ = scan.end_s();
}

/// The sector within the guidance's angle that costs least: deviation against distance, in cm.
int CollisionPrevention::guided(int wished_sector) const
{
    double least_cost = 1e18;
    int best = wished_sector;
    for (int off = -kGuideSectors; off <= kGuideSectors; ++off)
    {
        const int sector = wished_sector + off;
        if (ranges_.at(sector).range_m == 0) continue;
        double mean_m = 0;
        for (int beside = -1; beside <= 1; ++beside)
        {
            const double range_m = ranges_.at(sector + beside).range_m;
            mean_m += (range_m == 0 ? limits_.clearance() : range_m) / 3;
        }
        const double cost = limits_.clearance() * kDeviationCost * std::abs(off) - 100 * mean_m -
                            100 * ranges_.at(sector).range_m;
        if (cost >= least_cost) continue;
        least_cost = cost;
        best = sector;
    }
    return best;
}

double CollisionPrevention::speedLimit(
    double now_s, double bearing_rad, const Vector2d& velocity) const
{
    const Vector2d direction = along(bearing_rad);
    const double age_s = now_s - ranges_.time_s();
    double limit_mps = limits_.max_speed_mps;
    for (int i = 0; i < static_cast<int>(ranges_.sectors().size()); ++i)
    {
        const Vector2d to_sector = along(ranges_.bearingOf(i));
        const double share = to_sector.dot(direction);
        if (share <= 0.01 || ranges_.at(i).range_m <= 0) continue;
        const double towards_mps = std::max(0.0, velocity.dot(to_sector));
        const double stop_m = std::max(
            0.0, ranges_.at(i).range_m - limits_.clearance() - towards_mps * (kDelay_s + age_s));
        const double most_mps =
            std::min(kPositionGain * stop_m, stopping_speed(stop_m, limits_.acceleration_mps2));
        limit_mps = std::min(limit_mps, most_mps / share);
    }
    return limit_mps;
}

GuardDecision CollisionPrevention::decide(
    double now_s, const Vector2d& wish_vehicle, const VehicleMotion& motion)
{
    if (wish_vehicle.isZero()) return answer(wish_vehicle, wish_vehicle);
    if (now_s - ranges_.time_s() > kOldest_s) return {};
    const double wished_rad = std::atan2(wish_vehicle.y(), wish_vehicle.x());
    const int wished_sector = ranges_.sectorAt(wished_rad);
    const int sector = guided(wished_sector);
    if (ranges_.at(sector).range_m == 0) return answer(wish_vehicle, Vector2d::Zero());
    const double bend_rad = (sector - wished_sector) * ranges_.bearingOf(1);
    const double bearing_rad = wished_rad + bend_rad;
    const double speed_mps =
        std::min(wish_vehicle.norm(), speedLimit(now_s, bearing_rad, motion.velocity_vehicle));
    if (bend_rad == 0 && speed_mps == wish_vehicle.norm())
        return answer(wish_vehicle, wish_vehicle);
    GuardDecision decision = answer(wish_vehicle, speed_mps * along(bearing_rad));
    decision.bend_rad = bend_rad;
    return decision;
}

GuardDecision SimpleAvoidance::decide(
    double now_s, const Vector2d& wish_vehicle, const VehicleMotion&)
{
    Vector2d velocity = capped(wish_vehicle, limits_.max_speed_mps);
    if (now_s - ranges_.time_s() > kOldest_s) return answer(wish_vehicle, velocity);
    Vector2d back_up = Vector2d::Zero();
    for (const SectorRanges::Sector& sector : ranges_.sectors())
    {
        if (sector.range_m <= 0) continue;
        const Vector2d direction = along(sector.bearing_rad);
        const double left_m = sector.range_m - limits_.clearance();
        if (left_m < -kBackupDeadZone_m)
            back_up -= std::min(kBackup_mps, kAvoidGain * -left_m) * direction;
        const double most_mps =
            left_m > 0 ? square_root_controller(left_m, kAvoidGain, kAvoidAcceleration_mps2) : 0;
        const double towards_mps = velocity.dot(direction);
        if (towards_mps > most_mps) velocity -= (towards_mps - most_mps) * direction;
    }
    return answer(wish_vehicle, capped(velocity + back_up, limits_.max_speed_mps));
}
}  // namespace rtob::fly

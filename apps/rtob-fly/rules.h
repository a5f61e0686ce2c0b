// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "avoider.h"

/// Two widely used rules, written anew from what is published about them, for comparison. Both are
/// given our clearance as the distance to keep and our vehicle's stated limits.
namespace rtob::fly
{
/// Nearest range of each sector around the vehicle, with its bearing, as autopilots keep them.
class SectorRanges
{
 public:
    explicit SectorRanges(int sectors);

    struct Sector
    {
        double range_m = 0;  ///< 0: no data
        double bearing_rad = 0;
    };
    void take(const GuardScan& scan);
    [[nodiscard]] const std::vector<Sector>& sectors() const { return sectors_; }
    [[nodiscard]] double time_s() const { return time_s_; }
    [[nodiscard]] int sectorAt(double bearing_rad) const;
    [[nodiscard]] double bearingOf(int sector) const;
    /// Wraps around.
    [[nodiscard]] const Sector& at(int sector) const;

 private:
    std::vector<Sector> sectors_;
    double time_s_ = -1e9;
};

/// PX4's Collision Prevention in its velocity form: 72 sectors; guidance by the cheapest sector;
/// in each sector ahead the speed from which it can stop, after delay and age of the data. No data
/// where the way leads: no motion (CP_GO_NO_DATA 0).
class CollisionPrevention : public Avoider
{
 public:
    explicit CollisionPrevention(const VehicleLimits& limits) : limits_(limits) {}

    void observe(const GuardScan& scan, const MapPose&) override { ranges_.take(scan); }
    GuardDecision decide(
        double now_s, const Eigen::Vector2d& wish_vehicle, const VehicleMotion& motion) override;

 private:
    [[nodiscard]] int guided(int wished_sector) const;
    [[nodiscard]] double speedLimit(
        double now_s, double bearing_rad, const Eigen::Vector2d& velocity) const;

    VehicleLimits limits_;
    SectorRanges ranges_{72};
};

/// ArduPilot's Simple Avoidance, sliding: the nearest thing of each of 8 sectors caps the velocity
/// towards it so that the stopping distance is the distance left; inside the margin it backs away.
/// No delay, no data: no limit.
class SimpleAvoidance : public Avoider
{
 public:
    explicit SimpleAvoidance(const VehicleLimits& limits) : limits_(limits) {}

    void observe(const GuardScan& scan, const MapPose&) override { ranges_.take(scan); }
    GuardDecision decide(
        double now_s, const Eigen::Vector2d& wish_vehicle, const VehicleMotion& motion) override;

 private:
    VehicleLimits limits_;
    SectorRanges ranges_{8};
};
}  // namespace rtob::fly

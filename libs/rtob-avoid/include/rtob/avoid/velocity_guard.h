// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/avoid/command_log.h>
#include <rtob/avoid/guidance.h>
#include <rtob/avoid/obstacle_memory.h>
#include <rtob/avoid/scan_picture.h>
#include <rtob/avoid/stopping_area.h>

#include <array>
#include <optional>
#include <string_view>
#include <utility>

namespace rtob
{
/// Why the commanded velocity is what it is.
enum class GuardReason
{
    Free,     ///< as wished
    Guided,   ///< bent towards the free side
    Slowed,   ///< slower than wished
    Blocked,  ///< stopped by an obstacle
    NoData,   ///< stopped or slowed: nothing is known there, or what is measured is no number
    Stale,    ///< stopped: the newest scan is too old
    Lost      ///< flies by the laser alone, slowly
};

constexpr auto enum_names(GuardReason)
{
    return std::array<std::pair<GuardReason, std::string_view>, 7>{
        {{GuardReason::Free, "FREE"},
         {GuardReason::Guided, "GUIDED"},
         {GuardReason::Slowed, "SLOWED"},
         {GuardReason::Blocked, "BLOCKED"},
         {GuardReason::NoData, "NO_DATA"},
         {GuardReason::Stale, "STALE"},
         {GuardReason::Lost, "LOST"}}};
}

/// Where SLAM sees the vehicle.
struct MapPose
{
    double stamp_s = 0;  ///< on the clock of the decisions
    Pose2 pose_map_vehicle;
    double sigma_m = 0;  ///< standard deviation of the position, the larger axis
    bool is_lost = true;
};

struct GuardDecision
{
    Eigen::Vector2d velocity_vehicle = Eigen::Vector2d::Zero();  ///< to fly, m/s
    GuardReason reason = GuardReason::NoData;
    double bend_rad = 0;              ///< from the wish's direction, to the left
    double limiting_bearing_rad = 0;  ///< seen from the vehicle; 0 where nothing limits
    double limiting_distance_m = 0;   ///< from the vehicle's middle; 0 where nothing limits
};

/// Turns what the pilot wishes into what can be flown: never faster than wished, and always such
/// that the vehicle can still stop before all obstacles that its laser sees or has seen. Knows
/// nothing of SLAM but a pose, and goes on without. docs/avoidance.md has the model. One thread;
/// allocates nothing once it has seen a scan.
class VelocityGuard
{
 public:
    /// @throws std::invalid_argument naming a key out of its range
    explicit VelocityGuard(const VehicleLimits& vehicle = {}, const GuardOptions& options = {});

    /// Takes a new scan and the pose that SLAM found for it. What cannot be used is passed over.
    void observe(const GuardScan& scan, const MapPose& pose = {});

    /// What to fly now. Call it at least once per VehicleLimits::period_s.
    [[nodiscard]] GuardDecision decide(
        double now_s, const Eigen::Vector2d& wish_vehicle, const VehicleMotion& motion);

    [[nodiscard]] bool usesMemory() const { return pose_map_picture_.has_value(); }
    /// What earlier scans saw and the newest does not show.
    [[nodiscard]] PointsView remembered_map() const { return memory_.points_map(); }

 private:
    struct Way
    {
        Eigen::Vector2d velocity_vehicle = Eigen::Vector2d::Zero();
        double bend_rad = 0;
        bool is_unknown = false;  ///< leads where nothing is known
    };
    [[nodiscard]] GuardDecision judge(
        double now_s, const Eigen::Vector2d& wish_vehicle, const VehicleMotion& motion);
    [[nodiscard]] GuardDecision choose(const Eigen::Vector2d& wish_vehicle);
    void locate(const MapPose& pose);
    [[nodiscard]] double rememberedKeep() const;
    void gatherObstacles(double way_m);
    void setActing(const VehicleMotion& motion, double now_s);
    [[nodiscard]] bool isUnknown(double bearing_rad) const;
    [[nodiscard]] bool isClosed(double bearing_rad) const;
    /// As far as the obstacles at risk know.
    [[nodiscard]] bool isSafe(const Eigen::Vector2d& command) const;
    [[nodiscard]] Way asWished(const Eigen::Vector2d& wish_vehicle, double bend_rad) const;
    [[nodiscard]] Way bestWay(const Eigen::Vector2d& wish_vehicle);
    [[nodiscard]] Way fastest(const Way& whole);
    void nameLimit(const Eigen::Vector2d& wish_vehicle, GuardDecision& decision) const;

    VehicleLimits vehicle_;
    GuardOptions options_;
    DeadReckoning reckoning_;
    ScanPicture picture_;
    ObstacleMemory memory_;
    std::optional<Pose2> pose_map_picture_;  ///< the vehicle's at the picture's time; none: lost
    double pose_sigma_m_ = 0;
    CommandLog commands_;
    StoppingArea stopping_;
    Guidance guidance_;
    NearObstacles obstacles_;     ///< all that may matter for this decision
    NearObstacles at_risk_;       ///< those that matter for one way
    NearObstacles uncleared_;     ///< those that a stop at once is not sure to keep clear of
    Pose2 pose_picture_vehicle_;  ///< the vehicle now, seen from where it was at the picture's time
};
}  // namespace rtob

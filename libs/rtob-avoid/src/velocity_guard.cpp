// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/avoid/velocity_guard.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "usable_input.h"

namespace rtob
{
namespace
{
using Eigen::Vector2d;

// A pose this far from where the vehicle's own motion leads is another map, or another place of it.
constexpr double kPoseJump_m = 0.3;
constexpr double kPoseJump_rad = 0.2;
// Nothing stands unseen nearer to the vehicle's margin than this: the laser would have shown it
// from somewhere on the way here.
constexpr double kSeenAround_m = 0.5;
// Where obstacles leave less than this, the vehicle stops.
constexpr double kSlowest_mps = 0.01;
constexpr int kHalvings = 7;
constexpr std::size_t kScanPoints = 2048;  // that there is room for

double bearing_of(const Vector2d& vector)
{
    return std::atan2(vector.y(), vector.x());
}

Vector2d turned(const Vector2d& vector, double angle_rad)
{
    const double c = std::cos(angle_rad), s = std::sin(angle_rad);
    return {c * vector.x() - s * vector.y(), s * vector.x() + c * vector.y()};
}

bool is_jump(const Pose2& pose_expected_found)
{
    return std::hypot(pose_expected_found.x, pose_expected_found.y) > kPoseJump_m ||
           std::abs(pose_expected_found.yaw) > kPoseJump_rad;
}

GuardDecision stop(GuardReason reason)
{
    return {Vector2d::Zero(), reason};
}

template <class Options>
const Options& checked(const Options& options)
{
    options.validate();
    return options;
}
}  // namespace

VelocityGuard::VelocityGuard(const VehicleLimits& vehicle, const GuardOptions& options)
    : vehicle_(checked(vehicle)),
      options_(checked(options)),
      picture_(options),
      memory_(options),
      commands_(vehicle.latency_s),
      stopping_(vehicle),
      guidance_(options),
      obstacles_(static_cast<std::size_t>(options.memory_points) + kScanPoints),
      at_risk_(static_cast<std::size_t>(options.memory_points) + kScanPoints),
      uncleared_(static_cast<std::size_t>(options.memory_points) + kScanPoints)
{
}

void VelocityGuard::observe(const GuardScan& scan, const MapPose& pose)
{
    const bool is_new = picture_.isEmpty() || scan.end_s() > picture_.time_s();
    const bool is_in_time = reckoning_.poseAt(scan.stamp_s) && reckoning_.poseAt(scan.end_s());
    if (!is_usable(scan) || !is_new || !is_in_time) return;
    if (pose_map_picture_) memory_.add(picture_, *pose_map_picture_, picture_.time_s());
    const Pose2 pose_odom_before = picture_.poseOdomVehicle();
    if (!picture_.take(scan, reckoning_)) return;
    if (pose_map_picture_)  // until SLAM says better
        pose_map_picture_ =
            compose(*pose_map_picture_, between(pose_odom_before, picture_.poseOdomVehicle()));
    locate(pose);
    if (pose_map_picture_)
        memory_.update(picture_, *pose_map_picture_, picture_.time_s());
    else
        memory_.clear();
}

void VelocityGuard::locate(const MapPose& pose)
{
    const auto pose_odom_stamp =
        is_usable(pose) ? reckoning_.poseAt(pose.stamp_s) : std::optional<Pose2>();
    if (!pose_odom_stamp)
    {
        pose_map_picture_.reset();
        return;
    }
    const Pose2 pose_map_found =
        compose(pose.pose_map_vehicle, between(*pose_odom_stamp, picture_.poseOdomVehicle()));
    if (pose_map_picture_ && is_jump(between(*pose_map_picture_, pose_map_found))) memory_.clear();
    pose_map_picture_ = pose_map_found;
    pose_sigma_m_ = pose.sigma_m;
}

GuardDecision VelocityGuard::decide(
    double now_s, const Vector2d& wish_vehicle, const VehicleMotion& motion)
{
    const GuardDecision decision = judge(now_s, wish_vehicle, motion);
    if (reckoning_.hasStarted())
        commands_.add(now_s, turned(decision.velocity_vehicle, reckoning_.newest().yaw));
    return decision;
}

GuardDecision VelocityGuard::judge(
    double now_s, const Vector2d& wish_vehicle, const VehicleMotion& motion)
{
    if (!std::isfinite(now_s) || !is_usable(motion)) return stop(GuardReason::NoData);
    if (!reckoning_.add(now_s, motion))
    {
        picture_.clear();
        commands_.clear();
    }
    if (!wish_vehicle.allFinite() || picture_.isEmpty()) return stop(GuardReason::NoData);
    if (!(std::abs(now_s - picture_.time_s()) <= options_.max_scan_age_s))
        return stop(GuardReason::Stale);
    pose_picture_vehicle_ = between(picture_.poseOdomVehicle(), reckoning_.newest());
    setActing(motion, now_s);
    return choose(wish_vehicle);
}

void VelocityGuard::setActing(const VehicleMotion& motion, double now_s)
{
    std::array<Vector2d, CommandLog::kMaxActing> commands_odom;
    std::array<Vector2d, CommandLog::kMaxActing + 1> acting_vehicle;
    const std::size_t count = commands_.acting(now_s, commands_odom);
    for (std::size_t i = 0; i < count; ++i)
        acting_vehicle[i] = turned(commands_odom[i], -reckoning_.newest().yaw);
    acting_vehicle[count] = motion.velocity_vehicle;
    stopping_.setActing(acting_vehicle.data(), count + 1);
}

GuardDecision VelocityGuard::choose(const Vector2d& wish_vehicle)
{
    const double wished_mps = wish_vehicle.norm();
    const double limit_mps = usesMemory()
                                 ? vehicle_.max_speed_mps
                                 : std::min(vehicle_.max_speed_mps, options_.lost_speed_mps);
    GuardDecision decision;
    decision.reason = usesMemory() ? GuardReason::Free : GuardReason::Lost;
    if (wished_mps == 0)
    {
        guidance_.reset();
        return decision;
    }
    const Vector2d capped = wish_vehicle * std::min(1.0, limit_mps / wished_mps);
    const Way way = bestWay(capped);
    decision.velocity_vehicle = way.velocity_vehicle;
    decision.bend_rad = way.bend_rad;
    if (way.velocity_vehicle == wish_vehicle) return decision;
    nameLimit(capped, decision);
    if (way.is_unknown)
        decision.reason = GuardReason::NoData;
    else if (way.velocity_vehicle.isZero())
        decision.reason = GuardReason::Blocked;
    else if (usesMemory())
        decision.reason = way.bend_rad != 0 ? GuardReason::Guided : GuardReason::Slowed;
    return decision;
}

double VelocityGuard::rememberedKeep() const
{
    return vehicle_.clearance() + (usesMemory() ? options_.pose_sigmas * pose_sigma_m_ : 0);
}

/// Those that a way of this length may come too near to. An obstacle that may come nearer than it
/// should even if the vehicle stops at once must not come nearer than that; so stopping is always
/// allowed. It may also do better than that, and short of the obstacle: so no command leads on
/// towards it.
void VelocityGuard::gatherObstacles(double way_m)
{
    obstacles_.clear();
    const double keep_m = vehicle_.clearance();
    const double reach_m = way_m + rememberedKeep();
    const Pose2 pose_vehicle_picture = inverse(pose_picture_vehicle_);
    obstacles_.add(picture_.hits().view(), pose_vehicle_picture, keep_m, reach_m);
    if (options_.unknown != UnknownPolicy::Allow)
        obstacles_.add(picture_.horizon().view(), pose_vehicle_picture, keep_m, reach_m);
    if (usesMemory())
        obstacles_.add(
            memory_.points_map(), compose(pose_vehicle_picture, inverse(*pose_map_picture_)),
            rememberedKeep(), reach_m);
    uncleared_.clear();
    obstacles_.excuse(stopping_.of(Vector2d::Zero()), uncleared_);
}

bool VelocityGuard::isUnknown(double bearing_rad) const
{
    const double body_rad = std::asin(vehicle_.radius_m / (vehicle_.clearance() + kSeenAround_m));
    return picture_.isUnknown(bearing_rad + pose_picture_vehicle_.yaw, body_rad);
}

/// Whether no way that is to be compared with others may lead there.
bool VelocityGuard::isClosed(double bearing_rad) const
{
    if (options_.unknown == UnknownPolicy::Block && isUnknown(bearing_rad)) return true;
    return uncleared_.size() > 0 &&
           uncleared_.anyIsAhead({std::cos(bearing_rad), std::sin(bearing_rad)});
}

bool VelocityGuard::isSafe(const Vector2d& command) const
{
    return !at_risk_.anyIsIn(stopping_.of(command));
}

/// The wish on a bent way, with obstacles left aside.
VelocityGuard::Way VelocityGuard::asWished(const Vector2d& wish_vehicle, double bend_rad) const
{
    Way way;
    way.bend_rad = bend_rad;
    way.velocity_vehicle =
        bend_rad == 0 ? wish_vehicle : turned(wish_vehicle, bend_rad) * std::cos(bend_rad);
    if (options_.unknown == UnknownPolicy::Allow || !isUnknown(bearing_of(way.velocity_vehicle)))
        return way;
    way.is_unknown = true;
    const double unknown_mps =
        options_.unknown == UnknownPolicy::Creep ? options_.creep_speed_mps : 0;
    way.velocity_vehicle *= std::min(1.0, unknown_mps / way.velocity_vehicle.norm());
    return way;
}

/// Straight ahead, unless a bend brings the vehicle farther along the wish.
VelocityGuard::Way VelocityGuard::bestWay(const Vector2d& wish_vehicle)
{
    gatherObstacles(std::max(stopping_.reach(wish_vehicle.norm()), options_.lookahead_m));
    const Way straight = fastest(asWished(wish_vehicle, 0));
    if (straight.velocity_vehicle == wish_vehicle) return straight;
    const double bend_rad = guidance_.bend(
        obstacles_, bearing_of(wish_vehicle),
        [&](double bearing_rad) { return isClosed(bearing_rad); });
    if (bend_rad == 0) return straight;
    const Way bent = fastest(asWished(wish_vehicle, bend_rad));
    const auto progress = [&](const Way& way) { return way.velocity_vehicle.dot(wish_vehicle); };
    return progress(bent) > progress(straight) ? bent : straight;
}

/// The fastest safe velocity on a way, in whole steps of the wished speed's 128th part.
VelocityGuard::Way VelocityGuard::fastest(const Way& whole)
{
    Way way = whole;
    if (whole.velocity_vehicle.isZero()) return way;
    if (uncleared_.anyIsAhead(whole.velocity_vehicle))
    {
        way.velocity_vehicle.setZero();
        return way;
    }
    at_risk_.clear();
    at_risk_.addThoseIn(stopping_.ofUpTo(whole.velocity_vehicle), obstacles_);
    if (isSafe(whole.velocity_vehicle)) return way;
    double safe = 0, unsafe = 1;
    for (int i = 0; i < kHalvings; ++i)
    {
        const double middle = (safe + unsafe) / 2;
        (isSafe(middle * whole.velocity_vehicle) ? safe : unsafe) = middle;
    }
    way.velocity_vehicle *= safe;
    if (way.velocity_vehicle.norm() < kSlowest_mps) way.velocity_vehicle.setZero();
    return way;
}

/// The obstacle that forbids the wish; of several the nearest.
void VelocityGuard::nameLimit(const Vector2d& wish_vehicle, GuardDecision& decision) const
{
    double nearest_m = std::numeric_limits<double>::infinity();
    const auto take = [&](const Vector2d& place)
    {
        if (place.norm() >= nearest_m) return;
        nearest_m = decision.limiting_distance_m = place.norm();
        decision.limiting_bearing_rad = bearing_of(place);
    };
    obstacles_.forEachIn(
        stopping_.of(wish_vehicle),
        [&](std::size_t i) { return take(obstacles_.at(i).place_vehicle), true; });
    for (std::size_t i = 0; i < uncleared_.size(); ++i)
    {
        const Vector2d place = uncleared_.at(i).place_vehicle;
        if (place.dot(wish_vehicle) > 0) take(place);
    }
}
}  // namespace rtob

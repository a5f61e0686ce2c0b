// SPDX-License-Identifier: BSD-3-Clause
#include <mrpt/core/bits_math.h>
#include <rtob/core/option_checks.h>
#include <rtob/slam/anchor.h>
#include <rtob/slam/turned_points.h>

#include <algorithm>
#include <cmath>

namespace rtob
{
void AnchorOptions::validate() const
{
    require(min_path_m > 0, "min_path_m", min_path_m, "> 0");
    require(max_pair_distance_m > 0, "max_pair_distance_m", max_pair_distance_m, "> 0");
    require(
        min_paired_share > 0 && min_paired_share <= 1, "min_paired_share", min_paired_share,
        "in (0, 1]");
    require(error_slack_m2 >= 0, "error_slack_m2", error_slack_m2, ">= 0");
    require(small_step_m > 0, "small_step_m", small_step_m, "> 0");
    require(small_turn_deg > 0, "small_turn_deg", small_turn_deg, "> 0");
    require(min_points >= 10, "min_points", min_points, ">= 10");
}

namespace
{
// Old scans may explain this much less of a scan than all scans do: of a small correction, of a
// large one.
constexpr double kShareSlack = 0.75, kFarShareSlack = 0.97;

/// The way since the last hold may have gone astray by more than one step's guess can: nothing
/// resists.
IcpOptions unheld(IcpOptions options)
{
    options.weak_share = 0;
    return options;
}

IcpOptions with_pair_distance(IcpOptions options, double max_pair_distance_m)
{
    options.max_pair_distance_m = std::max(max_pair_distance_m, options.final_pair_distance_m);
    return options;
}
}  // namespace

Anchor::Anchor(
    const AnchorOptions& options, const IcpOptions& icp, const DensityOptions& density,
    const DrawOptions& draw, const ReferenceOptions& reference, std::uint64_t seed)
    : options_(options),
      icp_(unheld(icp)),
      wide_icp_(with_pair_distance(unheld(icp), options.max_pair_distance_m)),
      density_(density),
      draw_(draw),
      old_(reference),
      random_(seed)
{
    options_.validate();
}

std::optional<IcpResult> Anchor::align(
    const MapView& map, const TravelLog& travel, const Drift& drift, double time_s,
    const Pose2& pose_map_vehicle, const IcpResult& fit, const Points& points_vehicle)
{
    const std::size_t old_end = travel.scansBefore(options_.min_path_m);
    if (!options_.enabled || old_end == 0) return std::nullopt;
    const Box needed_map = turn_points(pose_map_vehicle, points_vehicle.view(), points_turned_)
                               .grown(options_.max_pair_distance_m);
    if (!old_.serves(time_s, pose_map_vehicle, needed_map))
        old_.renew(
            icp_, time_s, pose_map_vehicle, needed_map,
            [&](const Box& box_map, Reference& reference)
            {
                draw_.draw(
                    map, density_, {time_s, pose_map_vehicle.x, pose_map_vehicle.y, 0, old_end},
                    box_map, random_, reference);
            });
    if (old_.size() < static_cast<std::size_t>(options_.min_points)) return std::nullopt;
    // Near first: the far reach of the second try would blur a guess that is good already.
    const double drift_m = drift.expected_m(travel);
    IcpResult old_fit = old_.align(icp_, points_turned_.view(), pose_map_vehicle);
    if (!explains(old_fit, fit, drift_m, false))
    {
        if (drift_m < options_.small_step_m) return std::nullopt;
        old_fit = old_.align(wide_icp_, points_turned_.view(), pose_map_vehicle);
        if (!explains(old_fit, fit, drift_m, true)) return std::nullopt;
    }
    return old_fit;
}

/// What exceeds the drift to expect is a mistake. A small correction is welcome when the old scans
/// fit about as well as all scans do; a large one contradicts the fit against all scans, so it must
/// be the better one.
bool Anchor::explains(
    const IcpResult& old_fit, const IcpResult& fit, double drift_m, bool is_far) const
{
    const Pose2& by = old_fit.correction;
    const double step_m = std::hypot(by.x, by.y);
    if (step_m > options_.small_step_m + drift_m) return false;
    const bool is_large = is_far || step_m > options_.small_step_m ||
                          std::abs(by.yaw) > mrpt::DEG2RAD(options_.small_turn_deg);
    const double share_slack = is_large ? kFarShareSlack : kShareSlack;
    const double error_slack_m2 = is_large ? 0.0 : options_.error_slack_m2;
    return old_fit.paired_share >= options_.min_paired_share &&
           old_fit.paired_share >= share_slack * fit.paired_share &&
           old_fit.mean_squared_error <= fit.mean_squared_error + error_slack_m2;
}
}  // namespace rtob

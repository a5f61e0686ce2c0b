// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/core/icp.h>
#include <rtob/core/points.h>
#include <rtob/core/random.h>
#include <rtob/core/reference_draw.h>
#include <rtob/core/time_density.h>
#include <rtob/slam/drift.h>
#include <rtob/slam/local_reference.h>
#include <rtob/slam/travel_log.h>

#include <optional>

namespace rtob
{
struct AnchorOptions
{
    bool enabled = true;
    double min_path_m = 20;
    double max_pair_distance_m = 1.0;
    double min_paired_share = 0.7;
    double error_slack_m2 = 0.0005;
    double small_step_m = 0.3;
    double small_turn_deg = 2;
    int min_points = 500;

    template <class Self, class Visit>
    static void fields(Self& s, Visit&& visit)
    {
        visit("enabled", s.enabled, "in places seen before, let the old scans decide");
        visit(
            "min_path_m", s.min_path_m, "old is what was seen at least this much travel ago; > 0");
        visit(
            "max_pair_distance_m", s.max_pair_distance_m,
            "the second try's pair distance: loop errors up to about this are closed; > 0");
        visit(
            "min_paired_share", s.min_paired_share,
            "share of the scan that the old scans must explain; (0, 1]");
        visit(
            "error_slack_m2", s.error_slack_m2,
            "how much larger than against all scans the mean squared error may be, for a small "
            "correction; >= 0");
        visit(
            "small_step_m", s.small_step_m,
            "a larger correction must fit better than all scans do; > 0");
        visit("small_turn_deg", s.small_turn_deg, "the same for its turn; > 0");
        visit("min_points", s.min_points, "old points that must be near; >= 10");
    }
    void validate() const;
};

/// Lets old scans speak before new ones. After a loop the new scans around the vehicle have drifted
/// and the old ones have not, but the paper's draw mixes both (sec. 2.3.3). So the scan is aligned
/// a second time, against scans of this place from before the loop alone; where these explain it,
/// their answer holds.
class Anchor
{
 public:
    Anchor(
        const AnchorOptions& options, const IcpOptions& icp, const DensityOptions& density,
        const DrawOptions& draw, const ReferenceOptions& reference, std::uint64_t seed);

    /// @param fit of the scan against all scans, at `pose_map_vehicle`.
    /// @return the fit against old scans, its correction relative to `pose_map_vehicle`, or nothing
    /// where old scans do not explain the scan.
    [[nodiscard]] std::optional<IcpResult> align(
        const MapView& map, const TravelLog& travel, const Drift& drift, double time_s,
        const Pose2& pose_map_vehicle, const IcpResult& fit, const Points& points_vehicle);

    /// The map has changed: the next scan draws anew.
    void forgetMap() { old_.drop(); }

 private:
    [[nodiscard]] bool explains(
        const IcpResult& old_fit, const IcpResult& fit, double drift_m, bool is_far) const;

    AnchorOptions options_;
    Icp icp_, wide_icp_;
    TimeDensity density_;
    ReferenceDraw draw_;
    LocalReference old_;  ///< of scans from before the loop
    Random random_;
    Points points_turned_;
};
}  // namespace rtob

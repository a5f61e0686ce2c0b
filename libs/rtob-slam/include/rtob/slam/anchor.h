// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/core/icp.h>
#include <rtob/core/points.h>
#include <rtob/core/random.h>
#include <rtob/core/reference_draw.h>
#include <rtob/core/time_density.h>

#include <optional>
#include <vector>

namespace rtob
{
struct AnchorOptions
{
    bool enabled = true;
    double min_path_m = 20;
    double max_pair_distance_m = 1.0;
    double min_paired_share = 0.7;
    double error_slack_m2 = 0.001;
    int min_points = 500;

    template <class Self, class Visit>
    static void fields(Self& s, Visit&& visit)
    {
        visit("enabled", s.enabled, "in places seen before, let the old scans decide");
        visit(
            "min_path_m", s.min_path_m, "old is what was seen at least this much travel ago; > 0");
        visit(
            "max_pair_distance_m", s.max_pair_distance_m,
            "largest loop error that is closed; > 0, at least the icp's final_pair_distance_m");
        visit(
            "min_paired_share", s.min_paired_share,
            "share of the scan that the old scans must explain; (0, 1]");
        visit(
            "error_slack_m2", s.error_slack_m2,
            "how much larger the mean squared error may be than against all scans; >= 0");
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
        const DrawOptions& draw, std::uint64_t seed);

    /// To be called for each scan of the map, with its pose.
    void inserted(const Pose2& pose_map_vehicle);

    /// @param fit of the scan against all scans, at `pose_map_vehicle`.
    /// @return the fit against old scans, its correction relative to `pose_map_vehicle`, or nothing
    /// where old scans do not explain the scan.
    [[nodiscard]] std::optional<IcpResult> align(
        const MapView& map, double time_s, const Pose2& pose_map_vehicle, const IcpResult& fit,
        const Points& points_vehicle);

 private:
    AnchorOptions options_;
    Icp icp_;
    TimeDensity density_;
    ReferenceDraw draw_;
    Random random_;
    std::vector<float> path_m_;  ///< travelled until each scan of the map
    Pose2 last_pose_;
    std::size_t old_end_ = 0;  ///< one past the last scan that is old enough
    Points points_turned_;
    Reference reference_;
};
}  // namespace rtob

// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/core/icp.h>
#include <rtob/core/random.h>
#include <rtob/core/reference_draw.h>
#include <rtob/core/time_density.h>
#include <rtob/core/wide_search.h>
#include <rtob/slam/drift.h>
#include <rtob/slam/match_support.h>
#include <rtob/slam/travel_log.h>

#include <optional>

namespace rtob
{
struct LoopSearchOptions
{
    bool enabled = true;
    double max_half_width_m = 12;
    double min_path_m = 15;
    double step_m = 0.5;
    double local_path_m = 10;
    double vicinity_m = 20;
    int local_points = 400;
    double min_score = 0.6;
    double min_paired_share = 0.85;
    bool bend_way = true;

    template <class Self, class Visit>
    static void fields(Self& s, Visit&& visit)
    {
        visit(
            "enabled", s.enabled,
            "look for places seen before when the loop error may exceed the anchor's reach");
        visit(
            "max_half_width_m", s.max_half_width_m,
            "the drift that is looked for at most, in x and in y; > 0");
        visit("min_path_m", s.min_path_m, "path without an anchor before a search; > 0");
        visit("step_m", s.step_m, "travel between two searches; > 0");
        visit(
            "local_path_m", s.local_path_m,
            "the scans of this much travel are matched together; > 0");
        visit("vicinity_m", s.vicinity_m, "old scans within this are matched against; > 0");
        visit("local_points", s.local_points, "points drawn from the local scans; >= 100");
        visit(
            "min_score", s.min_score,
            "share of the local points that must fall on old ones after the search; (0, 1]");
        visit(
            "min_paired_share", s.min_paired_share,
            "the same after ICP, within its final pair distance; (0, 1]");
        visit(
            "bend_way", s.bend_way,
            "move the scans of the loop, each by its share of the error, so that its ends meet");
    }
    void validate() const;
};

/// A place that was found again.
struct LoopFound
{
    IcpResult fit;             ///< of the newest scans to old ones
    std::size_t old_scan = 0;  ///< the newest of the old scans that it rests on
};

/// Finds a place again after a loop whose error is larger than ICP's pairs reach: the known limit
/// of sec. 2.3.3. The error to expect grows with the path since a scan was last matched against old
/// scans. The scans of the last few metres together are searched for in a window that wide, over
/// the old scans near, and refined by ICP; two searches in a row must agree. Where the old scans
/// hold only one direction, as in a corridor, only that direction is corrected.
class LoopSearch
{
 public:
    LoopSearch(const LoopSearchOptions& options, const IcpOptions& icp, std::uint64_t seed);

    /// @return what was found, its correction relative to `pose_map_vehicle`, if it is time to
    /// search and two searches agreed.
    [[nodiscard]] std::optional<LoopFound> search(
        const MapView& map, const TravelLog& travel, const Drift& drift, double time_s,
        const Pose2& pose_map_vehicle, std::size_t old_end);

 private:
    [[nodiscard]] std::optional<IcpResult> find(double path_m, double drift_m);
    [[nodiscard]] bool agrees(const Pose2& correction) const;

    LoopSearchOptions options_;
    WideSearch search_;
    Icp icp_;
    TimeDensity density_;
    ReferenceDraw old_draw_, local_draw_;
    Random random_;
    Reference old_, local_;
    Points local_turned_, old_shifted_;
    MatchSupport support_;
    double searched_path_m_ = 0;
    std::optional<Pose2> last_correction_;
};
}  // namespace rtob

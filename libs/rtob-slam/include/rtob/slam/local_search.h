// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/core/reference_draw.h>
#include <rtob/core/wide_search.h>

#include <vector>

namespace rtob
{
struct SearchOptions
{
    bool enabled = true;
    double half_width_m = 1.0;
    double half_angle_deg = 30;
    double lost_half_width_m = 4.0;
    double lost_half_angle_deg = 180;
    int points = 120;
    double min_paired_share = 0.75;

    template <class Self, class Visit>
    static void fields(Self& s, Visit&& visit)
    {
        visit("enabled", s.enabled, "search a window when ICP alone finds no good match");
        visit("half_width_m", s.half_width_m, "the window around the guess, in x and in y; > 0");
        visit("half_angle_deg", s.half_angle_deg, "the window around the guess, in yaw; > 0");
        visit("lost_half_width_m", s.lost_half_width_m, "the same while LOST; > 0");
        visit("lost_half_angle_deg", s.lost_half_angle_deg, "the same while LOST; (0, 180]");
        visit(
            "min_paired_share", s.min_paired_share,
            "share of the scan that what was found must explain; (0, 1]");
        visit("points", s.points, "points of the scan that are looked at; >= 20");
    }
    void validate() const;
};

/// Looks for a scan in a window around its guess, for turns and jumps that ICP's pairs do not reach
/// (sec. 2.1.2: the guess must be within 30 cm and 5 degrees).
class LocalSearch
{
 public:
    explicit LocalSearch(const SearchOptions& options = {});

    /// @param points_turned the scan with map axes, seen from the guess.
    /// @param max_half_width_m how far off the guess may be at most, infinite where unknown.
    /// @return a better guess.
    [[nodiscard]] Pose2 search(
        const Pose2& pose_map_guess, const Points& points_turned, const Reference& reference,
        bool lost, double max_half_width_m);

    [[nodiscard]] bool enabled() const { return options_.enabled; }

 private:
    SearchOptions options_;
    WideSearch search_;
    Points thinned_;
};
}  // namespace rtob

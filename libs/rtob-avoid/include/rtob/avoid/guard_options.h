// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <string_view>
#include <utility>

namespace rtob
{
/// What to do where the laser says nothing.
enum class UnknownPolicy
{
    Block,  ///< not enter
    Creep,  ///< enter slowly
    Allow   ///< take it for free
};

constexpr auto enum_names(UnknownPolicy)
{
    return std::array<std::pair<UnknownPolicy, std::string_view>, 3>{
        {{UnknownPolicy::Block, "block"},
         {UnknownPolicy::Creep, "creep"},
         {UnknownPolicy::Allow, "allow"}}};
}

struct GuardOptions
{
    double guide_deg = 45;
    double lookahead_m = 2;
    UnknownPolicy unknown = UnknownPolicy::Block;
    double creep_speed_mps = 0.25;
    bool no_return_is_free = false;
    double max_hole_deg = 6;
    double max_scan_age_s = 0.5;
    double lost_speed_mps = 0.3;
    double memory_s = 20;
    double memory_range_m = 8;
    int memory_points = 2000;
    double seen_tolerance_m = 0.15;
    double pose_sigmas = 2;

    template <class Self, class Visit>
    static void fields(Self& s, Visit&& visit)
    {
        visit("guide_deg", s.guide_deg, "the wish is bent by this at most; 0: never; [0, 80]");
        visit("lookahead_m", s.lookahead_m, "free ways are compared up to here; > 0");
        visit("unknown", s.unknown, "where the laser says nothing");
        visit("creep_speed_mps", s.creep_speed_mps, "speed into the unknown with creep; > 0");
        visit(
            "no_return_is_free", s.no_return_is_free,
            "a beam without return (0, NaN) means that its whole range is free; else it means "
            "nothing");
        visit(
            "max_hole_deg", s.max_hole_deg,
            "beams without meaning between others are passed over up to this width; [0, 45]");
        visit("max_scan_age_s", s.max_scan_age_s, "stop when the newest scan is older; > 0");
        visit(
            "lost_speed_mps", s.lost_speed_mps,
            "no faster while the pose is lost and nothing remembered counts; > 0");
        visit("memory_s", s.memory_s, "what was not seen for so long is forgotten; >= 0");
        visit("memory_range_m", s.memory_range_m, "what is farther is forgotten; > 0");
        visit("memory_points", s.memory_points, "the newest so many are kept; [0, 20000]");
        visit(
            "seen_tolerance_m", s.seen_tolerance_m,
            "a remembered point is gone when beams pass it by this much; > 0");
        visit(
            "pose_sigmas", s.pose_sigmas,
            "what is remembered gets so many standard deviations of the pose more room; >= 0");
    }
    void validate() const;
};
}  // namespace rtob

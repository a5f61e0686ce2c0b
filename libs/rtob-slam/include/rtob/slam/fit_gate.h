// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/core/icp.h>

namespace rtob
{
struct FitGateOptions
{
    double max_mean_squared_error_m2 = 0.02;
    double min_paired_share = 0.5;
    double min_known_share = 0.75;
    int min_pairs = 20;

    template <class Self, class Visit>
    static void fields(Self& s, Visit&& visit)
    {
        visit(
            "max_mean_squared_error_m2", s.max_mean_squared_error_m2,
            "a worse fit does not count; > 0 [sec. 2.1.3]");
        visit(
            "min_paired_share", s.min_paired_share,
            "share of the scan's points that must find a neighbour for a plain match; (0, 1]");
        visit(
            "min_known_share", s.min_known_share,
            "the same among the points where the map knows something: lets new ground in; (0, 1]");
        visit("min_pairs", s.min_pairs, "pairs that any match must have; >= 3");
    }
    void validate() const;
};

enum class FitVerdict
{
    Good,       ///< the scan fits the map
    NewGround,  ///< what the map knows fits well, and the rest lies where nothing was seen
    Weak,       ///< too few pairs, or they fit badly
    None        ///< nothing to compare with
};

[[nodiscard]] inline bool is_match(FitVerdict verdict)
{
    return verdict == FitVerdict::Good || verdict == FitVerdict::NewGround;
}

/// Mean squared distance of the scan's points to their neighbours, where a point that found none
/// counts as one at `unpaired_m` [m^2].
[[nodiscard]] double misfit_m2(const IcpResult& fit, double unpaired_m);

/// Decides whether an aligned scan may change the map, sec. 2.1.3.
[[nodiscard]] FitVerdict judge_fit(const IcpResult& fit, const FitGateOptions& options);
}  // namespace rtob

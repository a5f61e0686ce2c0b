// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/core/option_checks.h>
#include <rtob/slam/fit_gate.h>

namespace rtob
{
void FitGateOptions::validate() const
{
    require(
        max_mean_squared_error_m2 > 0, "max_mean_squared_error_m2", max_mean_squared_error_m2,
        "> 0");
    require(
        min_paired_share > 0 && min_paired_share <= 1, "min_paired_share", min_paired_share,
        "in (0, 1]");
    require(
        min_known_share > 0 && min_known_share <= 1, "min_known_share", min_known_share,
        "in (0, 1]");
    require(min_pairs >= 3, "min_pairs", min_pairs, ">= 3");
}

double misfit_m2(const IcpResult& fit, double unpaired_m)
{
    return fit.paired_share * fit.mean_squared_error +
           (1 - fit.paired_share) * unpaired_m * unpaired_m;
}

FitVerdict judge_fit(const IcpResult& fit, const FitGateOptions& options)
{
    if (fit.pairs == 0) return FitVerdict::None;
    if (fit.pairs < static_cast<std::size_t>(options.min_pairs) ||
        fit.mean_squared_error > options.max_mean_squared_error_m2)
        return FitVerdict::Weak;
    if (fit.paired_share >= options.min_paired_share) return FitVerdict::Good;
    return fit.known_share >= options.min_known_share ? FitVerdict::NewGround : FitVerdict::Weak;
}
}  // namespace rtob

// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "tune/tune_plan.h"

namespace rtob
{
/// What a setting costs and how accurate it is.
struct TuneFigures
{
    double worst_m = 0, median_m = 0;  ///< RMS position error, over the seeds
    std::uint64_t lost_scans = 0;      ///< of all seeds
    double p50_ms = 0, p99_ms = 0;     ///< of a scan
};

struct TunePoint
{
    std::string value;
    TuneFigures figures;
};

struct TuneCurve
{
    Sweep sweep;
    std::string value_before;  ///< what the configuration had
    std::vector<TunePoint> points;
};

/// Whether a setting can be had: no scan lost, 99 % of the scans within the budget.
[[nodiscard]] bool is_feasible(const TuneFigures& figures, double budget_ms);

/// Whether one is less accurate than the other by more than 5 % and 0.5 mm.
[[nodiscard]] bool is_less_accurate(const TuneFigures& one, const TuneFigures& other);

/// Where more is better (points, iterations), the largest feasible value; for the rest the most
/// accurate feasible one, and the value as it was where that is as good within 5 % or 0.5 mm.
/// Empty: none is feasible.
[[nodiscard]] std::string chosen_value(const TuneCurve& curve, double budget_ms);
}  // namespace rtob

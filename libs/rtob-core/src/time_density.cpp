// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/core/gaussian_sum.h>
#include <rtob/core/option_checks.h>
#include <rtob/core/time_density.h>
#include <algorithm>
#include <cmath>

namespace rtob
{
void DensityOptions::validate() const
{
    require(interval_begin_s >= 0, "interval_begin_s", interval_begin_s, ">= 0");
    require(
        interval_end_s > interval_begin_s, "interval_end_s", interval_end_s, "> interval_begin_s");
    require(window_s > 0, "window_s", window_s, "> 0");
    require(forgetting_s >= 0, "forgetting_s", forgetting_s, ">= 0");
    require(
        density != Density::Forgetting || forgetting_s > 0, "forgetting_s", forgetting_s,
        "> 0 with density = forgetting");
    require(sigma_s > 0, "sigma_s", sigma_s, "> 0");
    require(laser_range_m > 0, "laser_range_m", laser_range_m, "> 0");
    require(vicinity_m >= 0, "vicinity_m", vicinity_m, ">= 0");
    require(gate_m >= 0, "gate_m", gate_m, ">= 0");
    require(min_age_s >= 0, "min_age_s", min_age_s, ">= 0");
}

TimeDensity::TimeDensity(const DensityOptions& options)
    : options_(options),
      vicinity_m_(
          options.vicinity_m > 0 ? options.vicinity_m : options.laser_range_m / std::sqrt(2)),
      forgetting_rate_(options.forgetting_s > 0 ? 1 / options.forgetting_s : 0)
{
    options_.validate();
    ranges_.reserve(2 * kMaxVisits);
    uncut_.reserve(4 * kMaxVisits);
}

void TimeDensity::support(
    const ScanTable& table, const VisitIndex& visits, const Moment& now,
    std::vector<Stretch>& stretches) const
{
    stretches.clear();
    if (table.empty()) return;
    const auto add = [&](std::size_t first, std::size_t end)
    {
        if (first < end) stretches.push_back({{first, end}, 1.0});
    };
    switch (options_.density)
    {
        case Density::Interval:
            add(table.firstScanSince(options_.interval_begin_s),
                table.forwardTo(
                    options_.interval_end_s, table.firstScanSince(options_.interval_end_s)));
            break;
        case Density::Window:
            add(table.backTo(now.time_s - options_.window_s, table.size()), table.size());
            break;
        case Density::Revisit:
            visitedScans(table, visits, now, stretches);
            break;
        case Density::Uniform:
        case Density::Forgetting:
            add(0, table.size());
            break;
    }
    if (options_.min_age_s > 0) dropNewest(table, now, stretches);
    if (forgetting_rate_ > 0) cutByAge(table, now, stretches);
}

double TimeDensity::weight(const ScanTable& table, const Moment& now, std::size_t scan) const
{
    double weight = options_.density == Density::Revisit ? gaussianSum(table, now, scan) : 1.0;
    if (forgetting_rate_ > 0)
        weight *= std::exp(-forgetting_rate_ * std::max(0.0, now.time_s - table.time(scan)));
    return weight;
}

void TimeDensity::visitedScans(
    const ScanTable& table, const VisitIndex& visits, const Moment& now,
    std::vector<Stretch>& stretches) const
{
    visits.query(Box::around(now.x, now.y, vicinity_m_), table, kMaxVisits, ranges_);
    // No sum of Gaussians exceeds the densest second's scans in every sigma of its reach.
    const double scans_per_sigma =
        static_cast<double>(table.densestSecond()) * std::ceil(options_.sigma_s);
    const double bound = scans_per_sigma * 3.51;  // 2 (1 + exp(-1/2) + exp(-4/2) + exp(-9/2) ...)
    const double reach_s = kGaussianReach * options_.sigma_s;
    for (const ScanRange& visit : ranges_)
    {
        std::size_t first = table.backTo(table.time(visit.first) - reach_s, visit.first);
        const std::size_t end = table.forwardTo(table.time(visit.end - 1) + reach_s, visit.end - 1);
        if (!stretches.empty() && first <= stretches.back().scans.end)
            stretches.back().scans.end = std::max(stretches.back().scans.end, end);
        else
            stretches.push_back({{first, end}, bound});
    }
}

void TimeDensity::dropNewest(
    const ScanTable& table, const Moment& now, std::vector<Stretch>& stretches) const
{
    const std::size_t end = table.backTo(now.time_s - options_.min_age_s, table.size());
    while (!stretches.empty() && stretches.back().scans.first >= end) stretches.pop_back();
    if (!stretches.empty()) stretches.back().scans.end = std::min(stretches.back().scans.end, end);
}

/// Cuts the stretches at ages of 0, 1/4, 2/4 ... of 1/lambda, so that each piece's bound is within
/// 22 % of all its weights, and drops what is too old to matter beside the newest.
void TimeDensity::cutByAge(
    const ScanTable& table, const Moment& now, std::vector<Stretch>& stretches) const
{
    if (stretches.empty()) return;
    constexpr double kSlice = 0.25;
    uncut_.swap(stretches);
    stretches.clear();
    const double newest_age_s = std::max(0.0, now.time_s - table.time(uncut_.back().scans.end - 1));
    double slice_age_s = newest_age_s;
    for (auto it = uncut_.rbegin(); it != uncut_.rend(); ++it)
    {
        std::size_t end = it->scans.end;
        while (end > it->scans.first &&
               slice_age_s <= newest_age_s + kForgettingReach / forgetting_rate_)
        {
            const double next_age_s = slice_age_s + kSlice / forgetting_rate_;
            const std::size_t first =
                std::max(it->scans.first, table.backTo(now.time_s - next_age_s, end));
            if (first < end)
                stretches.push_back(
                    {{first, end}, it->bound * std::exp(-forgetting_rate_ * slice_age_s)});
            end = first;
            if (end > it->scans.first) slice_age_s = next_age_s;
        }
    }
    std::reverse(stretches.begin(), stretches.end());
}

double TimeDensity::gaussianSum(const ScanTable& table, const Moment& now, std::size_t scan) const
{
    const double time_s = table.time(scan);
    const double reach_s = kGaussianReach * options_.sigma_s;
    const std::size_t first = table.backTo(time_s - reach_s, scan);
    const std::size_t end = table.forwardTo(time_s + reach_s, scan);
    return gaussian_sum(
        table, {first, end}, time_s, options_.sigma_s, Box::around(now.x, now.y, vicinity_m_));
}
}  // namespace rtob

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

void TimeDensity::findSupport(
    const ScanTable& table, const VisitIndex& visits, const Moment& now, Support& support) const
{
    auto& stretches = support.stretches;
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
    keepRange({now.scans_begin, now.scans_end}, stretches);
    if (stretches.empty()) return;
    support.newest_s = table.time(stretches.back().scans.end - 1);
    if (forgetting_rate_ > 0) cutByAge(table, support);
}

double TimeDensity::weight(
    const ScanTable& table, const Moment& now, const Support& support, std::size_t scan) const
{
    double weight = options_.density == Density::Revisit ? gaussianSum(table, now, scan) : 1.0;
    // Not from `now`: a constant factor less, which would underflow for a place left long ago.
    if (forgetting_rate_ > 0)
        weight *= std::exp(-forgetting_rate_ * (support.newest_s - table.time(scan)));
    return weight;
}

void TimeDensity::visitedScans(
    const ScanTable& table, const VisitIndex& visits, const Moment& now,
    std::vector<Stretch>& stretches) const
{
    visits.query(Box::around(now.x, now.y, vicinity_m_), table, kMaxVisits, ranges_);
    const double reach_s = kGaussianReach * options_.sigma_s;
    for (const ScanRange& visit : ranges_)
    {
        const std::size_t first = table.backTo(table.time(visit.first) - reach_s, visit.first);
        const std::size_t end = table.forwardTo(table.time(visit.end - 1) + reach_s, visit.end - 1);
        if (!stretches.empty() && first <= stretches.back().scans.end)
            stretches.back().scans.end = std::max(stretches.back().scans.end, end);
        else
            stretches.push_back({{first, end}, 1.0});
    }
    for (Stretch& s : stretches) s.bound = gaussianBound(table, s.scans);
}

/// No sum of Gaussians exceeds the densest second's scans in every sigma of its reach, nor the
/// scans that can be within its reach.
double TimeDensity::gaussianBound(const ScanTable& table, const ScanRange& scans) const
{
    const double scans_per_sigma =
        static_cast<double>(table.densestSecond()) * std::ceil(options_.sigma_s);
    constexpr double kSigmas = 3.51;  // 2 (1 + exp(-1/2) + exp(-4/2) + exp(-9/2))
    return std::min(kSigmas * scans_per_sigma, static_cast<double>(scans.end - scans.first));
}

void TimeDensity::keepRange(const ScanRange& range, std::vector<Stretch>& stretches)
{
    for (Stretch& stretch : stretches)
    {
        stretch.scans.first = std::max(stretch.scans.first, range.first);
        stretch.scans.end = std::min(stretch.scans.end, range.end);
    }
    const auto is_empty = [](const Stretch& s) { return s.scans.first >= s.scans.end; };
    stretches.erase(std::remove_if(stretches.begin(), stretches.end(), is_empty), stretches.end());
}

/// Cuts the stretches at 0, 1/4, 2/4 ... of 1/lambda before the newest scan, so that forgetting
/// varies by at most 22 % within a piece, and drops what is too old to matter.
void TimeDensity::cutByAge(const ScanTable& table, Support& support) const
{
    constexpr double kSlice = 0.25, kSlices = kForgettingReach / kSlice;
    uncut_.swap(support.stretches);
    support.stretches.clear();
    double slice = 0;
    for (auto it = uncut_.rbegin(); it != uncut_.rend(); ++it)
        for (std::size_t end = it->scans.end; end > it->scans.first && slice < kSlices;)
        {
            const double oldest_s = support.newest_s - (slice + 1) * kSlice / forgetting_rate_;
            const std::size_t first = std::max(it->scans.first, table.backTo(oldest_s, end));
            if (first < end)
                support.stretches.push_back({{first, end}, it->bound * std::exp(-slice * kSlice)});
            end = first;
            if (end > it->scans.first) ++slice;
        }
    std::reverse(support.stretches.begin(), support.stretches.end());
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

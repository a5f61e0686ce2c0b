// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/check/range_histogram.h>

#include <algorithm>
#include <bitset>
#include <cmath>

namespace rtob
{
namespace
{
constexpr double kBinsPerMetre = 100;
constexpr auto kBins = static_cast<std::size_t>(RangeHistogram::kEnd_m * kBinsPerMetre) + 1;
constexpr std::size_t kBandBins = 25;         // how far a sentinel's values spread
constexpr std::size_t kBelowBins = 250;       // and how much is empty below
constexpr double kSmallestShare = 1e-4;       // rarer values are strays, not a sentinel
constexpr std::uint64_t kSmallestCount = 20;  // the same for short logs
constexpr double kContrast = 20;              // times as dense as below
constexpr int kDirections = 6;                // a wall across a corridor is seen in fewer

std::size_t bin_of(double range_m)
{
    return std::min(kBins - 1, static_cast<std::size_t>(std::lround(range_m * kBinsPerMetre)));
}

double metres(std::size_t bin)
{
    return static_cast<double>(bin) / kBinsPerMetre;
}
}  // namespace

RangeHistogram::RangeHistogram() : bins_(kBins) {}

void RangeHistogram::add(float range_m, bool valid, unsigned direction)
{
    Bin& bin = bins_[bin_of(range_m)];
    ++bin.count;
    if (valid) ++bin.valid;
    bin.directions |= std::uint64_t{1} << direction;
}

RangeHistogram::Bin RangeHistogram::sum(std::size_t begin, std::size_t end) const
{
    Bin sum;
    for (std::size_t i = begin; i < end; ++i)
    {
        sum.count += bins_[i].count;
        sum.valid += bins_[i].valid;
        sum.directions |= bins_[i].directions;
    }
    return sum;
}

std::optional<std::size_t> RangeHistogram::lastUsedBelow(std::size_t end) const
{
    while (end > 0 && bins_[end - 1].count == 0) --end;
    if (end == 0) return std::nullopt;
    return end - 1;
}

std::optional<Sentinel> RangeHistogram::farSentinel(std::uint64_t beams) const
{
    const auto least = std::max(
        kSmallestCount, static_cast<std::uint64_t>(kSmallestShare * static_cast<double>(beams)));
    std::uint64_t strays = 0;
    for (auto top = lastUsedBelow(kBins); top && strays < least; top = lastUsedBelow(*top))
    {
        const std::size_t end = *top + 1, begin = end - std::min(end, kBandBins);
        if (sum(begin, end).count >= least) return sentinelIn(begin, end);
        strays += bins_[*top].count;
    }
    return std::nullopt;
}

std::optional<Sentinel> RangeHistogram::sentinelIn(std::size_t begin, std::size_t end) const
{
    const Bin band = sum(begin, end);
    const Bin below = sum(begin - std::min(begin, kBelowBins), begin);
    const double usual_below =
        static_cast<double>(below.count) * double(kBandBins) / double(kBelowBins);
    const bool stands_out = static_cast<double>(band.count) > kContrast * usual_below;
    const bool is_wide = std::bitset<64>(band.directions).count() >= kDirections;
    if (!stands_out || !is_wide) return std::nullopt;

    std::size_t low = begin, usual = begin;
    while (bins_[low].count == 0) ++low;
    for (std::size_t i = begin; i < end; ++i)
        if (bins_[i].count > bins_[usual].count) usual = i;
    const auto last_real = lastUsedBelow(begin);
    return Sentinel{metres(low), metres(end - 1), metres(usual),
                    band.count,  band.valid,      last_real ? metres(*last_real) : 0};
}

double RangeHistogram::quantile(double share, double limit_m) const
{
    const std::size_t end = bin_of(limit_m);
    const double rank = share * static_cast<double>(sum(0, end).count);
    std::uint64_t below = 0;
    for (std::size_t i = 0; i < end; ++i)
    {
        below += bins_[i].count;
        if (static_cast<double>(below) > rank) return metres(i);
    }
    return 0;
}
}  // namespace rtob

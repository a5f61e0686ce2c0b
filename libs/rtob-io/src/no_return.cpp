// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/io/no_return.h>

#include <algorithm>
#include <cmath>

#include "carmen_observations.h"

namespace rtob
{
namespace
{
constexpr double bin_m = 0.05;
constexpr double nearest_no_return_m = 3.0;
// SICK's codes for "nothing", "dazzled" and the like span 8 cm; Killian's floats 17 cm.
constexpr int cluster_bins = 5;
constexpr int gap_bins = 20;
constexpr double most_in_gap = 0.05;       // of the cluster's count; Killian: 0.002
constexpr double least_share = 0.001;      // of all beams; fhw: 0.007
constexpr double least_beam_share = 0.25;  // of the beam directions

int bin_of(float range_m)
{
    return static_cast<int>(std::floor(static_cast<double>(range_m) / bin_m));
}
}  // namespace

void NoReturnFinder::add(const mrpt::obs::CObservation2DRangeScan& scan)
{
    const std::size_t beams = scan.getScanSize();
    beams_ += beams;
    for (std::size_t i = 0; i < beams; ++i)
    {
        const float range_m = scan.getScanRange(i);
        if (!(range_m >= nearest_no_return_m && range_m < scan.maxRange)) continue;
        Bin& bin = bins_[bin_of(range_m)];
        bin.nearest_m = bin.count == 0 ? range_m : std::min(bin.nearest_m, range_m);
        ++bin.count;
        if (bin.seen_by_beam.size() < beams) bin.seen_by_beam.resize(beams);
        bin.seen_by_beam[i] = true;
    }
}

std::uint64_t NoReturnFinder::between(int first_bin, int end_bin) const
{
    std::uint64_t count = 0;
    const auto end = bins_.lower_bound(end_bin);
    for (auto bin = bins_.lower_bound(first_bin); bin != end; ++bin) count += bin->second.count;
    return count;
}

std::optional<NoReturn> NoReturnFinder::found() const
{
    if (bins_.empty()) return std::nullopt;
    const int last = bins_.rbegin()->first, first = last - cluster_bins + 1;
    std::vector<bool> seen_by_beam;
    NoReturn no_return;
    for (auto bin = bins_.lower_bound(first); bin != bins_.end(); ++bin)
    {
        const auto& seen = bin->second.seen_by_beam;
        if (seen_by_beam.size() < seen.size()) seen_by_beam.resize(seen.size());
        for (std::size_t i = 0; i < seen.size(); ++i)
            if (seen[i]) seen_by_beam[i] = true;
        if (no_return.beams == 0) no_return.from_m = bin->second.nearest_m;
        no_return.beams += bin->second.count;
    }
    const auto directions = std::count(seen_by_beam.begin(), seen_by_beam.end(), true);
    const auto cluster = static_cast<double>(no_return.beams);
    const bool is_one =
        cluster >= least_share * static_cast<double>(beams_) &&
        static_cast<double>(directions) >=
            least_beam_share * static_cast<double>(seen_by_beam.size()) &&
        static_cast<double>(between(first - gap_bins, first)) <= most_in_gap * cluster;
    if (!is_one) return std::nullopt;
    return no_return;
}

bool lacks_max_range(const mrpt::obs::CObservation2DRangeScan& scan)
{
    return scan.maxRange == max_range_when_untold_m;
}

mrpt::obs::CObservation2DRangeScan::Ptr with_max_range(
    const mrpt::obs::CObservation2DRangeScan& scan, float max_range_m)
{
    auto limited = mrpt::obs::CObservation2DRangeScan::Create(scan);
    limited->maxRange = max_range_m;
    for (std::size_t i = 0; i < limited->getScanSize(); ++i)
        if (limited->getScanRange(i) >= max_range_m) limited->setScanRangeValidity(i, false);
    return limited;
}
}  // namespace rtob

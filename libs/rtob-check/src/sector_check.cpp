// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/check/sector_check.h>

#include <algorithm>
#include <cmath>

#include "figures.h"

namespace rtob
{
namespace
{
constexpr double kWidth_deg = 10;
constexpr double kBlindShare = 0.95;  // of a sector's beams
constexpr double kSeeingShare = 0.6;  // some sector must see, or the laser as a whole does not
constexpr float kNearest_m = 0.02F;   // less is a code, not a range

int low_edge_deg(std::size_t sector)
{
    return static_cast<int>(sector) * static_cast<int>(kWidth_deg) - 180;
}

std::string range_text(std::size_t sector)
{
    const int low_deg = low_edge_deg(sector);
    return std::to_string(low_deg) + ".." + std::to_string(low_deg + static_cast<int>(kWidth_deg));
}
}  // namespace

void SectorCheck::add(const mrpt::obs::CObservation2DRangeScan& scan)
{
    for (std::size_t i = 0; i < scan.getScanSize(); ++i)
    {
        const double bearing_deg = scan.getScanAngle(i) * kRadToDeg;
        const double place = std::floor((bearing_deg + 180 + 1e-3) / kWidth_deg);
        const auto index = static_cast<std::size_t>(std::clamp(place, 0.0, kSectors - 1.0));
        const float range_m = scan.getScanRange(i);
        const bool is_return =
            scan.getScanRangeValidity(i) && range_m >= kNearest_m && range_m <= useful_range_m_;
        ++sectors_[index].beams;
        if (!is_return) ++sectors_[index].none;
    }
}

void SectorCheck::report(CheckReport& report) const
{
    std::string blind;
    double best = 1, worst = 0;
    std::size_t worst_sector = 0;
    Finding finding;
    finding.id = "sectors.blind";
    for (std::size_t k = 0; k < kSectors; ++k)
    {
        if (sectors_[k].beams == 0) continue;
        const double share = share_of(sectors_[k].none, sectors_[k].beams);
        finding.values.emplace_back(
            "none_share_from_" + std::to_string(low_edge_deg(k)) + "_deg", share);
        best = std::min(best, share);
        if (share >= worst) worst_sector = k;
        worst = std::max(worst, share);
        if (share > kBlindShare) blind += (blind.empty() ? "" : ", ") + range_text(k);
    }
    if (finding.values.empty()) return;
    finding.text = "no blind sector; most beams without a return, " + percent(worst) + ", are at " +
                   range_text(worst_sector) + " deg";
    if (!blind.empty() && best < kSeeingShare)
    {
        finding.severity = Severity::Warn;
        finding.text = "hardly a beam returns at " + blind + " deg in the laser's frame";
        finding.fix =
            "Something covers the laser there, or the driver cuts the field; what is "
            "flagged invalid does no harm";
    }
    report.findings.push_back(std::move(finding));
}
}  // namespace rtob

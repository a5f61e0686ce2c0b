// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/check/body_check.h>

#include <algorithm>
#include <cmath>

#include "figures.h"

namespace rtob
{
namespace
{
constexpr double kFarthestBody_m = 1.2, kBin_m = 0.03;
constexpr std::size_t kBins = 40;
constexpr double kNearest_m = 0.02;   // less is a code, not a range
constexpr double kAlwaysShare = 0.8;  // of the views
constexpr std::uint64_t kLeastViews = 20;
constexpr float kChanged_m = 0.1F;   // most beams differ by this: the vehicle has moved
constexpr std::size_t kBridged = 2;  // beams without a return inside a body's sector
}  // namespace

void BodyCheck::reset(const mrpt::obs::CObservation2DRangeScan& scan)
{
    beams_ = scan.getScanSize();
    const double last_deg = scan.getScanAngle(beams_ - 1) * kRadToDeg;
    first_bearing_deg_ = scan.getScanAngle(0) * kRadToDeg;
    step_deg_ = (last_deg - first_bearing_deg_) / static_cast<double>(beams_ - 1);
    views_ = 0;
    last_ranges_m_.clear();
    nearby_.assign(beams_ * kBins, 0);
}

bool BodyCheck::hasMoved(const mrpt::obs::CObservation2DRangeScan& scan) const
{
    if (last_ranges_m_.empty()) return true;
    std::size_t seen = 0, changed = 0;
    for (std::size_t i = 0; i < beams_; ++i)
    {
        const float now_m = scan.getScanRange(i), before_m = last_ranges_m_[i];
        if (!(now_m > kNearest_m && before_m > kNearest_m)) continue;
        ++seen;
        if (std::abs(now_m - before_m) > kChanged_m) ++changed;
    }
    return 2 * changed > seen;
}

void BodyCheck::add(const mrpt::obs::CObservation2DRangeScan& scan)
{
    if (scan.getScanSize() < 2) return;
    if (scan.getScanSize() != beams_) reset(scan);
    if (!hasMoved(scan)) return;
    ++views_;
    last_ranges_m_.resize(beams_);
    for (std::size_t i = 0; i < beams_; ++i)
    {
        const float range_m = scan.getScanRange(i);
        last_ranges_m_[i] = range_m;
        if (range_m > kNearest_m && range_m < kFarthestBody_m && scan.getScanRangeValidity(i))
            ++nearby_[i * kBins + static_cast<std::size_t>(range_m / kBin_m)];
    }
}

bool BodyCheck::seesBody(std::size_t beam) const
{
    if (views_ < kLeastViews) return false;
    const std::uint32_t* counts = &nearby_[beam * kBins];
    std::uint64_t most = 0;  // in two bins side by side, so that no edge divides a body
    for (std::size_t k = 0; k + 1 < kBins; ++k)
        most = std::max<std::uint64_t>(most, std::uint64_t{counts[k]} + counts[k + 1]);
    return static_cast<double>(most) >= kAlwaysShare * static_cast<double>(views_);
}

std::vector<BodyCheck::Sector> BodyCheck::sectors() const
{
    std::vector<Sector> sectors;
    std::size_t last = 0;
    for (std::size_t i = 0; i < beams_; ++i)
    {
        if (!seesBody(i)) continue;
        const double bearing_deg = first_bearing_deg_ + step_deg_ * static_cast<double>(i);
        if (sectors.empty() || i - last > kBridged + 1)
            sectors.push_back({bearing_deg, bearing_deg, 0});
        Sector& sector = sectors.back();
        sector.low_deg = std::min(sector.low_deg, bearing_deg);
        sector.high_deg = std::max(sector.high_deg, bearing_deg);
        ++sector.beams;
        last = i;
    }
    return sectors;
}

std::string BodyCheck::mask() const
{
    // A beam beside the body grazes it now and then: a step, and a little for rounding.
    const double margin_deg = 1.2 * std::abs(step_deg_);
    std::string mask;
    for (const auto& sector : sectors())
        mask += (mask.empty() ? "" : ", ") + fixed(sector.low_deg - margin_deg, 1) + ".." +
                fixed(sector.high_deg + margin_deg, 1);
    return mask;
}

void BodyCheck::report(CheckReport& report) const
{
    Finding finding;
    finding.id = "sectors.body";
    std::size_t beams = 0;
    for (const auto& sector : sectors()) beams += sector.beams;
    finding.values = {
        {"beams", static_cast<double>(beams)}, {"views", static_cast<double>(views_)}};
    if (views_ < kLeastViews)
        finding.text = "the view changes too little to tell whether beams see the vehicle itself";
    else if (beams == 0)
        finding.text = "no beam sees the vehicle itself";
    else
    {
        finding.severity = Severity::Fail;
        finding.text = counted(beams, "beam") +
                       " always see the same near thing, the vehicle "
                       "itself: bearings " +
                       mask() + " deg in the laser's frame";
        finding.fix = "They tell the matcher that nothing moves: mask them, see the suggested .ini";
        report.suggestions.push_back(
            {"ScanFilter", "mask_deg", mask(), "there the laser sees the vehicle itself"});
    }
    report.findings.push_back(std::move(finding));
}
}  // namespace rtob

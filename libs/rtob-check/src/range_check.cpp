// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/check/range_check.h>
#include <rtob/slam/scan_filter.h>

#include <algorithm>
#include <cmath>

#include "figures.h"

namespace rtob
{
namespace
{
constexpr float kNearestReal_m = 0.02F;  // no laser measures less: codes of errors
constexpr double kMostlyBlind = 0.5;
constexpr double kShortReach_m = 9;  // then the default draw reaches needlessly far
constexpr double kLeastDraw_m = 6;   // the paper's laser
}  // namespace

void RangeCheck::add(const mrpt::obs::CObservation2DRangeScan& scan)
{
    const std::size_t beams = scan.getScanSize();
    beams_ += beams;
    for (std::size_t i = 0; i < beams; ++i)
    {
        const float range_m = scan.getScanRange(i);
        const bool valid = scan.getScanRangeValidity(i);
        if (!valid) ++invalid_;
        if (!std::isfinite(range_m))
            ++not_a_number_;
        else if (range_m < 0)
            ++negative_;
        else if (range_m == 0)
        {
            ++zero_;
            if (valid) ++zero_valid_;
        }
        else if (range_m < kNearestReal_m)
        {
            if (codes_ == 0) smallest_code_m_ = range_m;
            smallest_code_m_ = std::min<double>(smallest_code_m_, range_m);
            largest_code_m_ = std::max<double>(largest_code_m_, range_m);
            ++codes_;
            if (valid) ++codes_valid_;
        }
        else if (range_m >= RangeHistogram::kEnd_m)
            ++beyond_;
        else
            histogram_.add(range_m, valid, static_cast<unsigned>(i * 64 / beams));
    }
}

std::optional<Sentinel> RangeCheck::farSentinel() const
{
    return histogram_.farSentinel(beams_);
}

double RangeCheck::usefulRange() const
{
    const double usual_m = ScanFilterOptions().max_range_m;
    const auto sentinel = farSentinel();
    if (!sentinel || sentinel->low_m > usual_m) return usual_m;
    // Half-way between what is real and what is not, but no farther below than a few percent.
    const double middle_m =
        std::max((sentinel->reach_m + sentinel->low_m) / 2, 0.97 * sentinel->low_m);
    return std::floor(100 * middle_m) / 100;
}

void RangeCheck::report(CheckReport& report) const
{
    if (beams_ == 0) return;
    reportFar(report);
    reportZero(report);
    reportCodes(report);
    reportShare(report);
    reportReach(report);
}

void RangeCheck::reportFar(CheckReport& report) const
{
    const auto sentinel = farSentinel();
    Finding finding;
    finding.id = "ranges.no_return";
    if (!sentinel)
    {
        finding.text = "no large value stands for \"no return\"";
        report.findings.push_back(std::move(finding));
        return;
    }
    finding.values = {
        {"usual_m", sentinel->usual_m},
        {"low_m", sentinel->low_m},
        {"high_m", sentinel->high_m},
        {"count", static_cast<double>(sentinel->count)},
        {"flagged_valid", static_cast<double>(sentinel->valid)},
        {"farthest_real_m", sentinel->reach_m}};
    const std::string band = sentinel->low_m == sentinel->high_m
                                 ? fixed(sentinel->usual_m, 2) + " m"
                                 : fixed(sentinel->low_m, 2) + " to " + fixed(sentinel->high_m, 2) +
                                       " m (mostly " + fixed(sentinel->usual_m, 2) + ")";
    finding.text = band + " occurs " + counted(sentinel->count, "time") + " (" +
                   percent(share_of(sentinel->count, beams_)) +
                   " of the beams), the next below is " + fixed(sentinel->reach_m, 2) +
                   " m: treat it as no return";
    const double default_m = ScanFilterOptions().max_range_m;
    if (sentinel->valid == 0)
        finding.text += "; the log flags it invalid";
    else if (sentinel->low_m > default_m)
    {
        finding.severity = Severity::Warn;
        finding.fix = "The log calls it valid. run's default [ScanFilter] max_range_m = " +
                      fixed(default_m, 0) +
                      " drops it; give other programs a maximum range below " +
                      fixed(sentinel->low_m, 2);
    }
    else
    {
        finding.severity = Severity::Fail;
        finding.fix =
            "The log calls it valid, and the default maximum range lets it in as walls: "
            "take [ScanFilter] max_range_m from the suggested .ini";
        report.suggestions.push_back(
            {"ScanFilter", "max_range_m", fixed(usefulRange(), 2),
             "below the " + fixed(sentinel->low_m, 2) + " m that stand for no return"});
    }
    report.findings.push_back(std::move(finding));
}

void RangeCheck::reportZero(CheckReport& report) const
{
    const std::uint64_t none = zero_ + not_a_number_ + negative_ + beyond_;
    if (none == 0) return;
    Finding finding;
    finding.id = "ranges.zero";
    finding.values = {
        {"zero", static_cast<double>(zero_)},
        {"zero_flagged_valid", static_cast<double>(zero_valid_)},
        {"not_a_number", static_cast<double>(not_a_number_)},
        {"negative", static_cast<double>(negative_)},
        {"beyond_655_m", static_cast<double>(beyond_)}};
    std::string kinds;
    const auto name = [&](std::uint64_t count, const std::string& what)
    {
        if (count == 0) return;
        kinds += (kinds.empty() ? "" : ", ") + what + " occurs " + counted(count, "time") + " (" +
                 percent(share_of(count, beams_)) + " of the beams)";
    };
    name(zero_, "0 m");
    name(not_a_number_, "NaN or infinite");
    name(negative_, "a negative range");
    name(beyond_, "more than 655 m");
    finding.text = kinds + ": treat it as no return";
    if (zero_valid_ > 0)
    {
        finding.severity = Severity::Warn;
        finding.fix =
            "The log calls zeros valid. run drops them; other programs may take them for "
            "obstacles at the laser itself";
    }
    report.findings.push_back(std::move(finding));
}

void RangeCheck::reportCodes(CheckReport& report) const
{
    if (codes_ == 0) return;
    Finding finding;
    finding.id = "ranges.codes";
    finding.values = {
        {"count", static_cast<double>(codes_)},
        {"smallest_m", smallest_code_m_},
        {"largest_m", largest_code_m_}};
    finding.text = fixed(smallest_code_m_, 3) + " to " + fixed(largest_code_m_, 3) + " m occurs " +
                   counted(codes_, "time") + " (" + percent(share_of(codes_, beams_)) +
                   " of the beams): codes of errors, not ranges";
    if (codes_valid_ > 0)
    {
        finding.severity = Severity::Warn;
        finding.fix = "The log calls them valid. run's default [ScanFilter] min_range_m = " +
                      fixed(ScanFilterOptions().min_range_m, 1) +
                      " drops them; give other programs such a minimum range";
    }
    report.findings.push_back(std::move(finding));
}

void RangeCheck::reportShare(CheckReport& report) const
{
    const auto sentinel = farSentinel();
    const std::uint64_t none =
        zero_ + not_a_number_ + negative_ + beyond_ + codes_ + (sentinel ? sentinel->count : 0);
    const double share = share_of(none, beams_);
    Finding finding;
    finding.id = "ranges.share";
    finding.values = {
        {"no_return_share", share}, {"flagged_invalid_share", share_of(invalid_, beams_)}};
    finding.text = percent(share) + " of the beams have no return";
    if (share > kMostlyBlind)
    {
        finding.severity = Severity::Warn;
        finding.fix = "Most of each scan is missing: too far, too dark or too dusty for this laser";
    }
    report.findings.push_back(std::move(finding));
}

void RangeCheck::reportReach(CheckReport& report) const
{
    const double limit_m = usefulRange();
    const double median_m = histogram_.quantile(0.5, limit_m);
    const double far_m = histogram_.quantile(0.99, limit_m);
    Finding finding;
    finding.id = "ranges.reach";
    finding.values = {{"median_m", median_m}, {"p99_m", far_m}};
    finding.text = "half of the ranges are below " + fixed(median_m, 2) + " m, 99 % below " +
                   fixed(far_m, 2) + " m";
    if (far_m == 0)
    {
        finding.severity = Severity::Fail;
        finding.text = "no beam has a range that means something";
        finding.fix = "Check the driver or the conversion: unit (metres) and validity";
    }
    else if (far_m < kShortReach_m)
        report.suggestions.push_back(
            {"Density", "laser_range_m", fixed(std::max(kLeastDraw_m, std::ceil(far_m)), 0),
             "99 % of the ranges are below: a draw from no farther is quicker"});
    report.findings.push_back(std::move(finding));
}
}  // namespace rtob

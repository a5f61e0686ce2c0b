// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/check/stamp_check.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "figures.h"

namespace rtob
{
namespace
{
constexpr double kShortest_s = 1e-5, kBinGrowth = 1.01;
constexpr std::size_t kBins = 2500;  // up to some days
constexpr double kJump_s = 60;       // further apart: the recording was not one
constexpr double kGap = 5;           // times the usual interval
constexpr double kSlow_hz = 1;
constexpr double kJittery = 0.5;  // of the median interval, between the 5th and the 95th percentile

std::size_t bin_of(double interval_s)
{
    if (interval_s <= kShortest_s) return 0;
    const double bin = std::log(interval_s / kShortest_s) / std::log(kBinGrowth);
    return std::min(kBins - 1, static_cast<std::size_t>(bin));
}

double middle_of(std::size_t bin)
{
    return kShortest_s * std::pow(kBinGrowth, static_cast<double>(bin) + 0.5);
}
}  // namespace

void StampCheck::add(double stamp_s)
{
    if (intervals_.empty()) intervals_.resize(kBins);
    ++stamps_;
    if (!std::isfinite(stamp_s))
    {
        ++invalid_;
        return;
    }
    const double step_s = stamp_s - last_s_;
    last_s_ = stamp_s;
    if (!std::exchange(started_, true)) return;
    if (step_s == 0)
        ++repeats_;
    else if (std::abs(step_s) > kJump_s)
    {
        ++jumps_;
        if (std::abs(step_s) > std::abs(largest_jump_s_)) largest_jump_s_ = step_s;
    }
    else if (step_s < 0)
    {
        elapsed_s_ += step_s;
        ++steps_back_;
        worst_back_s_ = std::max(worst_back_s_, -step_s);
    }
    else
    {
        elapsed_s_ += step_s;
        ++forward_;
        ++intervals_[bin_of(step_s)];
        if (step_s > largest_gap_s_)
        {
            largest_gap_s_ = step_s;
            largest_gap_at_s_ = stamp_s - step_s;
        }
    }
}

double StampCheck::usualInterval() const
{
    const auto steps = static_cast<double>(forward_ + steps_back_ + repeats_);
    return steps > 0 ? std::max(0.0, elapsed_s_ / steps) : 0;
}

double StampCheck::intervalAt(double share) const
{
    if (forward_ == 0) return 0;
    const auto rank = static_cast<std::uint64_t>(share * static_cast<double>(forward_ - 1));
    std::uint64_t below = 0;
    std::size_t bin = 0;
    while (bin + 1 < kBins && (below += intervals_[bin]) <= rank) ++bin;
    return middle_of(bin);
}

std::uint64_t StampCheck::intervalsAbove(double interval_s) const
{
    std::uint64_t count = 0;
    for (std::size_t bin = bin_of(interval_s); bin < kBins; ++bin) count += intervals_[bin];
    return count;
}

void StampCheck::report(CheckReport& report) const
{
    if (stamps_ == 0) return;
    reportOrder(report);
    if (forward_ == 0) return;
    reportRate(report);
    reportGaps(report);
}

void StampCheck::reportOrder(CheckReport& report) const
{
    Finding finding;
    finding.id = "stamps.order";
    finding.values = {{"steps_back", static_cast<double>(steps_back_)},
                      {"worst_back_s", worst_back_s_},
                      {"repeats", static_cast<double>(repeats_)},
                      {"invalid", static_cast<double>(invalid_)},
                      {"jumps", static_cast<double>(jumps_)},
                      {"largest_jump_s", largest_jump_s_}};
    std::string faults;
    const auto name = [&](std::uint64_t count, const std::string& what)
    {
        if (count > 0) faults += (faults.empty() ? "" : ", ") + what;
    };
    name(
        steps_back_,
        counted(steps_back_, "step") + " back (up to " + fixed(worst_back_s_, 3) + " s)");
    name(repeats_, counted(repeats_, "repeat"));
    name(invalid_, counted(invalid_, "scan") + " without a stamp");
    name(
        jumps_, counted(jumps_, "jump") + " of over a minute (largest " +
                    fixed(largest_jump_s_, 0) + " s)");
    if (stamps_ > 1 && forward_ == 0)
    {
        finding.severity = Severity::Fail;
        finding.text = "no stamp is later than the one before: " + faults;
        finding.fix =
            "The stamps are lost: convert the original log again (MRPT's carmen2rawlog "
            "gives all scans one stamp)";
    }
    else if (!faults.empty())
    {
        finding.severity = Severity::Warn;
        finding.text = faults;
        finding.fix = "Read the log in file order, as run does; never sort it by its stamps";
    }
    else
        finding.text = "every stamp is later than the one before";
    report.findings.push_back(std::move(finding));
}

void StampCheck::reportRate(CheckReport& report) const
{
    const double usual_s = usualInterval(), rate_hz = usual_s > 0 ? 1 / usual_s : 0;
    const double low_s = intervalAt(0.05), high_s = intervalAt(0.95);
    const double jitter = (high_s - low_s) / intervalAt(0.5);
    Finding finding;
    finding.id = "stamps.rate";
    finding.values = {
        {"rate_hz", rate_hz},
        {"interval_p5_s", low_s},
        {"interval_p95_s", high_s},
        {"jitter", jitter}};
    finding.text = fixed(rate_hz, rate_hz < 1 ? 2 : 1) +
                   " Hz on average, 90 % of the intervals between " + fixed(low_s, 3) + " and " +
                   fixed(high_s, 3) + " s";
    if (rate_hz < kSlow_hz)
    {
        finding.severity = Severity::Warn;
        finding.fix =
            "These are key scans or a slow recording: each scan is a step into the "
            "unknown. Log every scan of the laser where you can";
    }
    else if (jitter > kJittery)
    {
        finding.severity = Severity::Warn;
        finding.fix =
            "The stamps are those of a busy computer, or scans were lost: stamp scans "
            "when they are measured; do not derive speeds from single intervals";
    }
    report.findings.push_back(std::move(finding));
}

void StampCheck::reportGaps(CheckReport& report) const
{
    const double limit_s = kGap * std::max(usualInterval(), intervalAt(0.5));
    const auto gaps = intervalsAbove(limit_s);
    Finding finding;
    finding.id = "stamps.gaps";
    finding.values = {
        {"gaps", static_cast<double>(gaps)},
        {"largest_s", largest_gap_s_},
        {"largest_at_s", largest_gap_at_s_}};
    finding.text = "no gap of more than " + fixed(limit_s, 2) + " s (5 usual intervals)";
    if (gaps > 0)
    {
        finding.severity = Severity::Warn;
        finding.text = counted(gaps, "gap") + " of more than " + fixed(limit_s, 2) +
                       " s (5 usual intervals); the largest is " + fixed(largest_gap_s_, 2) +
                       " s, after " + fixed(largest_gap_at_s_, 3);
        finding.fix =
            "Look whether the vehicle moved meanwhile; there the odometry alone carries "
            "the pose";
    }
    report.findings.push_back(std::move(finding));
}
}  // namespace rtob

// SPDX-License-Identifier: BSD-3-Clause
#include "recovery/kidnap_trials.h"

#include <rtob/core/random.h>
#include <rtob/slam/map_file.h>

#include <algorithm>
#include <cmath>

namespace rtob
{
namespace
{
// A pose that is farther off is wrong.
constexpr double kWrong_m = 0.5, kWrong_rad = 0.2;
constexpr float kCover_m = 0.3F;
constexpr int kMostTries = 1000;  // to find a place far enough away

class Trial
{
 public:
    Trial(const DrivenLog& driven, const SlamOptions& options, const KidnapTrials& trials)
        : driven_(driven), options_(options), trials_(trials)
    {
    }

    KidnapTrial run(std::size_t from, std::size_t to)
    {
        trial_ = {};
        trial_.from = from;
        trial_.to = to;
        has_lost_ = has_found_ = false;
        Slam slam(options_);
        slam.continueIn(
            map_without(driven_.map, {spanFrom(from, trials_.scans_before), spanFrom(to, 40)}),
            driven_.scans[from].pose_map_vehicle);
        time_s_ = 1000;
        std::size_t next = from;
        for (int k = 0; k < trials_.scans_before; ++k) give(slam, next++, false);
        const std::uint32_t checksum = map_checksum(slam.map());
        int scan = 0;
        if (trials_.mishap == Mishap::Covered)
            for (int k = 0; k < trials_.scans_covered; ++k)
                watch(give(slam, next, true), nullptr, ++scan, 0);
        else
            next = to;
        for (int k = 0; k < trials_.scans_after && !has_found_; ++k)
        {
            const Pose2 truth = driven_.scans[next].pose_map_vehicle;
            if (has_lost_ && map_checksum(slam.map()) != checksum) trial_.map_unchanged = false;
            watch(give(slam, next++, false), &truth, ++scan, k + 1);
        }
        if (!has_lost_ && !trial_.was_followed() && map_checksum(slam.map()) != checksum)
            trial_.map_unchanged = false;
        return trial_;
    }

 private:
    [[nodiscard]] TimeSpan spanFrom(std::size_t scan, int count) const
    {
        const std::size_t last =
            std::min(scan + static_cast<std::size_t>(count), driven_.scans.size() - 1);
        return {
            driven_.scans[scan].map_time_s - trials_.left_out_s,
            driven_.scans[last].map_time_s + trials_.left_out_s};
    }

    const ScanReport& give(Slam& slam, std::size_t scan, bool is_covered)
    {
        auto copy = *driven_.scans[scan].scan;
        time_s_ += driven_.step_s;
        copy.timestamp = mrpt::Clock::fromDouble(time_s_);
        if (is_covered)
            for (std::size_t i = 0; i < copy.getScanSize(); ++i)
            {
                copy.setScanRange(i, kCover_m);
                copy.setScanRangeValidity(i, true);
            }
        return slam.process(copy);
    }

    /// @param truth null while covered @param scan_after the cover is gone, or of the jump
    void watch(const ScanReport& report, const Pose2* truth, int scan, int scan_after)
    {
        const bool is_lost =
            report.state == TrackingState::Lost || report.state == TrackingState::Relocalising;
        if (is_lost && !has_lost_)
        {
            has_lost_ = true;
            trial_.lost_after = scan;
        }
        if (report.state != TrackingState::Tracking) return;
        const bool is_right =
            truth == nullptr || is_near(report.pose_map_vehicle, *truth, kWrong_m, kWrong_rad);
        if (!is_right) ++trial_.tracking_wrong;
        if (!has_lost_ || truth == nullptr) return;
        has_found_ = true;
        trial_.found_after = scan_after;
        trial_.is_false_accept = !is_right;
    }

    const DrivenLog& driven_;
    const SlamOptions& options_;
    const KidnapTrials& trials_;
    KidnapTrial trial_;
    bool has_lost_ = false, has_found_ = false;
    double time_s_ = 0;
};

double distance_m(const DrivenLog& driven, std::size_t a, std::size_t b)
{
    const Pose2 way = between(driven.scans[a].pose_map_vehicle, driven.scans[b].pose_map_vehicle);
    return std::hypot(way.x, way.y);
}
}  // namespace

std::vector<KidnapTrial> kidnap_trials(
    const DrivenLog& driven, const SlamOptions& options, const KidnapTrials& trials)
{
    std::vector<KidnapTrial> done;
    const auto scans_needed = static_cast<std::size_t>(trials.scans_before + trials.scans_after);
    if (driven.scans.size() <= scans_needed) return done;
    Random random(trials.seed);
    const auto any_scan = [&]
    {
        return static_cast<std::size_t>(
            random.uniform() * static_cast<double>(driven.scans.size() - scans_needed));
    };
    Trial trial(driven, options, trials);
    for (std::uint64_t n = 0; n < trials.count; ++n)
    {
        const std::size_t from = any_scan();
        const std::size_t left = from + static_cast<std::size_t>(trials.scans_before) - 1;
        std::size_t to = any_scan();
        for (int tries = 0; trials.mishap == Mishap::Carried && tries < kMostTries &&
                            distance_m(driven, left, to) < trials.least_m;
             ++tries)
            to = any_scan();
        if (trials.mishap == Mishap::Covered) to = from;
        if (trials.mishap == Mishap::Carried && distance_m(driven, left, to) < trials.least_m)
            return done;  // the log stays in one place
        done.push_back(trial.run(from, to));
    }
    return done;
}
}  // namespace rtob

// SPDX-License-Identifier: BSD-3-Clause
#include "recovery/relocalise_trials.h"

#include <rtob/core/processor_time.h>
#include <rtob/core/random.h>
#include <rtob/slam/relocaliser.h>

#include <algorithm>
#include <cmath>

namespace rtob
{
namespace
{
constexpr double kDegPerRad = 57.29577951308232;

class Trial
{
 public:
    Trial(const DrivenLog& driven, const SlamOptions& options, const RelocaliseTrials& trials)
        : driven_(driven),
          trials_(trials),
          relocaliser_(options.relocalise, options.icp),
          sensor_(options.sensor),
          filter_(options.scan_filter),
          enough_points_(static_cast<std::size_t>(options.fit_gate.min_pairs))
    {
    }

    RelocaliseTrial run(std::size_t first)
    {
        RelocaliseTrial trial;
        trial.scan = first;
        const std::size_t last = first + static_cast<std::size_t>(trials_.most_scans) - 1;
        const RtobMap map = map_without(
            driven_.map, {{driven_.scans[first].map_time_s - trials_.left_out_s,
                           driven_.scans[last].map_time_s + trials_.left_out_s}});
        trial.map_ms = timed([&] { relocaliser_.learn(map.view()); });
        for (std::size_t k = first; k <= last && trial.outcome == Outcome::Nowhere; ++k)
            look(map, driven_.scans[k], trial);
        if (trial.outcome != Outcome::Right) explain(map, trial);
        return trial;
    }

 private:
    template <class Work>
    static double timed(const Work& work)
    {
        const double start_s = thread_processor_time_s();
        work();
        return 1e3 * (thread_processor_time_s() - start_s);
    }

    void look(const RtobMap& map, const DrivenScan& driven, RelocaliseTrial& trial)
    {
        ++trial.scans;
        (void)filter_.filter(*driven.scan, sensor_.mountOf(*driven.scan), points_vehicle_);
        if (points_vehicle_.size() < enough_points_) return;
        std::optional<PlaceEvidence> found;
        const double ms =
            timed([&] { found = relocaliser_.take(map.view(), points_vehicle_, std::nullopt); });
        trial.total_ms += ms;
        trial.worst_ms = std::max(trial.worst_ms, ms);
        if (!found) return;
        const Pose2 error = between(driven.pose_map_vehicle, found->pose_map_vehicle);
        trial.error_m = std::hypot(error.x, error.y);
        trial.error_deg = kDegPerRad * std::abs(error.yaw);
        const bool is_right =
            trial.error_m <= trials_.right_m && trial.error_deg <= trials_.right_deg;
        trial.outcome = is_right ? Outcome::Right : Outcome::Wrong;
    }

    void explain(const RtobMap& map, RelocaliseTrial& trial)
    {
        MapRaster raster;
        raster.draw(map.points(), map.scans());
        for (std::size_t k = trial.scan; k < trial.scan + static_cast<std::size_t>(trial.scans);
             ++k)
        {
            const DrivenScan& driven = driven_.scans[k];
            (void)filter_.filter(*driven.scan, sensor_.mountOf(*driven.scan), points_vehicle_);
            trial.explained_at_truth = std::min(
                trial.explained_at_truth,
                share_on_points(raster, points_vehicle_.view(), driven.pose_map_vehicle));
        }
    }

    const DrivenLog& driven_;
    const RelocaliseTrials& trials_;
    Relocaliser relocaliser_;
    SensorChoice sensor_;
    ScanFilter filter_;
    std::size_t enough_points_;
    Points points_vehicle_;
};
}  // namespace

std::vector<RelocaliseTrial> relocalise_trials(
    const DrivenLog& driven, const SlamOptions& options, const RelocaliseTrials& trials)
{
    std::vector<RelocaliseTrial> done;
    const auto scans = static_cast<std::size_t>(trials.most_scans);
    if (driven.scans.size() <= scans) return done;
    Random random(trials.seed);
    Trial trial(driven, options, trials);
    for (std::uint64_t n = 0; n < trials.count; ++n)
    {
        const auto starts = static_cast<double>(driven.scans.size() - scans);
        done.push_back(trial.run(static_cast<std::size_t>(random.uniform() * starts)));
    }
    return done;
}
}  // namespace rtob

// SPDX-License-Identifier: BSD-3-Clause
#include "recovery/driven_log.h"

#include <rtob/io/log_reader.h>
#include <rtob/slam/final_path.h>

#include <algorithm>
#include <stdexcept>

#include "run/offline_run.h"

namespace rtob
{
namespace
{
double usual_step(const std::vector<DrivenScan>& scans)
{
    std::vector<double> steps_s;
    for (std::size_t k = 1; k < scans.size(); ++k)
        steps_s.push_back(scans[k].map_time_s - scans[k - 1].map_time_s);
    if (steps_s.empty()) return 0.1;
    const auto middle = steps_s.begin() + static_cast<std::ptrdiff_t>(steps_s.size() / 2);
    std::nth_element(steps_s.begin(), middle, steps_s.end());
    return *middle > 0 ? *middle : 0.1;
}
}  // namespace

DrivenLog drive_log(const std::string& log, const SlamOptions& options, std::uint64_t first_scans)
{
    DrivenLog driven;
    Slam slam(options);
    FinalPath path;
    RunLimits limits;
    limits.first_scans = first_scans;
    const auto reader = open_log(log);
    const OfflineRun run = run_log(
        *reader, slam, limits,
        [&](const mrpt::obs::CObservation2DRangeScan& scan, const ScanReport& report)
        {
            if (report.state != TrackingState::Tracking) return;
            path.add(report);
            driven.scans.push_back(
                {mrpt::obs::CObservation2DRangeScan::Create(scan), report.map_time_s, {}});
        },
        [] { return false; });
    if (run.scans == 0) throw std::runtime_error(no_scans_message(log, run));
    driven.map = slam.map();
    const auto poses = path.in(driven.map.scans());
    for (std::size_t k = 0; k < poses.size(); ++k) driven.scans[k].pose_map_vehicle = poses[k].pose;
    driven.step_s = usual_step(driven.scans);
    return driven;
}

RtobMap map_without(const RtobMap& map, const std::vector<TimeSpan>& left_out)
{
    RtobMap rest(map);
    std::vector<char> keep;
    for (std::size_t k = 0; k < map.scans().size(); ++k)
        keep.push_back(std::none_of(
            left_out.begin(), left_out.end(),
            [time_s = map.scans().time(k)](const TimeSpan& span)
            { return time_s >= span.begin_s && time_s <= span.end_s; }));
    rest.keepOnly(keep);
    return rest;
}
}  // namespace rtob

// SPDX-License-Identifier: BSD-3-Clause
#include "run/run_counters.h"

#include <cmath>

namespace rtob
{
bool is_lost(TrackingState state)
{
    return state == TrackingState::Lost || state == TrackingState::Relocalising;
}

ScanFate fate_of(const ScanReport& report)
{
    if (report.beams.used == 0) return ScanFate::NoUsableBeam;
    switch (report.verdict)
    {
        case FitVerdict::Good:
            return report.pairs > 0 ? ScanFate::Matched : ScanFate::Started;
        case FitVerdict::NewGround:
            return ScanFate::NewGround;
        case FitVerdict::Weak:
            return ScanFate::WeakMatch;
        case FitVerdict::None:
            break;
    }
    return ScanFate::NoPair;
}

void RunCounters::add(const ScanReport& report)
{
    ++fates_[static_cast<std::size_t>(fate_of(report))];
    ++states_[static_cast<std::size_t>(report.state)];
    inserted_ += report.inserted;
    anchored_ += report.anchored;
    searched_ += report.searched;
    held_by_guess_ += report.held_by_guess;
    beams_ += report.beams;
    log_time_s_ = report.map_time_s;
    scan_ms_.push_back(static_cast<float>(1e3 * report.times.total()));

    const Pose2& pose = report.pose_map_vehicle;
    if (pose_map_last_)
        path_m_ += std::hypot(pose.x - pose_map_last_->x, pose.y - pose_map_last_->y);
    pose_map_last_ = pose;

    times_lost_ += is_lost(report.state) && !was_lost_;
    was_lost_ = is_lost(report.state);
}

std::uint64_t RunCounters::rejected() const
{
    return with(ScanFate::NoUsableBeam) + with(ScanFate::WeakMatch) + with(ScanFate::NoPair);
}

std::uint64_t RunCounters::lost() const
{
    return in(TrackingState::Lost) + in(TrackingState::Relocalising);
}
}  // namespace rtob

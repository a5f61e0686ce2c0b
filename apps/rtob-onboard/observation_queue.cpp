// SPDX-License-Identifier: BSD-3-Clause
#include "observation_queue.h"

#include <mrpt/obs/CObservation2DRangeScan.h>

#include <algorithm>

namespace rtob
{
namespace
{
bool is_scan(const mrpt::obs::CObservation& observation)
{
    return dynamic_cast<const mrpt::obs::CObservation2DRangeScan*>(&observation) != nullptr;
}

bool waits_to_be_used(const QueuedObservation& item)
{
    return !item.is_dropped && is_scan(*item.observation);
}
}  // namespace

ObservationQueue::ObservationQueue(
    std::size_t max_scans, std::size_t max_observations, SideExit side_exit)
    : max_scans_(max_scans), max_observations_(max_observations), side_exit_(std::move(side_exit))
{
}

void ObservationQueue::push(mrpt::obs::CObservation::Ptr observation)
{
    const std::lock_guard lock(mutex_);
    scans_waiting_ += is_scan(*observation);
    waiting_.push_back({std::move(observation), false});
    if (scans_waiting_ > max_scans_) dropOldestScan();
    if (waiting_.size() > max_observations_)
    {
        QueuedObservation& oldest = waiting_.front();
        if (waits_to_be_used(oldest)) dropOldestScan();
        oldest.is_dropped = true;
        side_exit_(oldest);
        waiting_.pop_front();
    }
    something_.notify_one();
}

void ObservationQueue::dropOldestScan()
{
    const auto oldest = std::find_if(waiting_.begin(), waiting_.end(), waits_to_be_used);
    oldest->is_dropped = true;
    --scans_waiting_;
    ++dropped_scans_;
}

std::optional<QueuedObservation> ObservationQueue::pop(std::chrono::milliseconds timeout)
{
    std::unique_lock lock(mutex_);
    if (!something_.wait_for(lock, timeout, [this] { return !waiting_.empty(); }))
        return std::nullopt;
    QueuedObservation item = std::move(waiting_.front());
    waiting_.pop_front();
    scans_waiting_ -= waits_to_be_used(item);
    return item;
}

std::uint64_t ObservationQueue::droppedScans() const
{
    const std::lock_guard lock(mutex_);
    return dropped_scans_;
}
}  // namespace rtob

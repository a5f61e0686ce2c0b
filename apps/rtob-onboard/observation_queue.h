// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <mrpt/obs/CObservation.h>

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <functional>
#include <mutex>
#include <optional>

namespace rtob
{
/// An observation on its way to the localisation.
struct QueuedObservation
{
    mrpt::obs::CObservation::Ptr observation;
    bool is_dropped = false;  ///< too old: only to be captured
};

/// Brings the observations of all sensors to one reader, in order of arrival. When the reader is
/// slow, the oldest scan that waits is dropped: it stays in its place, marked. When the reader
/// hangs, the oldest observations leave the queue by the side.
class ObservationQueue
{
 public:
    /// Takes what leaves by the side, marked as dropped; called by the thread that pushes.
    using SideExit = std::function<void(const QueuedObservation&)>;

    ObservationQueue(std::size_t max_scans, std::size_t max_observations, SideExit side_exit);

    void push(mrpt::obs::CObservation::Ptr observation);
    /// The next one; nothing after the timeout.
    [[nodiscard]] std::optional<QueuedObservation> pop(std::chrono::milliseconds timeout);

    [[nodiscard]] std::uint64_t droppedScans() const;

 private:
    void dropOldestScan();

    std::size_t max_scans_, max_observations_;
    SideExit side_exit_;
    mutable std::mutex mutex_;
    std::condition_variable something_;
    std::deque<QueuedObservation> waiting_;
    std::size_t scans_waiting_ = 0;  ///< that are not dropped
    std::uint64_t dropped_scans_ = 0;
};
}  // namespace rtob

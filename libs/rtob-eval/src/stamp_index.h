// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/core/pose2.h>

#include <cstddef>
#include <string>
#include <vector>

namespace rtob
{
/// "12.345678 s"
[[nodiscard]] std::string stamp_text(double time_s);

/// The poses of a trajectory by stamp; those that share a stamp stay in their order. Refers to the
/// trajectory, whose stamps must be finite.
class StampIndex
{
 public:
    explicit StampIndex(const std::vector<StampedPose2>& trajectory);

    /// The place, in order of stamps, of the first pose with the stamp nearest to `time_s`; the
    /// earlier of two. There must be a pose.
    [[nodiscard]] std::size_t nearestPlace(double time_s) const;

    [[nodiscard]] std::size_t size() const { return order_.size(); }
    /// The index in the trajectory of the pose at this place.
    [[nodiscard]] std::size_t pose(std::size_t place) const { return order_[place]; }
    [[nodiscard]] double stampAt(std::size_t place) const { return stamp(order_[place]); }
    /// "3 poses from 1.000000 s to 3.000000 s"
    [[nodiscard]] std::string range() const;

 private:
    [[nodiscard]] double stamp(std::size_t pose) const { return (*trajectory_)[pose].time_s; }
    [[nodiscard]] std::size_t firstPlaceFrom(double time_s) const;

    const std::vector<StampedPose2>* trajectory_;
    std::vector<std::size_t> order_;
};
}  // namespace rtob

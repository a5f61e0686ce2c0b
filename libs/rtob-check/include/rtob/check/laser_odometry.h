// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/core/icp.h>
#include <rtob/core/wide_search.h>

#include <deque>
#include <optional>

namespace rtob
{
/// A scan's motion since the scan before, as the laser saw it.
struct LaserStep
{
    Pose2 pose_prev_now;
    bool is_measured = false;     ///< the scan fits the last ones; otherwise the motion is a guess
    bool holds_position = false;  ///< no direction is left open, as it is along a corridor
    double paired_share = 0;      ///< [0, 1]
};

/// The laser's own odometry: each scan against the last few key scans. Drifts slowly, closes no
/// loops, needs no odometry of the vehicle and remembers a few metres only: a witness against the
/// vehicle's odometry, not a map.
class LaserOdometry
{
 public:
    LaserOdometry();

    /// @param points_vehicle of the scan
    /// @param odometry_step the vehicle's own opinion: tried, too, where the laser's motion leaps
    [[nodiscard]] LaserStep add(
        const Points& points_vehicle, const std::optional<Pose2>& odometry_step);

 private:
    struct KeyScan
    {
        Pose2 pose_local_vehicle;
        Points points_local;
    };
    struct Match
    {
        Pose2 pose_local_vehicle;
        IcpResult fit;
    };
    [[nodiscard]] Match matchBest(
        const Points& points_vehicle, const std::optional<Pose2>& odometry_step);
    [[nodiscard]] Match matchFrom(const Points& points_vehicle, const Pose2& pose_local_guess);
    [[nodiscard]] Match search(const Points& points_vehicle);
    void prepare(const Points& points_vehicle, const Pose2& pose_local_guess);
    void keep(const Points& points_vehicle);
    void restart(const Points& points_vehicle);

    Icp icp_;
    WideSearch search_;
    std::deque<KeyScan> key_scans_;  ///< the latest last
    Pose2 pose_local_vehicle_;
    Pose2 last_step_;
    Points turned_, reference_;  ///< with local axes, seen from the guess
};
}  // namespace rtob

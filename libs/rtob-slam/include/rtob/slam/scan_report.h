// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/core/icp.h>
#include <rtob/core/pose2.h>
#include <rtob/slam/scan_filter.h>
#include <rtob/slam/tracking.h>
#include <Eigen/Core>

namespace rtob
{
/// Where a scan's time went [s].
struct StepTimes
{
    double filter_s = 0, prealign_s = 0, draw_s = 0, align_s = 0, anchor_s = 0, search_s = 0,
           insert_s = 0;

    [[nodiscard]] double total() const
    {
        return filter_s + prealign_s + draw_s + align_s + anchor_s + search_s + insert_s;
    }
};

/// What became of one scan.
struct ScanReport
{
    double stamp_s = 0;      ///< the log's own
    double map_time_s = 0;   ///< MapClock
    Pose2 pose_map_vehicle;  ///< measured, or predicted while not TRACKING
    /// Of x, y, yaw relative to the local map: what an autopilot wants to know; m^2, rad^2.
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
    /// The same relative to the beginning of the map, or to the old scans that last held the pose.
    Eigen::Matrix3d covariance_in_map = Eigen::Matrix3d::Zero();
    WeakDirection weak;  ///< of the match, in map
    bool held_by_guess =
        false;  ///< along that direction: the pairs say too little [Icp.weak_share]
    TrackingState state = TrackingState::Init;
    FitVerdict verdict = FitVerdict::None;
    double mean_squared_error_m2 = 0;
    double paired_share = 0;  ///< [0, 1] of the points used
    std::size_t pairs = 0;
    bool doubted = false;  ///< perhaps carried away: what is written may be taken back
    bool inserted = false;
    bool anchored = false;     ///< matched against old scans of this place
    bool searched = false;     ///< ICP alone did not do: a window was searched
    bool closed_loop = false;  ///< put right by a loop search
    BeamCounts beams;
    StepTimes times;
};
}  // namespace rtob

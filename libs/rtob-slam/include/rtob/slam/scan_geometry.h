// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/poses/CPose3D.h>
#include <rtob/fusion/motion_state.h>
#include <rtob/slam/motion_readings.h>

#include <limits>
#include <optional>

namespace rtob
{
struct ScanGeometryOptions
{
    bool deskew = true;
    double sweep_s = 0;
    double stamp_at = 0.5;
    bool level = true;
    double floor_margin_m = 0.15;
    double ceiling_height_m = 0;

    template <class Self, class Visit>
    static void fields(Self& s, Visit&& visit)
    {
        visit(
            "deskew", s.deskew,
            "undo the vehicle's motion during the sweep, where its duration is known");
        visit(
            "sweep_s", s.sweep_s,
            "how long the beams of a scan take; 0: as the log tells, and nothing where it does "
            "not");
        visit(
            "stamp_at", s.stamp_at,
            "with sweep_s: what the stamp tells, as a share of the sweep; 0 first beam, 1 last");
        visit("level", s.level, "lay scans into the plane by roll and pitch, where they are known");
        visit(
            "floor_margin_m", s.floor_margin_m,
            "of tilted scans, hits that end lower above the floor are dropped; needs a height; >= "
            "0");
        visit(
            "ceiling_height_m", s.ceiling_height_m,
            "above the floor: the same for hits up there, less the margin; 0: not known");
    }
    void validate() const;
};

/// When the beams of a scan were taken, as seen from the instant that its pose is for.
struct SweepTiming
{
    double pose_after_stamp_s = 0;  ///< the instant of the pose: the middle of the sweep
    double sweep_s = 0;             ///< 0: not known, or all beams at once
};

/// By the log's record, or by the options where they give a duration.
[[nodiscard]] SweepTiming sweep_timing(
    std::optional<double> recorded_sweep_s, const ScanGeometryOptions& options);

/// How the beams of one scan become points in the plane.
struct ScanGeometry
{
    mrpt::poses::CPose3D pose_level_laser;  ///< as seen from the vehicle, were it level
    /// Hits outside are no walls [m]; z as seen from the vehicle, up.
    double lowest_m = -std::numeric_limits<double>::infinity();
    double highest_m = std::numeric_limits<double>::infinity();
    Twist2 twist{};  ///< of the vehicle during the sweep
    double sweep_s = 0;

    /// Whether the vehicle moved by so much that beams have to be moved one by one.
    [[nodiscard]] bool isSkewed() const;
};

/// @param tilt, height_m nothing where they are not known
[[nodiscard]] ScanGeometry scan_geometry(
    const mrpt::poses::CPose3D& pose_vehicle_laser, std::optional<Tilt> tilt,
    std::optional<double> height_m, const SweepTiming& timing, const Twist2& twist,
    const ScanGeometryOptions& options);
}  // namespace rtob

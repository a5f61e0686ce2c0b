// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <rtob/core/points.h>
#include <rtob/map/angle_mask.h>
#include <rtob/slam/scan_geometry.h>

#include <cstdint>
#include <string>
#include <vector>

namespace rtob
{
struct ScanFilterOptions
{
    double min_range_m = 0.1;
    double max_range_m = 40;
    std::string mask_deg;
    int max_beams = 720;
    int max_matched = 400;

    template <class Self, class Visit>
    static void fields(Self& s, Visit&& visit)
    {
        visit("min_range_m", s.min_range_m, "d_min: nearer beams are dropped; >= 0 [eq. 1]");
        visit(
            "max_range_m", s.max_range_m,
            "d_max: farther beams are dropped, and with them most \"no return\" values; > "
            "min_range_m [eq. 1]");
        visit(
            "mask_deg", s.mask_deg,
            "bearings in the laser's frame that see the vehicle itself, e.g. \"170..190, -10..5\"");
        visit(
            "max_beams", s.max_beams,
            "scans with more beams are thinned evenly to at most this many; >= 10");
        visit(
            "max_matched", s.max_matched,
            "points of a scan that are matched at most, evenly along what it sees; all of them "
            "enter the map; >= 10");
    }
    void validate() const;
};

/// Where the beams of scans went.
struct BeamCounts
{
    std::uint64_t used = 0, invalid = 0, not_a_number = 0, not_positive = 0, too_near = 0,
                  too_far = 0, masked = 0, thinned = 0, floor_or_ceiling = 0;
    BeamCounts& operator+=(const BeamCounts& other);
};

/// Eq. 1: keeps the beams with d in [d_min, d_max] that mean something, as points in the vehicle
/// frame. Each other beam is counted under the first reason that applies.
class ScanFilter
{
 public:
    explicit ScanFilter(const ScanFilterOptions& options = {});

    BeamCounts filter(
        const mrpt::obs::CObservation2DRangeScan& scan, const ScanGeometry& geometry,
        Points& points_vehicle);
    /// Of a vehicle that is level and stands still.
    BeamCounts filter(
        const mrpt::obs::CObservation2DRangeScan& scan,
        const mrpt::poses::CPose3D& pose_vehicle_laser, Points& points_vehicle)
    {
        return filter(scan, ScanGeometry{pose_vehicle_laser}, points_vehicle);
    }

 private:
    struct Direction
    {
        float cos = 1, sin = 0;
        bool masked = false;
    };
    void lookUpDirections(const mrpt::obs::CObservation2DRangeScan& scan);
    void lookUpMotion(const ScanGeometry& geometry, std::size_t beams);

    ScanFilterOptions options_;
    AngleMask mask_;
    std::vector<Direction> directions_;  ///< of the last kind of scan seen
    float aperture_rad_ = -1;
    bool right_to_left_ = true;
    std::vector<Pose2> motion_;  ///< of the vehicle, from the pose's instant to each beam's
};
}  // namespace rtob

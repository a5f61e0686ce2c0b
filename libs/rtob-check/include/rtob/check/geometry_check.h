// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <rtob/check/check_report.h>

#include <cstdint>
#include <optional>
#include <vector>

namespace rtob
{
/// What a laser's scans say about the laser: beams, field of view, direction, mount; and whether it
/// stays so. Also scans that repeat the one before.
class GeometryCheck
{
 public:
    void add(const mrpt::obs::CObservation2DRangeScan& scan);
    void report(CheckReport& report) const;

 private:
    struct Geometry
    {
        std::size_t beams = 0;
        double aperture_rad = 0;
        bool right_to_left = true;
        double mount_x_m = 0, mount_y_m = 0, mount_z_m = 0;
        double yaw_rad = 0, pitch_rad = 0, roll_rad = 0;  ///< of the middle of the field

        [[nodiscard]] bool operator==(const Geometry& other) const;
    };
    void reportBeams(CheckReport& report) const;
    void reportDirection(CheckReport& report) const;
    void reportMount(CheckReport& report) const;
    void reportRepeats(CheckReport& report) const;

    std::uint64_t scans_ = 0, changed_ = 0, without_beams_ = 0, repeated_ = 0;
    std::optional<Geometry> first_;
    std::vector<float> last_ranges_m_;
};
}  // namespace rtob

// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/poses/CPose3D.h>

#include <string>
#include <vector>

namespace rtob
{
struct SensorOptions
{
    std::string labels;
    bool override_mount = false;
    double mount_x_m = 0;
    double mount_y_m = 0;
    double mount_yaw_deg = 0;
    bool upside_down = false;

    template <class Self, class Visit>
    static void fields(Self& s, Visit&& visit)
    {
        visit(
            "labels", s.labels,
            "labels of the lasers to use, with commas between; empty: every laser of the log");
        visit(
            "override_mount", s.override_mount,
            "take the laser's mount from the keys below; the log's turn of the beams stays");
        visit("mount_x_m", s.mount_x_m, "the laser seen from the vehicle: ahead of its origin");
        visit("mount_y_m", s.mount_y_m, "the laser seen from the vehicle: left of its origin");
        visit(
            "mount_yaw_deg", s.mount_yaw_deg,
            "the laser's turn against the vehicle, added to the log's");
        visit("upside_down", s.upside_down, "the laser hangs: its left is the vehicle's right");
    }
    void validate() const;
};

/// Which scans are used, and where on the vehicle their laser sits.
class SensorChoice
{
 public:
    explicit SensorChoice(const SensorOptions& options = {});

    [[nodiscard]] bool uses(const mrpt::obs::CObservation& observation) const;
    [[nodiscard]] mrpt::poses::CPose3D mountOf(
        const mrpt::obs::CObservation2DRangeScan& scan) const;

 private:
    SensorOptions options_;
    std::vector<std::string> labels_;
    mrpt::poses::CPose3D mount_;
};
}  // namespace rtob

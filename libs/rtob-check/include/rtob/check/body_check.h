// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <rtob/check/check_report.h>

#include <cstdint>
#include <string>
#include <vector>

namespace rtob
{
/// Beams that see the vehicle itself: near, and always at the same range while all else moves.
class BodyCheck
{
 public:
    void add(const mrpt::obs::CObservation2DRangeScan& scan);
    void report(CheckReport& report) const;

    /// For [ScanFilter] mask_deg: bearings in the laser's frame; empty where there are none.
    [[nodiscard]] std::string mask() const;

 private:
    struct Sector
    {
        double low_deg = 0, high_deg = 0;
        std::size_t beams = 0;
    };
    void reset(const mrpt::obs::CObservation2DRangeScan& scan);
    [[nodiscard]] bool hasMoved(const mrpt::obs::CObservation2DRangeScan& scan) const;
    [[nodiscard]] bool seesBody(std::size_t beam) const;
    [[nodiscard]] std::vector<Sector> sectors() const;

    std::size_t beams_ = 0;
    double first_bearing_deg_ = 0, step_deg_ = 0;
    std::uint64_t views_ = 0;            ///< scans between which the vehicle moved
    std::vector<float> last_ranges_m_;   ///< of the last view
    std::vector<std::uint32_t> nearby_;  ///< by beam, then by range: how often
};
}  // namespace rtob

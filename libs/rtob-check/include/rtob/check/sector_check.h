// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <rtob/check/check_report.h>

#include <array>
#include <cstdint>

namespace rtob
{
/// The share of beams without a return, by bearing in the laser's frame.
class SectorCheck
{
 public:
    /// @param useful_range_m beyond, a range is none
    explicit SectorCheck(double useful_range_m) : useful_range_m_(useful_range_m) {}
    void add(const mrpt::obs::CObservation2DRangeScan& scan);
    void report(CheckReport& report) const;

 private:
    static constexpr std::size_t kSectors = 36;
    struct Sector
    {
        std::uint64_t beams = 0, none = 0;
    };
    double useful_range_m_;
    std::array<Sector, kSectors> sectors_{};
};
}  // namespace rtob

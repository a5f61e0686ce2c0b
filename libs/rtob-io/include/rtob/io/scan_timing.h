// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/obs/CObservationRawDAQ.h>

#include <optional>

/// What MRPT's scans cannot hold stands before them in the log, in objects of a class that all of
/// MRPT's programs know and pass over.
namespace rtob
{
/// How long the beams of a scan took. Its stamp is the time of its first beam; the others follow in
/// the order of their index. Which way the head turns is the scan's own `rightToLeft`.
struct ScanTiming
{
    double sweep_s = 0;  ///< from the first beam to the next scan's first one
};

[[nodiscard]] mrpt::obs::CObservationRawDAQ::Ptr timing_record(
    const mrpt::obs::CObservation2DRangeScan& scan, const ScanTiming& timing);

/// Nothing where the observation is no such record.
[[nodiscard]] std::optional<ScanTiming> read_timing_record(
    const mrpt::obs::CObservation& observation);

/// Says that the next observation of this label was too late for a live program, which did not use
/// it: a replay must not either.
[[nodiscard]] mrpt::obs::CObservationRawDAQ::Ptr dropped_record(
    const mrpt::obs::CObservation& observation);
[[nodiscard]] bool is_dropped_record(const mrpt::obs::CObservation& observation);
}  // namespace rtob

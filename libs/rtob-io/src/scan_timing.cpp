// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/io/scan_timing.h>

#include <cmath>

namespace rtob
{
namespace
{
constexpr const char* kTimingLabel = "rtob.scan_timing";
constexpr const char* kDroppedLabel = "rtob.dropped";

mrpt::obs::CObservationRawDAQ::Ptr record(
    const mrpt::obs::CObservation& observation, const char* label)
{
    auto daq = mrpt::obs::CObservationRawDAQ::Create();
    daq->timestamp = observation.timestamp;
    daq->sensorLabel = label;
    return daq;
}
}  // namespace

mrpt::obs::CObservationRawDAQ::Ptr timing_record(
    const mrpt::obs::CObservation2DRangeScan& scan, const ScanTiming& timing)
{
    auto daq = record(scan, kTimingLabel);
    daq->AIN_double = {timing.sweep_s};
    daq->AIN_channel_count = 1;
    return daq;
}

std::optional<ScanTiming> read_timing_record(const mrpt::obs::CObservation& observation)
{
    const auto* daq = dynamic_cast<const mrpt::obs::CObservationRawDAQ*>(&observation);
    if (daq == nullptr || daq->sensorLabel != kTimingLabel || daq->AIN_double.empty() ||
        !(std::isfinite(daq->AIN_double[0]) && daq->AIN_double[0] >= 0))
        return std::nullopt;
    return ScanTiming{daq->AIN_double[0]};
}

mrpt::obs::CObservationRawDAQ::Ptr dropped_record(const mrpt::obs::CObservation& observation)
{
    return record(observation, kDroppedLabel);
}

bool is_dropped_record(const mrpt::obs::CObservation& observation)
{
    return observation.sensorLabel == kDroppedLabel &&
           dynamic_cast<const mrpt::obs::CObservationRawDAQ*>(&observation) != nullptr;
}
}  // namespace rtob

// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/drivers/beam_grid.h>
#include <rtob/drivers/rplidar_parser.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

/// Any bytes, in chunks of any size: no crash, and whatever comes out is a revolution.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    if (size < 1) return 0;
    const std::size_t chunk = 1U + data[0];
    rtob::RplidarParser parser(1e-5);
    rtob::BeamGrid grid;
    const auto check = [](bool ok)
    {
        if (!ok) std::abort();
    };
    for (std::size_t at = 1; at < size; at += chunk)
    {
        parser.push({data + at, std::min(chunk, size - at)}, 1e-3 * static_cast<double>(at));
        while (const auto reply = parser.takeReply())
        {
            static_cast<void>(rtob::read_info(reply->payload));
            static_cast<void>(rtob::read_health(reply->payload));
            static_cast<void>(rtob::read_sample_times(reply->payload));
            static_cast<void>(rtob::read_config(reply->payload, rtob::RplidarConfig::ModeName));
        }
        while (const auto turn = parser.takeRevolution())
        {
            for (const auto& beam : turn->beams)
                check(
                    beam.bearing_deg >= 0 && beam.bearing_deg <= 360 && beam.range_m >= 0 &&
                    std::isfinite(beam.time_s));
            check(grid.grid(*turn).ranges_m.size() >= turn->beams.size());
        }
    }
    return 0;
}

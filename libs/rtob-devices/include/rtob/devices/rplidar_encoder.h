// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/devices/emulated_device.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

/// The scan packets of an RPLidar from the device's side. Written from the protocol's description
/// alone, without a line of the driver's, so that a misreading shows.
namespace rtob::devices
{
enum class RplidarScanKind : std::uint8_t
{
    Standard = 0x81,
    Express = 0x82,
    Ultra = 0x84,
    Dense = 0x85
};

[[nodiscard]] std::size_t packet_bytes(RplidarScanKind kind);
[[nodiscard]] std::size_t beams_of_packet(RplidarScanKind kind);

/// The beams of one packet: the head's angle at each [deg, clockwise, from 0 to 360], and how far
/// beam i sees in a direction [mm; 0: nothing].
struct PacketContent
{
    std::vector<double> shaft_deg;
    std::function<int(std::size_t beam, double bearing_deg)> range_mm;
    bool begins = false;  ///< the first packet of a stream; of a standard one: of a revolution
};

[[nodiscard]] Packet encode_packet(RplidarScanKind kind, const PacketContent& content);
}  // namespace rtob::devices

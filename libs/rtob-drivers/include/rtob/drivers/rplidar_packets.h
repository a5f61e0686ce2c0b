// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/drivers/rplidar_beam.h>
#include <rtob/drivers/rplidar_protocol.h>

#include <optional>
#include <vector>

/// The packets of a running scan, one function a kind. Distances come in millimetres.
namespace rtob
{
/// A packet of the standard scan is one beam.
constexpr std::size_t kRplidarStandardPacket_bytes = 5;

[[nodiscard]] std::size_t rplidar_packet_bytes(RplidarAnswer type);
[[nodiscard]] std::size_t rplidar_beams_of_packet(RplidarAnswer type);

/// Whether the bytes, as many as a packet of this type has, are one: flags, check bits, checksum.
[[nodiscard]] bool is_rplidar_packet(RplidarAnswer type, ByteView packet);

[[nodiscard]] RplidarBeam read_standard_packet(ByteView packet);

/// Where the head stood when the packet's first beam was taken [deg].
[[nodiscard]] double packet_shaft_deg(ByteView packet);
/// The first packet after the start of a scan: what came before does not lead to it.
[[nodiscard]] bool begins_stream(ByteView packet);

/// The beams of a packet. Its last ones lie between its own angle and the next packet's; an Ultra
/// packet needs the next one's first range, too. Times are left at 0, and no beam starts.
/// @param turn_deg the angle between the two packets
[[nodiscard]] std::vector<RplidarBeam> read_packet(
    RplidarAnswer type, ByteView packet, ByteView next, double turn_deg);

/// The 12-bit range code of Ultra packets: the farther, the coarser.
struct UltraRange
{
    int range_mm = 0;
    int shift = 0;  ///< of the differences that refer to this range
};
[[nodiscard]] UltraRange read_ultra_range(unsigned code);

/// How far behind the head's angle an Ultra beam looks: a matter of the triangulation's geometry.
[[nodiscard]] double ultra_lag_deg(int range_mm);
}  // namespace rtob

// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/drivers/rplidar_packets.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace rtob
{
namespace
{
constexpr std::size_t kHeader_bytes = 4;  ///< sync and checksum 2, start angle 2
constexpr std::uint16_t kBeginsStream = 0x8000;

double wrapped_deg(double angle_deg)
{
    const double wrapped = std::fmod(angle_deg, 360.0);
    return wrapped < 0 ? wrapped + 360.0 : wrapped;
}

bool is_standard_packet(ByteView packet)
{
    const bool start = (packet[0] & 1) != 0, not_start = (packet[0] & 2) != 0;
    return start != not_start && (packet[1] & 1) != 0;
}

/// All other kinds share the header: a checksum over what follows it, in two nibbles.
bool is_capsule(ByteView packet)
{
    if (packet[0] >> 4 != 0xA || packet[1] >> 4 != 0x5) return false;
    const int expected = (packet[0] & 0xF) | ((packet[1] & 0xF) << 4);
    int checksum = 0;
    for (std::size_t i = 2; i < packet.size; ++i) checksum ^= packet[i];
    return checksum == expected;
}

/// Collects the beams of a packet: steady steps of the head, each beam looking a little behind it.
class PacketBeams
{
 public:
    PacketBeams(double shaft_deg, double step_deg) : shaft_deg_(shaft_deg), step_deg_(step_deg) {}

    void add(int range_mm, double lag_deg)
    {
        RplidarBeam beam;
        beam.shaft_deg = wrapped_deg(shaft_deg_ + step_deg_ * static_cast<double>(beams_.size()));
        beam.bearing_deg = wrapped_deg(beam.shaft_deg - lag_deg);
        beam.range_m = static_cast<float>(range_mm) * 1e-3f;
        beams_.push_back(beam);
    }
    [[nodiscard]] std::vector<RplidarBeam> take() { return std::move(beams_); }

 private:
    double shaft_deg_, step_deg_;
    std::vector<RplidarBeam> beams_;
};

/// Sixteen cabins of two beams: range 14 bits [mm], lag 6 bits [deg/8]. Slamtec's own driver takes
/// the lag as unsigned.
void add_express(ByteView packet, PacketBeams& beams)
{
    for (std::size_t cabin = kHeader_bytes; cabin + 5 <= packet.size; cabin += 5)
    {
        const unsigned first = u16_at(packet, cabin), second = u16_at(packet, cabin + 2);
        const unsigned lags = packet[cabin + 4];
        beams.add(static_cast<int>(first >> 2), ((lags & 0xF) | ((first & 3) << 4)) / 8.0);
        beams.add(static_cast<int>(second >> 2), ((lags >> 4) | ((second & 3) << 4)) / 8.0);
    }
}

void add_dense(ByteView packet, PacketBeams& beams)
{
    for (std::size_t at = kHeader_bytes; at + 2 <= packet.size; at += 2)
        beams.add(u16_at(packet, at), 0);
}

/// A signed field of ten bits; nothing for the two values that mean "no echo".
std::optional<int> difference_of(std::uint32_t field)
{
    const int value = static_cast<int>(field & 0x3FF);
    const int difference = value < 512 ? value : value - 1024;
    if (difference == -512 || difference == 511) return std::nullopt;
    return difference;
}

int difference_to(const UltraRange& base, std::optional<int> difference)
{
    return difference ? std::max(0, base.range_mm + *difference * (1 << base.shift)) : 0;
}

/// 32 cabins of three beams: a coded range, then a difference to it, then one to the next cabin's.
void add_ultra(ByteView packet, ByteView next, PacketBeams& beams)
{
    for (std::size_t at = kHeader_bytes; at + 4 <= packet.size; at += 4)
    {
        const bool is_last = at + 8 > packet.size;
        const std::uint32_t cabin = u32_at(packet, at);
        const std::uint32_t following =
            is_last ? u32_at(next, kHeader_bytes) : u32_at(packet, at + 4);
        const UltraRange major = read_ultra_range(cabin & 0xFFF);
        const UltraRange next_major = read_ultra_range(following & 0xFFF);
        const UltraRange base = major.range_mm == 0 ? next_major : major;
        for (const int range_mm :
             {major.range_mm, difference_to(base, difference_of(cabin >> 12)),
              difference_to(next_major, difference_of(cabin >> 22))})
            beams.add(range_mm, ultra_lag_deg(range_mm));
    }
}
}  // namespace

std::size_t rplidar_packet_bytes(RplidarAnswer type)
{
    switch (type)
    {
        case RplidarAnswer::Standard:
            return kRplidarStandardPacket_bytes;
        case RplidarAnswer::Express:
        case RplidarAnswer::Dense:
            return 84;
        case RplidarAnswer::Ultra:
            return 132;
        default:
            throw std::logic_error("rplidar_packet_bytes: no kind of scan");
    }
}

std::size_t rplidar_beams_of_packet(RplidarAnswer type)
{
    switch (type)
    {
        case RplidarAnswer::Standard:
            return 1;
        case RplidarAnswer::Express:
            return 32;
        case RplidarAnswer::Dense:
            return 40;
        case RplidarAnswer::Ultra:
            return 96;
        default:
            throw std::logic_error("rplidar_beams_of_packet: no kind of scan");
    }
}

bool is_rplidar_packet(RplidarAnswer type, ByteView packet)
{
    return type == RplidarAnswer::Standard ? is_standard_packet(packet) : is_capsule(packet);
}

RplidarBeam read_standard_packet(ByteView packet)
{
    RplidarBeam beam;
    beam.starts = (packet[0] & 1) != 0;
    beam.bearing_deg = wrapped_deg((u16_at(packet, 1) >> 1) / 64.0);
    beam.shaft_deg = beam.bearing_deg;
    beam.range_m = u16_at(packet, 3) * 0.25e-3f;
    return beam;
}

double packet_shaft_deg(ByteView packet)
{
    return wrapped_deg((u16_at(packet, 2) & ~kBeginsStream) / 64.0);
}

bool begins_stream(ByteView packet)
{
    return (u16_at(packet, 2) & kBeginsStream) != 0;
}

std::vector<RplidarBeam> read_packet(
    RplidarAnswer type, ByteView packet, ByteView next, double turn_deg)
{
    const auto count = static_cast<double>(rplidar_beams_of_packet(type));
    PacketBeams beams(packet_shaft_deg(packet), turn_deg / count);
    if (type == RplidarAnswer::Express)
        add_express(packet, beams);
    else if (type == RplidarAnswer::Dense)
        add_dense(packet, beams);
    else
        add_ultra(packet, next, beams);
    return beams.take();
}

UltraRange read_ultra_range(unsigned code)
{
    struct Part
    {
        int code_begin, range_begin_mm, shift;
    };
    constexpr std::array<Part, 5> parts{
        {{3328, 1 << 14, 4}, {1792, 1 << 12, 3}, {1280, 1 << 11, 2}, {512, 1 << 9, 1}, {0, 0, 0}}};
    const int value = static_cast<int>(code);
    for (const Part& part : parts)
        if (value >= part.code_begin)
            return {part.range_begin_mm + ((value - part.code_begin) << part.shift), part.shift};
    return {};
}

double ultra_lag_deg(int range_mm)
{
    constexpr int nearest_mm = 50;
    if (range_mm < nearest_mm) return 7.5;
    // Slamtec's fit in radians: 8 degrees less two terms that fade with the distance.
    const double k = 98361.0 / (4.0 * range_mm);
    const double nearer_rad = (64.0 * k + k * k * k / 98304.0) / 65536.0;
    return 8.0 - nearer_rad * 180.0 / 3.14159265358979323846;
}
}  // namespace rtob

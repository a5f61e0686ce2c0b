// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/devices/rplidar_encoder.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <stdexcept>

namespace rtob::devices
{
namespace
{
constexpr double kPi = 3.14159265358979323846;

void put_u16(Packet& packet, unsigned value)
{
    packet.push_back(static_cast<std::uint8_t>(value & 0xFF));
    packet.push_back(static_cast<std::uint8_t>((value >> 8) & 0xFF));
}

double wrapped(double angle_deg)
{
    return angle_deg - 360 * std::floor(angle_deg / 360);
}

/// Four bytes that all packets but the standard one begin with; the checksum comes last.
Packet header(const PacketContent& content)
{
    Packet packet{0xA0, 0x50};
    const auto start =
        static_cast<unsigned>(std::lround(wrapped(content.shaft_deg[0]) * 64)) % (360U * 64U);
    put_u16(packet, start | (content.begins ? 0x8000U : 0U));
    return packet;
}

Packet sealed(Packet packet)
{
    unsigned checksum = 0;
    for (std::size_t i = 2; i < packet.size(); ++i) checksum ^= packet[i];
    packet[0] = static_cast<std::uint8_t>(0xA0U | (checksum & 0xFU));
    packet[1] = static_cast<std::uint8_t>(0x50U | (checksum >> 4));
    return packet;
}

/// The triangulating devices look behind the head's angle, the less the nearer the target.
double lag_deg(int range_mm)
{
    if (range_mm < 50) return 7.5;
    const double inverse = 98361.0 / (range_mm * 4.0);
    const double nearer = inverse * 64 + std::pow(inverse, 3) / 98304;
    return 8 - nearer / 65536 * 180 / kPi;
}

Packet encode_standard(const PacketContent& content)
{
    const double bearing_deg = wrapped(content.shaft_deg[0]);
    const int range = content.range_mm(0, bearing_deg);
    const auto angle = static_cast<unsigned>(std::lround(bearing_deg * 64)) % (360U * 64U);
    Packet packet;
    const unsigned quality = range > 0 ? 15 : 0;
    packet.push_back(static_cast<std::uint8_t>((quality << 2) | (content.begins ? 1U : 2U)));
    put_u16(packet, (angle << 1) | 1U);
    put_u16(packet, static_cast<unsigned>(range) * 4U);
    return packet;
}

struct LaggingBeam
{
    unsigned range_mm, lag_eighths;
};

/// The lag that is sent decides where the beam looks, so its rounding is no error.
LaggingBeam express_beam(const PacketContent& content, std::size_t beam)
{
    const double shaft_deg = content.shaft_deg[beam];
    const int roughly_mm = content.range_mm(beam, wrapped(shaft_deg - 7));
    const auto eighths = static_cast<int>(std::lround(lag_deg(roughly_mm) * 8));
    const int lag = std::clamp(eighths, 0, 63);
    const int range = content.range_mm(beam, wrapped(shaft_deg - lag / 8.0));
    return {static_cast<unsigned>(std::min(range, 16383)), static_cast<unsigned>(lag)};
}

Packet encode_express(const PacketContent& content)
{
    Packet packet = header(content);
    for (std::size_t beam = 0; beam < 32; beam += 2)
    {
        const auto first = express_beam(content, beam), second = express_beam(content, beam + 1);
        put_u16(packet, (first.range_mm << 2) | (first.lag_eighths >> 4));
        put_u16(packet, (second.range_mm << 2) | (second.lag_eighths >> 4));
        packet.push_back(static_cast<std::uint8_t>(
            (first.lag_eighths & 0xFU) | ((second.lag_eighths & 0xFU) << 4)));
    }
    return sealed(packet);
}

Packet encode_dense(const PacketContent& content)
{
    Packet packet = header(content);
    for (std::size_t beam = 0; beam < 40; ++beam)
        put_u16(
            packet, static_cast<unsigned>(
                        std::min(content.range_mm(beam, wrapped(content.shaft_deg[beam])), 65535)));
    return sealed(packet);
}

/// Where an Ultra beam looks follows from the range it finds there.
int ultra_range(const PacketContent& content, std::size_t beam)
{
    int range = 5000;
    for (int i = 0; i < 8; ++i)
        range = content.range_mm(beam, wrapped(content.shaft_deg[beam] - lag_deg(range)));
    return range;
}

struct CodedRange
{
    unsigned code;
    int range_mm, shift;
};

CodedRange coded(int range_mm)
{
    const int range = std::clamp(range_mm, 0, 28671);
    if (range < 512) return {static_cast<unsigned>(range), range, 0};
    const int shift = range < 2048 ? 1 : range < 4096 ? 2 : range < 16384 ? 3 : 4;
    const int range_begin = shift == 1 ? 512 : shift == 2 ? 2048 : shift == 3 ? 4096 : 16384;
    const int code_begin = shift == 1 ? 512 : shift == 2 ? 1280 : shift == 3 ? 1792 : 3328;
    const int steps = (range - range_begin) >> shift;
    return {static_cast<unsigned>(code_begin + steps), range_begin + (steps << shift), shift};
}

unsigned difference(int range_mm, const CodedRange& base)
{
    constexpr int no_echo = -512, largest = 510;
    if (range_mm == 0) return static_cast<unsigned>(no_echo) & 0x3FFU;
    const int steps = static_cast<int>(
        std::lround(static_cast<double>(range_mm - base.range_mm) / (1 << base.shift)));
    const bool fits = std::abs(steps) <= largest;
    return static_cast<unsigned>(fits ? steps : no_echo) & 0x3FFU;
}

Packet encode_ultra(const PacketContent& content)
{
    Packet packet = header(content);
    for (std::size_t beam = 0; beam < 96; beam += 3)
    {
        const CodedRange major = coded(ultra_range(content, beam));
        // The beam after the packet's last: its angle goes on at the same rate.
        const CodedRange next = coded(ultra_range(content, beam + 3));
        const CodedRange base = major.range_mm == 0 ? next : major;
        const unsigned word = major.code |
                              (difference(ultra_range(content, beam + 1), base) << 12) |
                              (difference(ultra_range(content, beam + 2), next) << 22);
        put_u16(packet, word & 0xFFFFU);
        put_u16(packet, word >> 16);
    }
    return sealed(packet);
}
}  // namespace

std::size_t packet_bytes(RplidarScanKind kind)
{
    switch (kind)
    {
        case RplidarScanKind::Standard:
            return 5;
        case RplidarScanKind::Ultra:
            return 132;
        case RplidarScanKind::Express:
        case RplidarScanKind::Dense:
            return 84;
    }
    throw std::logic_error("packet_bytes: unknown kind");
}

std::size_t beams_of_packet(RplidarScanKind kind)
{
    switch (kind)
    {
        case RplidarScanKind::Standard:
            return 1;
        case RplidarScanKind::Express:
            return 32;
        case RplidarScanKind::Ultra:
            return 96;
        case RplidarScanKind::Dense:
            return 40;
    }
    throw std::logic_error("beams_of_packet: unknown kind");
}

Packet encode_packet(RplidarScanKind kind, const PacketContent& content)
{
    switch (kind)
    {
        case RplidarScanKind::Standard:
            return encode_standard(content);
        case RplidarScanKind::Express:
            return encode_express(content);
        case RplidarScanKind::Ultra:
            return encode_ultra(content);
        case RplidarScanKind::Dense:
            return encode_dense(content);
    }
    throw std::logic_error("encode_packet: unknown kind");
}
}  // namespace rtob::devices

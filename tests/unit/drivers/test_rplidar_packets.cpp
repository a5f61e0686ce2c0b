// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <rtob/drivers/rplidar_packets.h>

#include <cmath>

namespace rtob
{
namespace
{
Bytes sealed(Bytes packet)
{
    unsigned checksum = 0;
    for (std::size_t i = 2; i < packet.size(); ++i) checksum ^= packet[i];
    packet[0] = static_cast<std::uint8_t>(0xA0U | (checksum & 0xFU));
    packet[1] = static_cast<std::uint8_t>(0x50U | (checksum >> 4));
    return packet;
}

/// A packet of zeros that starts at this angle.
Bytes empty_packet(RplidarAnswer type, unsigned start_deg)
{
    Bytes packet(rplidar_packet_bytes(type), 0);
    packet[2] = static_cast<std::uint8_t>((start_deg * 64) & 0xFF);
    packet[3] = static_cast<std::uint8_t>((start_deg * 64) >> 8);
    return packet;
}

TEST(StandardPacket, HoldsBearingRangeAndStart)
{
    // Quality 15 and start; 90.5 degrees = 5792/64, as 5792 * 2 + 1 = 0x2D41; 2 m = 8000/4 mm.
    const Bytes packet{0x3D, 0x41, 0x2D, 0x40, 0x1F};
    ASSERT_TRUE(is_rplidar_packet(RplidarAnswer::Standard, packet));
    const auto beam = read_standard_packet(packet);
    EXPECT_DOUBLE_EQ(90.5, beam.bearing_deg);
    EXPECT_FLOAT_EQ(2.0f, beam.range_m);
    EXPECT_TRUE(beam.starts);
}

TEST(StandardPacket, ChecksItsThreeBits)
{
    EXPECT_TRUE(is_rplidar_packet(RplidarAnswer::Standard, Bytes{0x3E, 0x41, 0x2D, 0x40, 0x1F}));
    EXPECT_FALSE(is_rplidar_packet(RplidarAnswer::Standard, Bytes{0x3F, 0x41, 0x2D, 0x40, 0x1F}));
    EXPECT_FALSE(is_rplidar_packet(RplidarAnswer::Standard, Bytes{0x3C, 0x41, 0x2D, 0x40, 0x1F}));
    EXPECT_FALSE(is_rplidar_packet(RplidarAnswer::Standard, Bytes{0x3D, 0x40, 0x2D, 0x40, 0x1F}));
}

TEST(ExpressPacket, BeamsShareTheTurnAndLagBehindTheHead)
{
    Bytes packet = empty_packet(RplidarAnswer::Express, 10);
    // First cabin: 1000 mm with a lag of 7.875 degrees = 63/8, 250 mm with one of 1/8.
    packet[4] = 0xA0 | 3;  // 1000 = 0x3E8, times 4 = 0xFA0; the upper two bits of 63
    packet[5] = 0x0F;
    packet[6] = 0xE8;  // 250 = 0xFA, times 4 = 0x3E8; upper bits 0
    packet[7] = 0x03;
    packet[8] = 0x1F;  // lower four bits: 1 of the second, 15 of the first
    packet = sealed(packet);
    ASSERT_TRUE(is_rplidar_packet(RplidarAnswer::Express, packet));

    const auto beams = read_packet(RplidarAnswer::Express, packet, packet, 32);
    ASSERT_EQ(32u, beams.size());
    EXPECT_DOUBLE_EQ(10.0, beams[0].shaft_deg);
    EXPECT_DOUBLE_EQ(10.0 - 7.875, beams[0].bearing_deg);
    EXPECT_FLOAT_EQ(1.0f, beams[0].range_m);
    EXPECT_DOUBLE_EQ(11.0 - 0.125, beams[1].bearing_deg);
    EXPECT_FLOAT_EQ(0.25f, beams[1].range_m);
    EXPECT_DOUBLE_EQ(41.0, beams[31].bearing_deg);
    EXPECT_FLOAT_EQ(0.0f, beams[31].range_m);
}

TEST(ExpressPacket, AnglesWrapInBothDirections)
{
    Bytes packet = empty_packet(RplidarAnswer::Express, 350);
    const auto ahead = read_packet(RplidarAnswer::Express, sealed(packet), sealed(packet), 32);
    EXPECT_DOUBLE_EQ(0.0, ahead[10].bearing_deg);
    packet = empty_packet(RplidarAnswer::Express, 0);
    packet[8] = 0x08;  // a lag of 1 degree
    const auto behind = read_packet(RplidarAnswer::Express, sealed(packet), sealed(packet), 32);
    EXPECT_DOUBLE_EQ(359.0, behind[0].bearing_deg);
}

TEST(Capsules, AreCheckedAsAWhole)
{
    for (const auto type : {RplidarAnswer::Express, RplidarAnswer::Dense, RplidarAnswer::Ultra})
    {
        const Bytes good = sealed(empty_packet(type, 123));
        ASSERT_TRUE(is_rplidar_packet(type, good));
        for (std::size_t place = 0; place < good.size(); ++place)
        {
            Bytes bad = good;
            bad[place] ^= 0x10;
            EXPECT_FALSE(is_rplidar_packet(type, bad)) << "byte " << place;
        }
    }
}

TEST(Capsules, TellWhereAStreamBegins)
{
    Bytes packet = empty_packet(RplidarAnswer::Dense, 300);
    EXPECT_FALSE(begins_stream(packet));
    EXPECT_DOUBLE_EQ(300.0, packet_shaft_deg(packet));
    packet[3] |= 0x80;
    EXPECT_TRUE(begins_stream(packet));
    EXPECT_DOUBLE_EQ(300.0, packet_shaft_deg(packet));
}

TEST(DensePacket, HoldsFortyRanges)
{
    Bytes packet = empty_packet(RplidarAnswer::Dense, 0);
    packet[4] = 0x10;  // 10000 mm = 0x2710
    packet[5] = 0x27;
    const auto beams = read_packet(RplidarAnswer::Dense, sealed(packet), sealed(packet), 4);
    ASSERT_EQ(40u, beams.size());
    EXPECT_FLOAT_EQ(10.0f, beams[0].range_m);
    EXPECT_NEAR(3.9, beams[39].bearing_deg, 1e-12);
}

TEST(UltraRange, FollowsItsFiveScales)
{
    struct Row
    {
        unsigned code;
        int range_mm, shift;
    };
    // By hand: below 512 as it is, then steps of 2, 4, 8 and 16 mm from 512, 2048, 4096, 16384.
    for (const Row& row :
         {Row{0, 0, 0}, Row{511, 511, 0}, Row{512, 512, 1}, Row{1279, 2046, 1}, Row{1280, 2048, 2},
          Row{1791, 4092, 2}, Row{1792, 4096, 3}, Row{3327, 16376, 3}, Row{3328, 16384, 4},
          Row{4095, 28656, 4}})
    {
        const auto range = read_ultra_range(row.code);
        EXPECT_EQ(row.range_mm, range.range_mm) << row.code;
        EXPECT_EQ(row.shift, range.shift) << row.code;
    }
}

TEST(UltraPacket, DifferencesReferToTheirOwnAndTheNextRange)
{
    Bytes packet = empty_packet(RplidarAnswer::Ultra, 0);
    const auto put = [&](std::size_t cabin, unsigned major, int predict1, int predict2)
    {
        const unsigned word = major | ((static_cast<unsigned>(predict1) & 0x3FFU) << 12) |
                              ((static_cast<unsigned>(predict2) & 0x3FFU) << 22);
        for (std::size_t i = 0; i < 4; ++i)
            packet[4 + 4 * cabin + i] = static_cast<std::uint8_t>(word >> (8 * i));
    };
    put(0, 512 + 244, 5, -3);  // 1000 mm in steps of 2; 1010; 300 - 3 = 297 of the next
    put(1, 300, 511, -512);    // both: no echo
    put(2, 0, 4, 0);           // nothing; the next range is the base: 404, 400
    put(3, 400, 0, 0);
    packet = sealed(packet);
    const auto beams = read_packet(RplidarAnswer::Ultra, packet, packet, 20);
    ASSERT_EQ(96u, beams.size());
    const auto mm = [&](std::size_t i) { return std::lround(1000 * beams[i].range_m); };
    EXPECT_EQ(1000, mm(0));
    EXPECT_EQ(1010, mm(1));
    EXPECT_EQ(297, mm(2));
    EXPECT_EQ(300, mm(3));
    EXPECT_EQ(0, mm(4));
    EXPECT_EQ(0, mm(5));
    EXPECT_EQ(0, mm(6));
    EXPECT_EQ(404, mm(7));
    EXPECT_EQ(400, mm(8));
    EXPECT_EQ(400, mm(9));
    // The last beam of all refers to the next packet's first range: here this packet's own.
    EXPECT_EQ(1000, mm(95));
}

TEST(UltraLag, FadesWithTheInverseOfTheDistance)
{
    EXPECT_DOUBLE_EQ(7.5, ultra_lag_deg(0));
    EXPECT_DOUBLE_EQ(7.5, ultra_lag_deg(49));
    // At 1 m: k = 24.59; 8 - (64 * 24.59 + 0.15) / 65536 rad = 8 - 1.376 degrees.
    EXPECT_NEAR(6.624, ultra_lag_deg(1000), 1e-3);
    EXPECT_NEAR(7.945, ultra_lag_deg(25000), 1e-3);
}
}  // namespace
}  // namespace rtob

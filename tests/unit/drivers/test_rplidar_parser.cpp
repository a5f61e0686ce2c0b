// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <rtob/devices/rplidar_emulator.h>
#include <rtob/drivers/rplidar_parser.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace rtob
{
namespace
{
using devices::RplidarEmulator;

double clockwise_deg(double bearing_rad)
{
    const double deg = -bearing_rad * 180 / M_PI;
    return deg - 360 * std::floor(deg / 360);
}

/// A range for every bearing: a device that looks at 90 degrees sees 4.25 m.
double telling_range(double bearing_rad, double)
{
    return 2 + clockwise_deg(bearing_rad) / 40;
}

constexpr double begin_s = 1000;

/// What an emulated device sends in the first seconds of a scan.
Bytes recorded(const devices::RplidarModel& model, std::size_t mode, double seconds)
{
    RplidarEmulator device(model, telling_range);
    device.receive(
        mode == 0 ? rplidar_request(RplidarCommand::Scan)
                  : rplidar_request(
                        RplidarCommand::ExpressScan, {static_cast<std::uint8_t>(mode), 0, 0, 0, 0}),
        begin_s);
    Bytes bytes;
    for (const auto& packet : device.send(begin_s + seconds))
        bytes.insert(bytes.end(), packet.begin(), packet.end());
    return bytes;
}

std::vector<RplidarRevolution> turns_of(RplidarParser& parser, const Bytes& bytes)
{
    std::vector<RplidarRevolution> turns;
    for (std::size_t i = 0; i < bytes.size(); i += 64)
    {
        parser.push(ByteView(bytes).from(i).first(std::min<std::size_t>(64, bytes.size() - i)), 0);
        while (auto turn = parser.takeRevolution()) turns.push_back(std::move(*turn));
    }
    return turns;
}

struct ModelMode
{
    const char* name;
    devices::RplidarModel (*model)();
    std::size_t mode;
};

class AllModes : public testing::TestWithParam<ModelMode>
{
};

INSTANTIATE_TEST_SUITE_P(
    RplidarParser, AllModes,
    testing::Values(
        ModelMode{"A1Standard", devices::model_a1, 0}, ModelMode{"A1Express", devices::model_a1, 1},
        ModelMode{"A2Standard", devices::model_a2, 0}, ModelMode{"A2Express", devices::model_a2, 1},
        ModelMode{"A3Standard", devices::model_a3, 0}, ModelMode{"A3Express", devices::model_a3, 1},
        ModelMode{"A3Ultra", devices::model_a3, 2}, ModelMode{"S2Standard", devices::model_s2, 0},
        ModelMode{"S2Dense", devices::model_s2, 1}),
    [](const auto& param) { return std::string(param.param.name); });

TEST_P(AllModes, EveryBeamLooksWhereItWasTaken)
{
    const auto model = GetParam().model();
    RplidarParser parser;
    const auto turns = turns_of(parser, recorded(model, GetParam().mode, 1.0));
    ASSERT_GE(turns.size(), static_cast<std::size_t>(model.turns_hz) - 2);
    for (const auto& turn : turns)
    {
        const double half_step_deg = 180.0 / static_cast<double>(turn.beams.size());
        std::size_t seen = 0;
        for (const auto& beam : turn.beams)
        {
            if (beam.range_m == 0) continue;
            ++seen;
            // Ranges are sent in steps of up to 8 mm at this distance: 0.32 degrees.
            const double taken_deg = 40 * (beam.range_m - 2.0);
            const double off = std::remainder(taken_deg - beam.bearing_deg, 360);
            EXPECT_LE(std::abs(off), half_step_deg + 0.33) << "at " << beam.bearing_deg;
        }
        EXPECT_GE(seen, turn.beams.size() * 97 / 100);
    }
    EXPECT_EQ(0u, parser.counters().bytes_skipped);
    EXPECT_EQ(0u, parser.counters().stray_beams);
}

constexpr auto always = [](double) { return true; };

/// As a line delivers them: each byte when the device has sent it, or when it is read.
/// @param is_read whether what came is read at a time since the begin [s]
/// @param arrives whether a packet of that time is not lost
template <class IsRead, class Arrives>
std::vector<RplidarRevolution> turns_in_time(
    const ModelMode& param, IsRead is_read, Arrives arrives)
{
    const auto model = param.model();
    RplidarParser parser(10.0 / model.baud);
    parser.setSampleTime(model.modes[param.mode].sample_s);
    RplidarEmulator device(model, telling_range);
    device.receive(
        rplidar_request(
            param.mode == 0 ? RplidarCommand::Scan : RplidarCommand::ExpressScan,
            {static_cast<std::uint8_t>(param.mode), 0, 0, 0, 0}),
        begin_s);
    std::vector<RplidarRevolution> turns;
    for (double t = 0; t < 1; t += 1e-3)
    {
        if (!is_read(t)) continue;
        for (const auto& packet : device.send(begin_s + t))
            if (arrives(t)) parser.push(packet, begin_s + t);
        while (auto turn = parser.takeRevolution()) turns.push_back(std::move(*turn));
    }
    return turns;
}

void expect_true_times(const devices::RplidarModel& model, const RplidarRevolution& turn)
{
    EXPECT_NEAR(1 / model.turns_hz, turn.sweep_s, 2.5e-3);  // seen at whole milliseconds
    // The head passes 0 at the start; in packets the beam before it may count as the first.
    const double turns_done = (turn.start_s - begin_s) * model.turns_hz;
    EXPECT_NEAR(std::round(turns_done), turns_done, 2.5e-3 * model.turns_hz);
}

TEST_P(AllModes, ATurnHasItsBeamsAndItsTime)
{
    const auto model = GetParam().model();
    const auto turns = turns_in_time(GetParam(), always, always);
    ASSERT_GE(turns.size(), 3u);
    const double beams = 1 / (model.turns_hz * model.modes[GetParam().mode].sample_s);
    for (const auto& turn : turns)
    {
        EXPECT_NEAR(beams, static_cast<double>(turn.beams.size()), 1.5);
        expect_true_times(model, turn);
    }
}

TEST_P(AllModes, ATurnHasItsTimeOnABusyComputer)
{
    const auto model = GetParam().model();
    const auto is_read = [](double t)
    { return !(t > 0.2 && t < 0.5) && !(t > 0.55 && t < 0.63) && !(t > 0.8 && t < 0.95); };
    const auto turns = turns_in_time(GetParam(), is_read, always);
    ASSERT_GE(turns.size(), 3u);
    for (const auto& turn : turns) expect_true_times(model, turn);
}

/// A delay that nothing can make good: late times, but no turn before the last one. It hits each
/// part of a turn.
TEST_P(AllModes, TurnsNeverStepBackInTime)
{
    const double turn_s = 1 / GetParam().model().turns_hz;
    for (double delay_begin_s = 0.1; delay_begin_s < 0.1 + turn_s; delay_begin_s += 6e-3)
    {
        const auto is_read = [&](double t) { return t < delay_begin_s || t > delay_begin_s + 0.6; };
        double last_s = begin_s - 1;
        for (const auto& turn : turns_in_time(GetParam(), is_read, always))
        {
            EXPECT_GE(turn.start_s, last_s) << delay_begin_s;
            EXPECT_GE(turn.sweep_s, 0) << delay_begin_s;
            last_s = turn.start_s;
        }
    }
}

/// Whole packets, as when a buffer was full: nothing but the head's angle tells. At each part of a
/// turn.
TEST_P(AllModes, ATurnHasItsTimeAfterPacketsWereLost)
{
    const auto model = GetParam().model();
    for (double loss_s = 0.3; loss_s < 0.3 + 1 / model.turns_hz; loss_s += 2e-3)
    {
        const auto arrives = [&](double t) { return t < loss_s || t > loss_s + 0.15; };
        for (const auto& turn : turns_in_time(GetParam(), always, arrives))
            expect_true_times(model, turn);
    }
}

TEST_P(AllModes, BytesMayComeOneByOne)
{
    const Bytes bytes = recorded(GetParam().model(), GetParam().mode, 0.6);
    RplidarParser whole, bytewise;
    const auto expected = turns_of(whole, bytes);
    std::size_t turns = 0;
    for (const auto byte : bytes)
    {
        bytewise.push({&byte, 1}, 0);
        while (const auto turn = bytewise.takeRevolution())
        {
            ASSERT_LT(turns, expected.size());
            EXPECT_EQ(expected[turns].beams.size(), turn->beams.size());
            EXPECT_EQ(expected[turns].beams[7].bearing_deg, turn->beams[7].bearing_deg);
            ++turns;
        }
    }
    EXPECT_EQ(expected.size(), turns);
}

TEST_P(AllModes, RecoversFromNoiseAndGivesNoWrongTurn)
{
    const auto model = GetParam().model();
    Bytes bytes = recorded(model, GetParam().mode, 4.0);
    std::mt19937 random(5);
    const std::size_t noisy_until = bytes.size() / 2;
    for (std::size_t i = 20; i < noisy_until; i += 1 + random() % 4000)
        bytes[i] = static_cast<std::uint8_t>(random());
    bytes.erase(bytes.begin() + 5000, bytes.begin() + 5100);
    RplidarParser parser;
    const auto turns = turns_of(parser, bytes);
    const auto turns_after_noise = static_cast<std::size_t>(2 * model.turns_hz) - 3;
    EXPECT_GE(turns.size(), turns_after_noise);
    for (const auto& turn : turns)
    {
        std::size_t wrong = 0;
        for (const auto& beam : turn.beams)
            wrong +=
                beam.range_m > 0 &&
                std::abs(std::remainder(40 * (beam.range_m - 2.0) - beam.bearing_deg, 360)) > 1.5;
        // A standard beam has no checksum: its range may be damaged unseen. Packets have one of 8
        // bits, and a damaged one passes in 1 of 256 cases.
        EXPECT_LE(wrong, 3u);
    }
}

TEST(RplidarParser, TakesAReplyThatComesAfterTheRestOfAScan)
{
    Bytes bytes = recorded(devices::model_a1(), 1, 0.5);
    RplidarParser parser;
    parser.expectReply();
    bytes.erase(bytes.begin(), bytes.begin() + 30);  // the stream's own descriptor is long gone
    const Bytes health{0xA5, 0x5A, 3, 0, 0, 0, 0x06, 1, 0x34, 0x12};
    bytes.insert(bytes.end(), health.begin(), health.end());
    parser.push(bytes, 0);
    const auto reply = parser.takeReply();
    ASSERT_TRUE(reply);
    EXPECT_EQ(RplidarAnswer::Health, reply->type);
    EXPECT_EQ(Bytes({1, 0x34, 0x12}), reply->payload);
    EXPECT_FALSE(parser.takeRevolution());
}

TEST(RplidarParser, TellsThatAScanHasBegun)
{
    RplidarParser parser;
    parser.push(Bytes{0xA5, 0x5A, 0x54, 0, 0, 0x40, 0x82}, 0);
    const auto reply = parser.takeReply();
    ASSERT_TRUE(reply);
    EXPECT_TRUE(reply->is_stream);
    EXPECT_EQ(RplidarAnswer::Express, reply->type);
}

TEST(RplidarParser, RefusesAStreamWithPacketsOfAnotherLength)
{
    RplidarParser parser;
    parser.push(Bytes{0xA5, 0x5A, 0x50, 0, 0, 0x40, 0x82}, 0);
    EXPECT_FALSE(parser.takeReply());
}

TEST(RplidarParser, ALostPacketMakesTheTurnPartial)
{
    const auto model = devices::model_a2();
    Bytes bytes = recorded(model, 1, 1.0);
    const std::size_t packet = 84;
    // Whole packets vanish, as when the line's buffer overflows: no checksum tells.
    bytes.erase(bytes.begin() + 7 + 20 * packet, bytes.begin() + 7 + 21 * packet);
    RplidarParser parser;
    const auto turns = turns_of(parser, bytes);
    EXPECT_EQ(1u, parser.counters().partial_revolutions);
    EXPECT_EQ(1u, parser.counters().packets_missed);
    for (const auto& turn : turns) EXPECT_NEAR(397, static_cast<double>(turn.beams.size()), 2);
}

TEST(RplidarParser, HoldsAFewTurnsOnlyForOneWhoDoesNotAsk)
{
    RplidarParser parser;
    parser.push(recorded(devices::model_a2(), 1, 10.0), 0);
    std::size_t held = 0;
    while (parser.takeRevolution()) ++held;
    EXPECT_EQ(16u, held);
    EXPECT_GT(parser.counters().revolutions, 90u);
}
}  // namespace
}  // namespace rtob

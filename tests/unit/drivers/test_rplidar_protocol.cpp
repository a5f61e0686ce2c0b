// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <rtob/drivers/rplidar_protocol.h>

namespace rtob
{
namespace
{
using testing::ElementsAre;

TEST(RplidarRequest, IsTwoBytesWithoutPayload)
{
    EXPECT_THAT(rplidar_request(RplidarCommand::Stop), ElementsAre(0xA5, 0x25));
    EXPECT_THAT(rplidar_request(RplidarCommand::Scan), ElementsAre(0xA5, 0x20));
}

TEST(RplidarRequest, EndsWithTheSumOfItsBytes)
{
    // A5 ^ 82 ^ 05 = 22, the example of the protocol's description.
    EXPECT_THAT(
        rplidar_request(RplidarCommand::ExpressScan, {0, 0, 0, 0, 0}),
        ElementsAre(0xA5, 0x82, 0x05, 0, 0, 0, 0, 0, 0x22));
    // A5 ^ F0 ^ 02 ^ 94 ^ 02 = C1
    EXPECT_THAT(
        rplidar_request(RplidarCommand::MotorPwm, {0x94, 0x02}),
        ElementsAre(0xA5, 0xF0, 0x02, 0x94, 0x02, 0xC1));
}

TEST(RplidarRequest, AsksForAModesName)
{
    // A5 ^ 84 ^ 06 ^ 7F ^ 02 = 5A
    EXPECT_THAT(
        rplidar_config_request(RplidarConfig::ModeName, 2),
        ElementsAre(0xA5, 0x84, 0x06, 0x7F, 0, 0, 0, 2, 0, 0x5A));
}

TEST(ReadDescriptor, KnowsSingleAnswersAndStreams)
{
    const auto health = read_descriptor(Bytes{0xA5, 0x5A, 0x03, 0, 0, 0, 0x06});
    ASSERT_TRUE(health);
    EXPECT_EQ(3u, health->payload_bytes);
    EXPECT_FALSE(health->is_stream);
    EXPECT_EQ(RplidarAnswer::Health, health->type);

    const auto scan = read_descriptor(Bytes{0xA5, 0x5A, 0x05, 0, 0, 0x40, 0x81});
    ASSERT_TRUE(scan);
    EXPECT_EQ(5u, scan->payload_bytes);
    EXPECT_TRUE(scan->is_stream);
    EXPECT_EQ(RplidarAnswer::Standard, scan->type);
}

TEST(ReadDescriptor, RefusesWhatIsNone)
{
    const Bytes good{0xA5, 0x5A, 0x05, 0, 0, 0x40, 0x81};
    for (const std::size_t place : {0U, 1U, 6U})
    {
        Bytes bad = good;
        bad[place] ^= 0x08;
        EXPECT_FALSE(read_descriptor(bad)) << "byte " << place;
    }
    EXPECT_FALSE(read_descriptor(Bytes{0xA5, 0x5A, 0, 0, 0, 0, 0x06})) << "no payload";
    EXPECT_FALSE(read_descriptor(Bytes{0xA5, 0x5A, 3, 0, 0, 0x80, 0x06})) << "send mode 2";
    EXPECT_FALSE(read_descriptor(Bytes{0xA5, 0x5A, 0xFF, 0xFF, 0, 0, 0x06})) << "64 kB";
    EXPECT_FALSE(read_descriptor(Bytes{0xA5, 0x5A, 3}));
}

TEST(ReadInfo, NamesModelFirmwareAndSerial)
{
    Bytes payload{0x18, 29, 1, 7};
    for (int i = 0; i < 16; ++i) payload.push_back(static_cast<std::uint8_t>(0xF0 + i));
    const auto info = read_info(payload);
    ASSERT_TRUE(info);
    EXPECT_EQ("A1M8", info->modelName());
    EXPECT_EQ(1, info->firmware_major);
    EXPECT_EQ(29, info->firmware_minor);
    EXPECT_EQ("F0F1F2F3F4F5F6F7F8F9FAFBFCFDFEFF", info->serial);
    EXPECT_TRUE(info->tellsModes());
    EXPECT_FALSE(info->hasPwmControl());
    EXPECT_FALSE(read_info(Bytes(19)));
}

TEST(ReadInfo, KnowsHowAMotorIsDriven)
{
    RplidarInfo info;
    info.model = 0x28;  // A2M8
    EXPECT_TRUE(info.hasPwmControl());
    EXPECT_FALSE(info.hasSpeedControl());
    info.model = 0x71;  // S2M1
    EXPECT_FALSE(info.hasPwmControl());
    EXPECT_TRUE(info.hasSpeedControl());
    info.model = 0x9A;
    EXPECT_EQ("model 0x9a", info.modelName());
}

TEST(ReadInfo, OldFirmwareTellsNoModes)
{
    RplidarInfo info;
    info.firmware_major = 1;
    info.firmware_minor = 23;
    EXPECT_FALSE(info.tellsModes());
    info.firmware_minor = 24;
    EXPECT_TRUE(info.tellsModes());
}

TEST(ReadHealth, TellsStatusAndCode)
{
    const auto broken = read_health(Bytes{2, 0x01, 0x80});
    ASSERT_TRUE(broken);
    EXPECT_EQ(RplidarHealth::Error, broken->health);
    EXPECT_EQ(0x8001u, broken->error_code);
    EXPECT_FALSE(read_health(Bytes{3, 0, 0})) << "no such status";
    EXPECT_FALSE(read_health(Bytes{0, 0}));
}

TEST(ReadSampleTimes, AreMicroseconds)
{
    const auto times = read_sample_times(Bytes{0xFC, 0x01, 0xFC, 0x00});
    ASSERT_TRUE(times);
    EXPECT_DOUBLE_EQ(508e-6, times->standard_s);
    EXPECT_DOUBLE_EQ(252e-6, times->express_s);
}

TEST(ReadConfig, DropsTheEchoedQuestion)
{
    const auto count = read_config(Bytes{0x70, 0, 0, 0, 3, 0}, RplidarConfig::ModeCount);
    ASSERT_TRUE(count);
    EXPECT_THAT(*count, ElementsAre(3, 0));
    EXPECT_FALSE(read_config(Bytes{0x71, 0, 0, 0, 3, 0}, RplidarConfig::ModeCount));
    EXPECT_FALSE(read_config(Bytes{0x70, 0}, RplidarConfig::ModeCount));
}
}  // namespace
}  // namespace rtob

// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <rtob/drivers/mavlink_codec.h>

#include <random>

namespace rtob
{
namespace
{
using namespace mavlink;

TEST(MavlinkCrc, HasThePublishedCheckValue)
{
    MavlinkCrc crc;
    crc.add(std::string_view("123456789"));
    EXPECT_EQ(0x6F91, crc.value());
}

struct Published
{
    std::uint32_t id;
    int crc_extra;
    std::size_t base_length, full_length;
};

/// The protocol's own table: the checksums are made of every field's name and type.
TEST(MavlinkMessages, EqualTheProtocolsTable)
{
    const std::vector<Published> table{
        {0, 50, 9, 9},     {26, 170, 22, 24},   {30, 39, 28, 28},   {32, 185, 28, 28},
        {65, 118, 42, 42}, {69, 243, 11, 30},   {84, 143, 53, 53},  {102, 158, 32, 117},
        {105, 93, 62, 63}, {106, 138, 44, 44},  {111, 34, 16, 18},  {132, 85, 14, 39},
        {253, 83, 51, 54}, {330, 23, 158, 167}, {331, 91, 230, 233}};
    std::size_t found = 0;
    for_each_message(
        [&](const auto& message)
        {
            using Message = std::decay_t<decltype(message)>;
            for (const auto& row : table)
            {
                if (row.id != Message::id) continue;
                ++found;
                EXPECT_EQ(row.crc_extra, crc_extra<Message>()) << Message::name;
                EXPECT_EQ(row.base_length, base_length<Message>()) << Message::name;
                EXPECT_EQ(row.full_length, full_length<Message>()) << Message::name;
            }
        });
    EXPECT_EQ(table.size(), found);
}

TEST(MavlinkFrame, IsLaidOutAsPublished)
{
    // A heartbeat as any ground station sends it; the checksum by hand with MCRF4XX.
    Sender sender{255, 190, 7};
    Heartbeat heartbeat;
    heartbeat.type = 6;
    heartbeat.autopilot = 8;
    heartbeat.system_status = 4;
    const Bytes frame = sender.encode(heartbeat);
    ASSERT_EQ(21u, frame.size());
    const Bytes head(frame.begin(), frame.begin() + 19);
    EXPECT_EQ(Bytes({0xFD, 9, 0, 0, 7, 255, 190, 0, 0, 0, 0, 0, 0, 0, 6, 8, 0, 4, 3}), head);
    EXPECT_EQ(8, sender.sequence);
}

TEST(MavlinkFrame, CutsZerosOffItsEndButKeepsOneByte)
{
    Sender sender;
    EXPECT_EQ(10u + 1 + 2, sender.encode(Attitude()).size());
    Timesync sync;
    sync.ts1 = 1;  // bytes 8 to 15; only the first of them is not zero
    EXPECT_EQ(10u + 9 + 2, sender.encode(sync).size());
}

template <class Message>
Message read_back(const Message& message)
{
    Sender sender;
    MavlinkReader reader;
    reader.push(sender.encode(message));
    const auto frame = reader.take();
    EXPECT_TRUE(frame);
    return frame ? message_of<Message>(*frame).value() : Message();
}

TEST(MavlinkReader, GivesBackWhatWasSent)
{
    Odometry odometry;
    odometry.time_usec = 1'700'000'000'123'456;
    odometry.x = 1.5f;
    odometry.q = {0.5f, -0.5f, 0.5f, -0.5f};
    odometry.pose_covariance[20] = 0.25f;
    odometry.child_frame_id = 12;
    odometry.reset_counter = 3;
    odometry.quality = -1;
    const auto back = read_back(odometry);
    EXPECT_EQ(odometry.time_usec, back.time_usec);
    EXPECT_EQ(odometry.q, back.q);
    EXPECT_EQ(odometry.pose_covariance, back.pose_covariance);
    EXPECT_EQ(12, back.child_frame_id);
    EXPECT_EQ(3, back.reset_counter);
    EXPECT_EQ(-1, back.quality);

    Timesync sync;
    sync.tc1 = -5;
    sync.ts1 = 9'000'000'000;
    EXPECT_EQ(-5, read_back(sync).tc1);
    EXPECT_EQ(9'000'000'000, read_back(sync).ts1);
}

TEST(MavlinkReader, FillsWhatOldPeersLeaveOutWithZeros)
{
    const Bytes base{1, 0, 2, 0, 3, 0, 4, 0, 5, 0, 6};  // MANUAL_CONTROL without its extensions
    MavlinkReader reader;
    reader.push(encode_frame({69, 0, 1, 1, base}, 243));
    const auto frame = reader.take();
    ASSERT_TRUE(frame);
    const auto manual = message_of<ManualControl>(*frame);
    EXPECT_EQ(4, manual->r);
    EXPECT_EQ(6, manual->target);
    EXPECT_EQ(0, manual->buttons2);
}

TEST(MavlinkReader, SkipsDamagedFramesAndCountsThem)
{
    Sender sender;
    Attitude attitude;
    attitude.yaw = 1;
    const Bytes good = sender.encode(attitude);
    for (std::size_t place = 1; place < good.size(); ++place)
    {
        Bytes bytes = good;
        bytes[place] ^= 0x20;
        for (int i = 0; i < 20; ++i) bytes.insert(bytes.end(), good.begin(), good.end());
        MavlinkReader reader;
        reader.push(bytes);
        std::size_t frames = 0;
        while (reader.take()) ++frames;
        EXPECT_GE(frames, 10u) << "byte " << place;  // a length that lies hides a few
        EXPECT_LE(frames, 20u);
        EXPECT_GE(reader.counters().damaged + reader.counters().unknown, 1u) << "byte " << place;
    }
}

TEST(MavlinkReader, WaitsForTheRestOfATruncatedFrame)
{
    Sender sender;
    const Bytes frame = sender.encode(Odometry());
    MavlinkReader reader;
    for (const auto byte : frame)
    {
        EXPECT_FALSE(reader.take());
        reader.push({&byte, 1});
    }
    EXPECT_TRUE(reader.take());
}

TEST(MavlinkReader, PassesOverUnknownKindsWhole)
{
    Sender sender;
    Bytes bytes = encode_frame({9000, 0, 1, 1, Bytes(40, 0xFD)}, 77);
    const Bytes known = sender.encode(Heartbeat());
    bytes.insert(bytes.end(), known.begin(), known.end());
    MavlinkReader reader;
    reader.push(bytes);
    EXPECT_TRUE(reader.take());
    EXPECT_EQ(1u, reader.counters().unknown);
    EXPECT_EQ(0u, reader.counters().bytes_skipped);
}

TEST(MavlinkReader, FindsEveryFrameBetweenNoise)
{
    std::mt19937 random(11);
    Sender sender;
    Bytes bytes;
    for (int i = 0; i < 500; ++i)
    {
        const Bytes frame = sender.encode(Heartbeat());
        bytes.insert(bytes.end(), frame.begin(), frame.end());
        for (auto noise = random() % 30; noise > 0; --noise)
            bytes.push_back(static_cast<std::uint8_t>(random() % 0xFD));  // no false start
    }
    MavlinkReader reader;
    std::size_t frames = 0;
    for (const auto byte : bytes)
    {
        reader.push({&byte, 1});
        while (reader.take()) ++frames;
    }
    EXPECT_EQ(500u, frames);
    EXPECT_EQ(0u, reader.counters().lost);
}

TEST(MavlinkReader, CountsWhatTheSequenceMisses)
{
    Sender sender;
    MavlinkReader reader;
    reader.push(sender.encode(Heartbeat()));
    static_cast<void>(sender.encode(Heartbeat()));
    static_cast<void>(sender.encode(Heartbeat()));
    reader.push(sender.encode(Heartbeat()));
    EXPECT_EQ(2u, reader.counters().lost);
}
}  // namespace
}  // namespace rtob

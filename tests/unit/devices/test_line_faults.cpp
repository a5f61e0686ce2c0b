// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <rtob/devices/line_faults.h>

#include <set>

namespace rtob::devices
{
namespace
{
struct FakeDevice : EmulatedDevice
{
    void receive(const Packet&, double) override {}
    std::vector<Packet> send(double) override { return {}; }
    void restart() override { ++restarts; }
    void breakDown() override { ++breakdowns; }

    int restarts = 0, breakdowns = 0;
};

class LineFaultsTest : public testing::Test
{
 protected:
    void inject(LineFault fault) { faults_.inject(fault, device_, 10, 0.5); }
    [[nodiscard]] Packet arriving(double now_s) { return faults_.arriving(packet_, now_s); }
    [[nodiscard]] std::size_t different(const Packet& other) const
    {
        std::size_t count = 0;
        for (std::size_t i = 0; i < packet_.size(); ++i) count += packet_[i] != other[i];
        return count;
    }

    FakeDevice device_;
    LineFaults faults_;
    Packet packet_ = Packet(100, 7);
};

TEST_F(LineFaultsTest, WithoutFaultsPacketsArriveAsTheyAre)
{
    EXPECT_EQ(packet_, arriving(10));
    EXPECT_TRUE(faults_.isHeard(10));
    EXPECT_FALSE(faults_.isUnplugged(10));
}

TEST_F(LineFaultsTest, FaultsOfBytesSpoilOnePacketEach)
{
    inject(LineFault::WrongChecksum);
    EXPECT_EQ(1u, different(arriving(11)));
    inject(LineFault::HalfPacket);
    EXPECT_EQ(Packet(50, 7), arriving(11));
    inject(LineFault::Garbage);
    const Packet longer = arriving(11);
    EXPECT_GT(longer.size(), packet_.size());
    EXPECT_EQ(0u, different(longer));
    EXPECT_EQ(packet_, arriving(11));
}

TEST_F(LineFaultsTest, AStallIsSilentForItsTime)
{
    inject(LineFault::Stall);
    EXPECT_TRUE(arriving(10.4).empty());
    EXPECT_EQ(packet_, arriving(10.6));
}

TEST_F(LineFaultsTest, AtTheWrongSpeedNothingIsUnderstood)
{
    inject(LineFault::WrongBaud);
    EXPECT_FALSE(faults_.isHeard(10.4));
    EXPECT_GT(different(arriving(10.4)), 80u);  // of 100, each the same by chance in 1 of 256
    EXPECT_TRUE(faults_.isHeard(10.6));
    EXPECT_EQ(packet_, arriving(10.6));
}

TEST_F(LineFaultsTest, UnpluggedTheDeviceLosesItsPower)
{
    inject(LineFault::Unplug);
    EXPECT_TRUE(faults_.isUnplugged(10.4));
    EXPECT_FALSE(faults_.isUnplugged(10.6));
    EXPECT_EQ(1, device_.restarts);
}

TEST_F(LineFaultsTest, FaultsOfTheDeviceAreItsOwn)
{
    inject(LineFault::Restart);
    EXPECT_EQ(1, device_.restarts);
    inject(LineFault::ErrorState);
    EXPECT_EQ(1, device_.breakdowns);
    EXPECT_EQ(packet_, arriving(10));
}

TEST(LineFault, EachHasAName)
{
    std::set<std::string_view> names;
    for (const auto fault : all_line_faults) names.insert(name_of(fault));
    EXPECT_EQ(all_line_faults.size(), names.size());
}
}  // namespace
}  // namespace rtob::devices

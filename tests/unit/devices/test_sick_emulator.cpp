// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <rtob/devices/sick_emulator.h>

#include <cmath>
#include <sstream>

namespace rtob::devices
{
namespace
{
/// 1 m to the right, 3 m ahead, 5 m to the left; 20 m, too far, behind.
double room(double bearing_rad, double)
{
    if (std::abs(bearing_rad) > 2.3) return 20;
    return 3 + bearing_rad * 4 / M_PI;
}

Packet telegram(const std::string& command)
{
    const std::string framed = "\x02" + command + "\x03";
    return {framed.begin(), framed.end()};
}

std::vector<std::string> words_of(const Packet& packet)
{
    EXPECT_EQ(2, packet.front());
    EXPECT_EQ(3, packet.back());
    std::istringstream text(std::string(packet.begin() + 1, packet.end() - 1));
    std::vector<std::string> words;
    for (std::string word; text >> word;) words.push_back(word);
    return words;
}

TEST(SickEmulator, GivesItsLastScanWhenAsked)
{
    SickEmulator device(room);
    device.receive(telegram("sRN LMDscandata"), 100);
    const auto packets = device.send(100);
    ASSERT_EQ(1u, packets.size());
    const auto words = words_of(packets[0]);
    ASSERT_GT(words.size(), 26u + 811u);
    EXPECT_EQ("sRA", words[0]);
    EXPECT_EQ("LMDscandata", words[1]);
    EXPECT_EQ("DIST1", words[20]);
    EXPECT_EQ("FFF92230", words[23]);  // -45 degrees in 1/10000, in two's complement
    EXPECT_EQ("32B", words[25]);       // 811
    const auto range_mm = [&](std::size_t beam)
    { return std::stoi(words[26 + beam], nullptr, 16); };
    EXPECT_EQ(0, range_mm(0));                  // -135 degrees: too far
    EXPECT_EQ(1000, range_mm(3 * 45));          // -90 degrees, the right
    EXPECT_EQ(3000, range_mm(3 * 135));         // ahead
    EXPECT_EQ(5000, range_mm(3 * (135 + 90)));  // the left
}

TEST(SickEmulator, SendsEachScanWhereThatWasAskedFor)
{
    SickEmulator device(room);
    device.receive(telegram("sEN LMDscandata 1"), 100);
    EXPECT_EQ(1u, device.send(100).size());  // the answer
    std::size_t scans = 0;
    for (int ms = 0; ms < 1000; ms += 5) scans += device.send(100 + 0.001 * ms).size();
    EXPECT_NEAR(15, static_cast<double>(scans), 1);
}

TEST(SickEmulator, AnLmsTellsThatItMeasuresAndSeesFinerAndFarther)
{
    SickEmulator device(room, model_lms111());
    device.breakDown();
    for (const char* command :
         {"sMN LMCstartmeas", "sRN STlms", "sWN LMDscandatacfg 01 00 0 1 0", "sRN LMDscandata"})
        device.receive(telegram(command), 100);
    const auto packets = device.send(100);
    ASSERT_EQ(4u, packets.size());
    EXPECT_EQ("7", words_of(packets[1])[2]);
    EXPECT_EQ("sWA", words_of(packets[2])[0]);
    const auto words = words_of(packets[3]);
    ASSERT_GT(words.size(), 26u + 1081u);
    EXPECT_EQ("9C4", words[24]);                    // 0.25 degrees in 1/10000
    EXPECT_EQ("439", words[25]);                    // 1081
    EXPECT_EQ("BB8", words[26 + 4 * 135]);          // 3 m ahead
    EXPECT_EQ("1388", words[26 + 4 * (135 + 90)]);  // 5 m to the left
    EXPECT_EQ("9C4", words[16]);                    // 25 turns a second, in 1/100
}

TEST(SickEmulator, ABrokenOneRefusesUntilItIsSetUpAnew)
{
    SickEmulator device(room);
    device.breakDown();
    device.receive(telegram("sRN LMDscandata"), 100);
    EXPECT_EQ("sFA", words_of(device.send(100).at(0))[0]);
    device.receive(telegram("sEN LMDscandata 1"), 100);
    device.receive(telegram("sRN LMDscandata"), 100);
    EXPECT_EQ("sRA", words_of(device.send(100).at(1))[0]);
}

TEST(SickEmulator, TakesTelegramsInPiecesAndPassesOverRubbish)
{
    SickEmulator device(room);
    device.receive({'x', 3, 7, 2, 's', 'R'}, 100);
    EXPECT_TRUE(device.send(100).empty());
    device.receive({'I', 'O', 3, 0}, 100);
    EXPECT_EQ(1u, device.send(100).size());
}
}  // namespace
}  // namespace rtob::devices

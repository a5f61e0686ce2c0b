// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/core/spread.h>
#include <rtob/devices/device_on_tcp.h>
#include <rtob/devices/hokuyo_emulator.h>
#include <rtob/devices/sick_emulator.h>

#include <iomanip>
#include <random>
#include <sstream>

#include "onboard_capture.h"

/// `./dev flights faults kills` runs these at length: RTOB_FAULTS and RTOB_KILLS say how often.
namespace rtob::test
{
namespace
{
using devices::DeviceOnTcp;
using devices::LineFault;
using devices::RplidarOnTerminal;

TEST_F(Onboard, LosesAtMostTheLastSecondToKillMinus9)
{
    const RplidarOnTerminal laser(laserPort(), devices::model_a2(), house_from(unix_time_s()));
    const std::string ini = write();
    std::mt19937 random(4);
    std::vector<float> missing_s, starts_s;
    const int kills = times_of("RTOB_KILLS", 3);
    for (int i = 0; i < kills; ++i)
    {
        const double begin_s = unix_time_s();
        RunningProgram program(RTOB_ONBOARD, {ini});
        ASSERT_TRUE(states_.waitForMore(1)) << "start " << i;
        starts_s.push_back(static_cast<float>(unix_time_s() - begin_s));
        ASSERT_TRUE(states_.waitForMore(9)) << "start " << i;
        wait_s(0.001 * static_cast<double>(random() % 1000));
        program.send(SIGKILL);
        EXPECT_EQ(-1, program.wait().exit_code);
        wait_s(0.05);  // the last word may be on its way
        const double last_s = states_.states().back()["stamp_s"];
        const auto capture = read_capture(logged(flights().back()));
        ASSERT_FALSE(capture.scans.empty()) << "kill " << i;
        EXPECT_EQ("", capture.damage) << "kill " << i;
        missing_s.push_back(static_cast<float>(last_s - capture.scans.back()));
        std::filesystem::remove_all(flights().back());
    }
    std::cout << kills << " times kill -9: missing are the last " << percentile(missing_s, 0.5)
              << " s p50, " << percentile(missing_s, 1) << " s at most; first pose "
              << percentile(starts_s, 0.5) << " s after the start p50, " << percentile(starts_s, 1)
              << " s at most\n";
    EXPECT_LT(percentile(missing_s, 1), 1.0);
}

/// A fault, and when it was over: from then on scans may be expected.
struct Injected
{
    std::string label;
    LineFault fault;
    double over_s;
};

/// How long it took until the first scan after each fault; those that the next fault of the same
/// device followed before are left out.
std::map<std::string, std::vector<float>> recoveries(
    const std::vector<Injected>& faults, const CaptureContents& capture)
{
    std::map<std::string, std::vector<float>> times_s;
    for (auto fault = faults.begin(); fault != faults.end(); ++fault)
    {
        const auto& scans = capture.scans_of.at(fault->label);
        const auto scan = std::lower_bound(scans.begin(), scans.end(), fault->over_s);
        const auto next = std::find_if(
            fault + 1, faults.end(),
            [&](const auto& other) { return other.label == fault->label; });
        if (scan == scans.end() || (next != faults.end() && next->over_s < *scan)) continue;
        times_s[fault->label + ", " + std::string(name_of(fault->fault))].push_back(
            static_cast<float>(*scan - fault->over_s));
    }
    return times_s;
}

void print(const std::map<std::string, std::vector<float>>& times_s)
{
    std::ostringstream text;
    text << std::fixed << std::setprecision(2);
    for (const auto& [what, times] : times_s)
        text << what << ": " << times.size() << " times, first scan after "
             << percentile(times, 0.5) << " s p50, " << percentile(times, 1) << " s at most\n";
    std::cout << text.str();
}

/// Three lasers and an autopilot, and whatever can happen to their lines.
class FaultyLines
{
 public:
    FaultyLines(const std::string& port, double takeoff_s)
        : rplidar_(port, devices::model_a2(), house_from(takeoff_s)),
          hokuyo_(std::make_unique<devices::HokuyoEmulator>(house_from(takeoff_s))),
          sick_(std::make_unique<devices::SickEmulator>(house_from(takeoff_s)))
    {
    }

    [[nodiscard]] std::string sections() const
    {
        return "[Second]\ndriver = CHokuyoURG\nprocess_rate = 200\nsensorLabel = HOKUYO\n"
               "IP_DIR = 127.0.0.1\nPORT_DIR = " +
               std::to_string(hokuyo_.port()) +
               "\n[Third]\ndriver = CSICKTim561Eth\nprocess_rate = 15\nsensorLabel = SICK\n"
               "ip_address = 127.0.0.1\nTCP_port = " +
               std::to_string(sick_.port()) +
               "\n[Autopilot]\nlink = udp:127.0.0.1:" + std::to_string(autopilot_.port()) +
               "\n[Sensor]\nlabels = LASER\n";
    }

    /// Any fault on any line. MRPT's drivers need seconds to begin anew: their turn comes less
    /// often.
    void injectAny(std::mt19937& random)
    {
        const auto fault = devices::all_line_faults[random() % devices::all_line_faults.size()];
        const double duration_s = 0.05 + 0.001 * static_cast<double>(random() % 300);
        const auto whose = random() % 20;
        if (whose == 0)
            inject(sick_, "SICK", fault, duration_s);
        else if (whose < 3)
            inject(hokuyo_, "HOKUYO", fault, duration_s);
        else if (whose < 5)
            autopilot_.sendGarbage(1 + random() % 400);
        else
            inject(rplidar_, "LASER", fault, duration_s);
    }
    [[nodiscard]] const std::vector<Injected>& injected() const { return injected_; }

 private:
    template <class Line>
    void inject(Line& line, const char* label, LineFault fault, double duration_s)
    {
        line.inject(fault, duration_s);
        const bool takes_time = fault == LineFault::Stall || fault == LineFault::Unplug ||
                                fault == LineFault::WrongBaud;
        injected_.push_back({label, fault, unix_time_s() + (takes_time ? duration_s : 0)});
    }

    RplidarOnTerminal rplidar_;
    DeviceOnTcp hokuyo_, sick_;
    EmulatedAutopilot autopilot_;
    std::vector<Injected> injected_;
};

TEST_F(Onboard, SurvivesRandomFaults)
{
    FaultyLines lines(laserPort(), unix_time_s());
    RunningProgram program(RTOB_ONBOARD, {write(lines.sections())});
    ASSERT_TRUE(states_.waitForMore(20));
    std::mt19937 random(9);
    const int faults = times_of("RTOB_FAULTS", 40);
    for (int i = 0; i < faults; ++i)
    {
        lines.injectAny(random);
        // One after the other, or several at once.
        if (random() % 2 == 0)
            EXPECT_TRUE(states_.waitForMore(3));
        else
            wait_s(0.001 * static_cast<double>(random() % 500));
    }
    EXPECT_TRUE(states_.waitForMore(50)) << "scans come again at the end";
    program.send(SIGTERM);
    const auto result = program.wait();
    EXPECT_NE(-1, result.exit_code) << result.err;
    const std::string flight = flights().back();
    const auto capture = read_capture(logged(flight));
    EXPECT_EQ("", capture.damage);
    const auto summary = summary_of(flight);
    EXPECT_EQ(capture.poses.size(), summary["scans"]["localised"].get<std::size_t>())
        << "nothing that was captured is lost";
    EXPECT_EQ(0u, summary["capture"]["left_out"].get<std::size_t>());
    EXPECT_EQ("", summary["sensors"][0]["last_problem"].get<std::string>());
    expectTheSamePosesAgain(flight);
    const auto times_s = recoveries(lines.injected(), capture);
    EXPECT_FALSE(times_s.empty());
    std::cout << faults << " faults, " << capture.scans.size() << " scans captured\n";
    print(times_s);
    std::cout << result.out;
}
}  // namespace
}  // namespace rtob::test

// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/devices/rplidar_on_terminal.h>
#include <rtob/drivers/byte_link.h>
#include <rtob/drivers/mavlink_codec.h>
#include <rtob/drivers/unix_time.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <memory>
#include <mutex>
#include <random>
#include <string>
#include <thread>
#include <vector>

#include "house.h"
#include "loopback_port.h"
#include "program.h"
#include "state_listener.h"

/// A flight without hardware: an emulated laser that moves through a house, an emulated autopilot,
/// and rtob-onboard between them. RTOB_ONBOARD names the program.
namespace rtob::test
{
inline void wait_s(double seconds)
{
    std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
}

/// How often a long test repeats what a short one does a few times.
[[nodiscard]] inline int times_of(const char* variable, int otherwise)
{
    const char* text = std::getenv(variable);
    return text != nullptr ? std::atoi(text) : otherwise;
}

/// The figure of eight through both rooms, a lap in 80 s: about 0.25 m/s.
[[nodiscard]] inline Pose2 flight_pose(double seconds)
{
    const double a = 2 * 3.14159265358979323846 * seconds / 80;
    return {
        6 + 4 * std::cos(a), 3 + 1.5 * std::sin(2 * a),
        std::atan2(3 * std::cos(2 * a), -4 * std::sin(a))};
}

/// A scan from this place of house.h's own drive, at another time.
[[nodiscard]] inline mrpt::obs::CObservation2DRangeScan scan_in_house_at(int place, double stamp_s)
{
    auto scan = scan_in_house(place);
    scan.timestamp = mrpt::Clock::fromDouble(stamp_s);
    return scan;
}

/// A flight that begins when it is told to: until then the vehicle stands, as it should for the
/// first scans. It reaches its speed within two seconds. Copies are of the same flight.
class Takeoff
{
 public:
    void go() const { *takeoff_s_ = unix_time_s() + 0.2; }  // no beam was taken then
    [[nodiscard]] Pose2 pose(double time_s) const
    {
        constexpr double ramp_s = 2;
        const double flown_s = std::max(0.0, time_s - *takeoff_s_);
        return flight_pose(
            flown_s < ramp_s ? flown_s * flown_s / (2 * ramp_s) : flown_s - ramp_s / 2);
    }

 private:
    std::shared_ptr<std::atomic<double>> takeoff_s_ = std::make_shared<std::atomic<double>>(1e18);
};

/// What the laser sees at any moment; it sits in the vehicle's middle.
template <class PoseAt>
[[nodiscard]] devices::RangeSource house_seen_from(PoseAt pose_at)
{
    return [world = house(), pose_at](double bearing_rad, double time_s)
    {
        const Pose2 pose = pose_at(time_s);
        return world.range(pose.x, pose.y, pose.yaw + bearing_rad);
    };
}
[[nodiscard]] inline devices::RangeSource house_from(const Takeoff& takeoff)
{
    return house_seen_from([takeoff](double time_s) { return takeoff.pose(time_s); });
}
/// In flight already.
[[nodiscard]] inline devices::RangeSource house_from(double begin_s)
{
    return house_seen_from([begin_s](double time_s) { return flight_pose(time_s - begin_s); });
}

/// A flight controller on a UDP port: it beats, tells its attitude, answers questions for the time,
/// and keeps the poses that it is told.
class EmulatedAutopilot
{
 public:
    EmulatedAutopilot()
        : port_(free_udp_port()),
          link_(open_link("udpin:127.0.0.1:" + std::to_string(port_), 0)),
          thread_([this] { live(); })
    {
    }
    ~EmulatedAutopilot()
    {
        ends_ = true;
        thread_.join();
    }

    [[nodiscard]] int port() const { return port_; }
    [[nodiscard]] std::vector<mavlink::Odometry> poses() const
    {
        const std::lock_guard lock(mutex_);
        return poses_;
    }
    [[nodiscard]] std::vector<std::string> texts() const
    {
        const std::lock_guard lock(mutex_);
        return texts_;
    }
    [[nodiscard]] std::size_t heartbeats() const { return heartbeats_; }
    /// So many bytes that mean nothing.
    void sendGarbage(std::size_t bytes)
    {
        Bytes garbage(bytes);
        for (auto& byte : garbage) byte = static_cast<std::uint8_t>(random_());
        const std::lock_guard lock(mutex_);
        link_->write(garbage);
    }

 private:
    void live()
    {
        MavlinkReader reader;
        while (!ends_)
        {
            reader.push(link_->read(std::chrono::milliseconds(20)));
            while (const auto frame = reader.take()) take(*frame);
            mavlink::Attitude attitude;
            attitude.time_boot_ms = static_cast<std::uint32_t>(1000 * sinceBoot());
            link_->write(sender_.encode(attitude));
            link_->write(sender_.encode(mavlink::Heartbeat()));
        }
    }

    void take(const MavlinkFrame& frame)
    {
        const std::lock_guard lock(mutex_);
        if (const auto pose = mavlink::message_of<mavlink::Odometry>(frame))
            poses_.push_back(*pose);
        if (const auto text = mavlink::message_of<mavlink::Statustext>(frame))
            texts_.emplace_back(text->text.data(), strnlen(text->text.data(), 50));
        heartbeats_ += frame.id == mavlink::Heartbeat::id;
        const auto sync = mavlink::message_of<mavlink::Timesync>(frame);
        if (sync && sync->tc1 == 0)
            link_->write(sender_.encode(
                mavlink::Timesync{std::llround(1e9 * sinceBoot()), sync->ts1, 0, 0}));
    }
    [[nodiscard]] double sinceBoot() const { return unix_time_s() - boot_s_; }

    double boot_s_ = unix_time_s() - 1000;
    int port_;
    std::unique_ptr<ByteLink> link_;
    mavlink::Sender sender_{1, 1, 0};
    std::mt19937 random_{3};
    mutable std::mutex mutex_;
    std::vector<mavlink::Odometry> poses_;
    std::vector<std::string> texts_;
    std::atomic<std::size_t> heartbeats_{0};
    std::atomic<bool> ends_{false};
    std::thread thread_;
};

/// A folder with a configuration for a laser, whose poses are heard as they come.
class FlightFixture
{
 public:
    [[nodiscard]] std::string laserPort() const { return folder_.file("ttyLaser"); }
    /// @param laser the section of the laser, without its label
    [[nodiscard]] std::string writeFor(const std::string& laser, const std::string& more = "") const
    {
        return folder_.write(
            "onboard.ini", "[Onboard]\noutput_folder = " + folder_.file("flights") +
                               "\n[StateStream]\nudp_port = " + std::to_string(states_.port()) +
                               "\n[Laser]\nsensorLabel = LASER\n" + laser + "\n" + more);
    }
    /// For an emulated RPLidar A2.
    [[nodiscard]] std::string write(const std::string& more = "") const
    {
        return writeFor(
            "driver = RtobRplidar\nprocess_rate = 200\nCOM_baudRate = 115200\nCOM_port_LIN = " +
                laserPort(),
            more);
    }
    /// The folders of the flights so far, in order.
    [[nodiscard]] std::vector<std::string> flights() const
    {
        std::vector<std::string> folders;
        std::error_code none_yet;
        for (const auto& entry :
             std::filesystem::directory_iterator(folder_.file("flights"), none_yet))
            folders.push_back(entry.path());
        std::sort(folders.begin(), folders.end());
        return folders;
    }

    TemporaryFolder folder_;
    StateListener states_;
};
}  // namespace rtob::test

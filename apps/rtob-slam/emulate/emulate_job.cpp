// SPDX-License-Identifier: BSD-3-Clause
#include "emulate/emulate_job.h"

#include <mrpt/obs/CObservation2DRangeScan.h>
#include <rtob/devices/device_on_tcp.h>
#include <rtob/devices/hokuyo_emulator.h>
#include <rtob/devices/recorded_scans.h>
#include <rtob/devices/rplidar_on_terminal.h>
#include <rtob/devices/sick_emulator.h>
#include <rtob/io/log_reader.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cmath>
#include <random>
#include <thread>

namespace rtob
{
namespace
{
using Clock = std::chrono::steady_clock;
using devices::RangeSource;
using mrpt::obs::CObservation2DRangeScan;

/// Bearings as the vehicle sees them: the device's front is the vehicle's.
devices::RecordedScan recorded(const CObservation2DRangeScan& scan)
{
    const auto bearing_rad = [&](std::size_t beam)
    {
        const double angle_rad = scan.getScanAngle(beam);
        const auto direction =
            scan.sensorPose.rotateVector({std::cos(angle_rad), std::sin(angle_rad), 0});
        return std::atan2(direction.y, direction.x);
    };
    devices::RecordedScan recorded;
    recorded.time_s = mrpt::Clock::toDouble(scan.timestamp);
    recorded.first_rad = bearing_rad(0);
    recorded.step_rad = std::remainder(bearing_rad(1) - recorded.first_rad, 2 * M_PI);
    for (std::size_t i = 0; i < scan.getScanSize(); ++i)
        recorded.ranges_m.push_back(scan.getScanRangeValidity(i) ? scan.getScanRange(i) : 0);
    return recorded;
}

/// The scans of the log's first laser.
std::vector<devices::RecordedScan> scans_of(const std::string& file)
{
    std::vector<devices::RecordedScan> scans;
    std::string label;
    const auto log = open_log(file);
    while (const auto entry = log->next())
    {
        const auto* scan = dynamic_cast<const CObservation2DRangeScan*>(entry->observation.get());
        if (scan == nullptr || scan->getScanSize() < 2) continue;
        if (scans.empty()) label = scan->sensorLabel;
        if (scan->sensorLabel == label) scans.push_back(recorded(*scan));
    }
    if (scans.empty()) throw std::runtime_error(file + " holds no laser scans.");
    return scans;
}

double unix_now_s()
{
    return std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch())
        .count();
}

/// From now on, and from the beginning again when the log has ended.
RangeSource played(const std::string& file)
{
    auto scans = scans_of(file);
    const double begin_s = unix_now_s();
    const double length_s = std::max(0.1, scans.back().time_s - scans.front().time_s);
    return [begin_s, length_s, ranges = devices::play_scans(std::move(scans), begin_s)](
               double bearing_rad, double time_s)
    { return ranges(bearing_rad, begin_s + std::fmod(time_s - begin_s, length_s)); };
}

/// An emulated device on its line.
struct Line
{
    std::string keys;  ///< for a section of rtob-onboard
    std::function<void(devices::LineFault, double)> inject;
};

Line rplidar(const devices::RplidarModel& model, const EmulateJob& job)
{
    const std::string port = job.port.empty() ? "ttyLaser" : job.port;
    const auto line = std::make_shared<devices::RplidarOnTerminal>(port, model, played(job.log));
    return {"driver = RtobRplidar, COM_port_LIN = " + port, [line](auto fault, double duration_s) {
                line->inject(fault, duration_s);
            }};
}

int tcp_port(const std::string& text)
{
    if (text.empty()) return 0;
    int port = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), port);
    if (error == std::errc() && end == text.data() + text.size() && port >= 1 && port <= 65535)
        return port;
    throw std::runtime_error("--port " + text + ": must be a TCP port, 1 to 65535.");
}

template <class Device, class... Model>
Line on_tcp(const std::string& keys, const EmulateJob& job, const Model&... model)
{
    const auto line = std::make_shared<devices::DeviceOnTcp>(
        std::make_unique<Device>(played(job.log), model...), tcp_port(job.port));
    return {keys + std::to_string(line->port()), [line](auto fault, double duration_s) {
                line->inject(fault, duration_s);
            }};
}

Line line_of(const EmulateJob& job)
{
    if (job.device == "rplidar-a1") return rplidar(devices::model_a1(), job);
    if (job.device == "rplidar-a2") return rplidar(devices::model_a2(), job);
    if (job.device == "rplidar-a3") return rplidar(devices::model_a3(), job);
    if (job.device == "rplidar-s2") return rplidar(devices::model_s2(), job);
    if (job.device == "hokuyo")
        return on_tcp<devices::HokuyoEmulator>(
            "driver = CHokuyoURG, IP_DIR = 127.0.0.1, PORT_DIR = ", job);
    if (job.device == "sick-lms111")
        return on_tcp<devices::SickEmulator>(
            "driver = CLMS100Eth, pose_roll = 180, ip_address = 127.0.0.1, TCP_port = ", job,
            devices::model_lms111());
    return on_tcp<devices::SickEmulator>(
        "driver = CSICKTim561Eth, pose_roll = 180, ip_address = 127.0.0.1, TCP_port = ", job);
}
}  // namespace

std::vector<std::string> emulated_devices()
{
    return {"rplidar-a1", "rplidar-a2",  "rplidar-a3", "rplidar-s2",
            "hokuyo",     "sick-tim561", "sick-lms111"};
}

void emulate(const EmulateJob& job, std::ostream& out, const std::function<bool()>& stop)
{
    const Line line = line_of(job);
    out << job.device << " plays " << job.log << ": " << line.keys << std::endl;
    std::mt19937 random;
    const auto begin = Clock::now();
    const auto since = [](Clock::time_point time)
    { return std::chrono::duration<double>(Clock::now() - time).count(); };
    auto last_fault = begin;
    while (!stop() && (job.seconds == 0 || since(begin) < job.seconds))
    {
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
        if (job.faults_every_s == 0 || since(last_fault) < job.faults_every_s) continue;
        last_fault = Clock::now();
        const auto fault = devices::all_line_faults[random() % devices::all_line_faults.size()];
        out << "fault: " << name_of(fault) << std::endl;
        line.inject(fault, 0.5);
    }
}
}  // namespace rtob

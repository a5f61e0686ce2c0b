// SPDX-License-Identifier: BSD-3-Clause
#include "check.h"

#include <mrpt/obs/CObservation2DRangeScan.h>
#include <rtob/drivers/unix_time.h>
#include <rtob/io/scan_timing.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <iomanip>
#include <map>
#include <thread>

#include "autopilot_thread.h"
#include "sensor_runner.h"
#include "state_stream.h"

namespace rtob
{
namespace
{
using Clock = std::chrono::steady_clock;
constexpr std::chrono::seconds kListening{6};
/// Some of MRPT's drivers take their time to begin: CLMS100Eth 15 s.
constexpr std::chrono::seconds kStarting{25};
constexpr double kOddStamp_s = 1;

/// What was heard under one label.
struct Heard
{
    std::uint64_t count = 0, stamps_back = 0, odd_stamps = 0;
    Clock::time_point first{}, last{};
    double last_stamp_s = 0;
    std::size_t beams = 0, valid = 0;
    double aperture_deg = 0, max_range_m = 0, sweep_s = 0;
};

class Ear
{
 public:
    void hear(const mrpt::obs::CObservation& observation)
    {
        const std::lock_guard lock(mutex_);
        if (const auto timing = read_timing_record(observation))
        {
            sweep_s_ = timing->sweep_s;
            return;
        }
        Heard& heard = heard_[observation.sensorLabel];
        const double stamp_s = mrpt::Clock::toDouble(observation.timestamp);
        heard.stamps_back += heard.count > 0 && stamp_s < heard.last_stamp_s;
        heard.odd_stamps += std::abs(stamp_s - unix_time_s()) > kOddStamp_s;
        heard.last_stamp_s = stamp_s;
        heard.last = Clock::now();
        if (heard.count++ == 0) heard.first = heard.last;
        if (const auto* scan =
                dynamic_cast<const mrpt::obs::CObservation2DRangeScan*>(&observation))
            lookAt(*scan, heard);
    }
    [[nodiscard]] std::map<std::string, Heard> all() const
    {
        const std::lock_guard lock(mutex_);
        return heard_;
    }

 private:
    void lookAt(const mrpt::obs::CObservation2DRangeScan& scan, Heard& heard) const
    {
        heard.beams = scan.getScanSize();
        heard.aperture_deg = scan.aperture * 180 / M_PI;
        heard.max_range_m = scan.maxRange;
        heard.sweep_s = sweep_s_;
        heard.valid = 0;
        for (std::size_t i = 0; i < heard.beams; ++i) heard.valid += scan.getScanRangeValidity(i);
    }

    mutable std::mutex mutex_;
    std::map<std::string, Heard> heard_;
    double sweep_s_ = 0;
};

bool tell(std::ostream& out, bool ok, const std::string& what)
{
    out << (ok ? "ok    " : "FAIL  ") << what << std::endl;
    return ok;
}

bool tell_heard(std::ostream& out, const std::string& label, const Heard& heard)
{
    const double seconds = std::chrono::duration<double>(heard.last - heard.first).count();
    std::ostringstream text;
    text << std::fixed << std::setprecision(1) << label << ": " << heard.count << " observations";
    if (seconds > 0) text << ", " << static_cast<double>(heard.count - 1) / seconds << " Hz";
    if (heard.beams > 0)
        text << ", " << heard.beams << " beams over " << heard.aperture_deg << " degrees, "
             << heard.valid << " see something, up to " << heard.max_range_m << " m";
    if (heard.sweep_s > 0) text << ", a sweep of " << 1000 * heard.sweep_s << " ms";
    text << "; stamps: " << heard.stamps_back << " step back, " << heard.odd_stamps
         << " are over a second off this computer's clock";
    return tell(out, heard.stamps_back == 0 && heard.odd_stamps == 0, text.str());
}

bool check_port(const SensorSection& section, std::ostream& out)
{
    if (section.port.empty()) return true;
    std::error_code error;
    const auto device = std::filesystem::canonical(section.port, error).string();
    const bool may_use = !error && access(device.c_str(), R_OK | W_OK) == 0;
    return tell(
        out, may_use,
        "[" + section.name + "] port " + section.port +
            (error                    ? ": " + error.message()
             : device == section.port ? ""
                                      : " is " + device) +
            (error || may_use ? "" : ": this user may not read and write it"));
}

std::string autopilot_text(const AutopilotThread::Report& report)
{
    const std::string clocks = report.is_synchronised ? "synchronised" : "not synchronised";
    return (report.is_connected ? "alive, clocks " + clocks : "no heartbeat") + "; " +
           std::to_string(report.counters.frames) + " frames, " +
           std::to_string(report.counters.damaged) + " damaged";
}

bool check_stream(const StateStreamOptions& options, std::ostream& out)
{
    try
    {
        const StateStream stream(options);
        return true;
    }
    catch (const std::exception& error)
    {
        return tell(out, false, error.what());
    }
}

bool is_starting(const std::vector<std::shared_ptr<SensorRunner>>& sensors)
{
    return std::any_of(
        sensors.begin(), sensors.end(),
        [](const auto& sensor)
        {
            const auto report = sensor->report();
            return report.observations == 0 && report.problem.empty();
        });
}

bool check_folder(const std::string& folder, std::ostream& out)
{
    namespace fs = std::filesystem;
    std::error_code error;
    fs::create_directories(folder, error);
    const auto space = fs::space(folder, error);
    const bool can_write = !error && access(folder.c_str(), W_OK) == 0;
    return tell(
        out, can_write && space.available > 100'000'000,
        "output folder " + folder + ": " +
            (error ? error.message() + "; name another one: section [Onboard], key output_folder"
                   : std::string(can_write ? "" : "cannot be written, ") +
                         std::to_string(space.available / 1'000'000) + " MB free"));
}
}  // namespace

bool check_onboard(
    const OnboardConfig& config, const mrpt::config::CConfigFileBase& ini, std::ostream& out,
    const std::function<bool()>& stop)
{
    auto ear = std::make_shared<Ear>();  // shared: a driver may hang and outlive this function
    std::vector<std::shared_ptr<SensorRunner>> sensors;
    for (const auto& section : config.sensors)
        sensors.push_back(SensorRunner::start(
            ini, section, [ear](auto observation) { ear->hear(*observation); }));
    AutopilotThread autopilot(
        config.autopilot, [ear](auto observation) { ear->hear(*observation); });
    out << "Listening for " << kListening.count() << " s ..." << std::endl;
    const auto begin = Clock::now();
    while (!stop() && Clock::now() < begin + (is_starting(sensors) ? kStarting : kListening))
        std::this_thread::sleep_for(std::chrono::milliseconds(50));

    bool ok = check_folder(config.onboard.output_folder, out);
    ok &= check_stream(config.stream, out);
    for (const auto& section : config.sensors) ok &= check_port(section, out);
    for (const auto& sensor : sensors)
    {
        const auto report = sensor->report();
        const std::string device = report.device.empty() ? report.driver : report.device;
        ok &= tell(
            out, report.problem.empty() && report.observations > 0,
            "[" + report.name + "] " + device + ": " +
                (!report.problem.empty()    ? report.problem
                 : report.observations == 0 ? "nothing came"
                                            : "working"));
    }
    for (const auto& [label, heard] : ear->all()) ok &= tell_heard(out, label, heard);
    if (!config.autopilot.link.empty())
    {
        const auto report = autopilot.report();
        ok &= tell(
            out, report.is_connected,
            "autopilot at " + config.autopilot.link + ": " +
                (report.problem.empty() ? autopilot_text(report) : report.problem));
    }
    for (const auto& sensor : sensors) sensor->askToEnd();
    for (const auto& sensor : sensors)
        static_cast<void>(sensor->waitForEnd(std::chrono::seconds(2)));
    out << (ok ? "All is well." : "Not ready: mend what says FAIL; docs/onboard.md has a table.")
        << std::endl;
    return ok;
}
}  // namespace rtob

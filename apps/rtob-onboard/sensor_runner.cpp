// SPDX-License-Identifier: BSD-3-Clause
#include "sensor_runner.h"

#include <mrpt/core/exceptions.h>
#include <mrpt/hwdrivers/C2DRangeFinderAbstract.h>
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/system/COutputLogger.h>
#include <mrpt/system/thread_name.h>
#include <rtob/drivers/back_off.h>
#include <rtob/drivers/register_drivers.h>
#include <rtob/drivers/sensor_status.h>
#include <rtob/drivers/unix_time.h>
#include <rtob/io/scan_timing.h>

#include <algorithm>
#include <regex>
#include <stdexcept>
#include <thread>

namespace rtob
{
namespace
{
using Clock = std::chrono::steady_clock;
using mrpt::hwdrivers::CGenericSensor;

constexpr std::chrono::milliseconds kSensorStep{20};
/// A laser that works is never silent for that long, whatever its driver believes.
constexpr double kLaserSilence_s = 3;
constexpr double kLastingError_s = 1;
/// No driver takes that long to begin: MRPT's for the LMS takes 15 s.
constexpr std::chrono::seconds kHang{20};
/// A laser's quartz that is off by 1e-4 is off by 1 ms after that time.
constexpr double kClockMemory_s = 10;
/// A scan is not held up for longer: the laser's clock stood still.
constexpr double kLongestDelay_s = 10;

/// MRPT's configuration objects are not made for several readers at once.
std::mutex& configuration_mutex()
{
    static std::mutex mutex;
    return mutex;
}
}  // namespace

std::string plain_message(const std::exception& error)
{
    std::string text = error.what();
    if (const auto* mrpt_error = dynamic_cast<const mrpt::ExceptionWithCallBackBase*>(&error))
        text = mrpt_error->originalWhat;
    text.resize(std::min(text.find('\n'), text.size()));
    static const std::regex place_in_mrpt(R"(^\S+:[0-9]+: \[.*?\] )");
    return std::regex_replace(text, place_in_mrpt, "");
}

std::unique_ptr<CGenericSensor> create_quiet_sensor(
    const std::string& driver, const std::string& where)
{
    auto sensor = create_sensor(driver, where);
    if (auto* logger = dynamic_cast<mrpt::system::COutputLogger*>(sensor.get()))
        logger->logging_enable_console_output = false;
    return sensor;
}

std::shared_ptr<SensorRunner> SensorRunner::start(
    const mrpt::config::CConfigFileBase& ini, const SensorSection& section, Sink sink)
{
    const std::shared_ptr<SensorRunner> runner(new SensorRunner(ini, section, std::move(sink)));
    // The thread keeps its runner: a driver that hangs for ever must not lose its ground.
    std::thread([runner] { runner->live(); }).detach();
    return runner;
}

SensorRunner::SensorRunner(
    const mrpt::config::CConfigFileBase& ini, SensorSection section, Sink sink)
    : ini_(ini),
      section_(std::move(section)),
      sink_(std::move(sink)),
      laser_clock_(kClockMemory_s, kLongestDelay_s)
{
    report_.name = section_.name;
    report_.driver = section_.driver;
}

bool SensorRunner::waitForEnd(std::chrono::milliseconds patience) const
{
    const auto end = Clock::now() + patience;
    while (!has_ended_ && Clock::now() < end) std::this_thread::sleep_for(kSensorStep);
    return has_ended_;
}

SensorReport SensorRunner::report() const
{
    const std::lock_guard lock(mutex_);
    SensorReport report = report_;
    if (!has_ended_ && Clock::now() - last_seen_.load() > kHang)
    {
        report.is_working = false;
        report.problem = "its driver hangs; the others go on, restart the program";
    }
    return report;
}

void SensorRunner::live()
{
    constexpr std::size_t longest_name = 15;  // that Linux takes
    mrpt::system::thread_name(section_.name.substr(0, longest_name));
    BackOff back_off;
    while (!ends_)
    {
        const auto observations_before = report().observations;
        try
        {
            serve();
        }
        catch (const std::exception& error)
        {
            const std::lock_guard lock(mutex_);
            report_.is_working = false;
            report_.problem = plain_message(error);
            ++report_.restarts;
        }
        if (report().observations > observations_before) back_off.succeeded();
        back_off.failed(Clock::now());
        pause(back_off.untilNext(Clock::now()));
    }
    has_ended_ = true;
}

/// Until the end, or an exception.
void SensorRunner::serve()
{
    const auto sensor = create_quiet_sensor(section_.driver, "section " + section_.name + ", ");
    {
        const std::lock_guard lock(configuration_mutex());
        sensor->loadConfig(ini_, section_.name);
    }
    sensor->initialize();
    laser_clock_.forget();
    last_observation_ = Clock::now();
    const std::chrono::duration<double> period(1 / std::max(0.1, sensor->getProcessRate()));
    while (!ends_)
    {
        const auto begin = Clock::now();
        last_seen_ = begin;
        sensor->doProcess();
        pass(*sensor);
        noteState(*sensor);
        const auto next = begin + std::chrono::duration_cast<Clock::duration>(period);
        if (const auto now = Clock::now(); now < next) pause(next - now);
    }
}

void SensorRunner::pass(CGenericSensor& sensor)
{
    const bool is_own = dynamic_cast<const TellsStatus*>(&sensor) != nullptr;
    for (const auto& [stamp, object] : sensor.getObservations())
    {
        auto observation = std::dynamic_pointer_cast<mrpt::obs::CObservation>(object);
        if (!observation) continue;
        if (auto* scan = dynamic_cast<mrpt::obs::CObservation2DRangeScan*>(observation.get()))
        {
            if (!is_own) scan->timestamp = arrived(scan->timestamp);
            scan->timestamp -= std::chrono::duration_cast<mrpt::Clock::duration>(
                std::chrono::duration<double>(section_.stamp_late_s));
            if (section_.sweep_s > 0) sink_(timing_record(*scan, {section_.sweep_s}));
        }
        sink_(std::move(observation));
        last_observation_ = Clock::now();
        const std::lock_guard lock(mutex_);
        ++report_.observations;
    }
}

/// When a scan of MRPT's drivers came, had it not been held up. Some stamp by the laser's own
/// clock, which they set by a single scan: were that one read late, all later ones would be from
/// the future, and no driver expects that the clock begins anew.
mrpt::Clock::time_point SensorRunner::arrived(mrpt::Clock::time_point driver_stamp)
{
    return mrpt::Clock::fromDouble(
        laser_clock_.sent(mrpt::Clock::toDouble(driver_stamp), unix_time_s()));
}

/// Throws where the sensor has to be started anew.
void SensorRunner::noteState(const CGenericSensor& sensor)
{
    if (const auto* own = dynamic_cast<const TellsStatus*>(&sensor))
    {
        const auto status = own->status();  // it looks after itself
        const std::lock_guard lock(mutex_);
        report_.is_working = status.is_connected;
        report_.device = status.device;
        report_.problem = status.problem;
        report_.restarts = status.reconnects;
        return;
    }
    const bool is_laser =
        dynamic_cast<const mrpt::hwdrivers::C2DRangeFinderAbstract*>(&sensor) != nullptr;
    const double longest_s = section_.restart_after_s.value_or(is_laser ? kLaserSilence_s : 0);
    const std::chrono::duration<double> silence = Clock::now() - last_observation_;
    if (longest_s > 0 && silence.count() > longest_s)
        throw std::runtime_error("silent for longer than restart_after_s");
    // Some drivers call a single lost telegram an error, and are well again with the next one.
    if (sensor.getState() == CGenericSensor::ssError && silence.count() > kLastingError_s)
        throw std::runtime_error("the driver reports an error");
    const std::lock_guard lock(mutex_);
    report_.is_working = sensor.getState() == CGenericSensor::ssWorking;
    if (report_.is_working) report_.problem.clear();
}

void SensorRunner::pause(Clock::duration duration)
{
    const auto end = Clock::now() + duration;
    while (!ends_ && Clock::now() < end)
    {
        last_seen_ = Clock::now();
        std::this_thread::sleep_for(std::min<Clock::duration>(kSensorStep, end - Clock::now()));
    }
}
}  // namespace rtob

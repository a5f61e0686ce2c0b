// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/drivers/rplidar_sensor.h>
#include <rtob/drivers/sensor_section.h>
#include <rtob/io/scan_timing.h>

#include <thread>

IMPLEMENTS_GENERIC_SENSOR(RtobRplidar, rtob)

namespace rtob
{
namespace
{
constexpr std::chrono::milliseconds kReadPatience{50};
constexpr std::chrono::seconds kSilence{1};
/// The slowest head turns once in 0.2 s, but may need a few seconds to spin up.
constexpr std::chrono::seconds kNoRevolution{5};

RplidarCounters operator+(RplidarCounters sum, const RplidarCounters& more)
{
    sum.revolutions += more.revolutions;
    sum.partial_revolutions += more.partial_revolutions;
    sum.packets += more.packets;
    sum.bytes_skipped += more.bytes_skipped;
    sum.stray_beams += more.stray_beams;
    sum.packets_missed += more.packets_missed;
    return sum;
}

std::string describe(const RplidarDevice& device)
{
    const auto& info = device.info();
    return "RPLidar " + info.modelName() + ", serial " + info.serial + ", firmware " +
           std::to_string(info.firmware_major) + "." + std::to_string(info.firmware_minor) +
           ", mode " + device.mode().name + ", " + std::to_string(device.port().baud()) +
           " baud on " + device.port().device();
}
}  // namespace

RtobRplidar::RtobRplidar() : mrpt::system::COutputLogger("RtobRplidar")
{
    m_sensorLabel = "RPLIDAR";
}

RtobRplidar::~RtobRplidar() = default;

void RtobRplidar::loadConfig_sensorSpecific(
    const mrpt::config::CConfigFileBase& config, const std::string& section)
{
    load_sensor_options(config, section, options_);
    maker_ =
        std::make_unique<RplidarScanMaker>(options_, sensor_pose(config, section), m_sensorLabel);
}

void RtobRplidar::initialize()
{
    if (!maker_)
        maker_ =
            std::make_unique<RplidarScanMaker>(options_, mrpt::poses::CPose3D(), m_sensorLabel);
    connect();
}

void RtobRplidar::connect()
{
    RplidarWish wish;
    wish.port = options_.port;
    wish.baud = options_.baud;
    wish.mode = options_.scan_mode;
    wish.motor_rpm = options_.motor_rpm;
    wish.max_gap_deg = options_.max_gap_deg;
    device_ = std::make_unique<RplidarDevice>(wish);
    last_revolution_ = last_packet_ = BackOff::Clock::now();
    packets_seen_ = 0;
    m_state = ssWorking;
    MRPT_LOG_INFO_STREAM(describe(*device_));
    const std::lock_guard lock(mutex_);
    status_.is_connected = true;
    status_.device = describe(*device_);
    status_.problem =
        device_->health().health == RplidarHealth::Warning
            ? "the device warns of its health, code " + std::to_string(device_->health().error_code)
            : "";
}

void RtobRplidar::doProcess()
{
    if (!device_)
    {
        tryToReconnect();
        return;
    }
    try
    {
        for (const auto& revolution : device_->read(kReadPatience)) append(revolution);
        checkSilence();
    }
    catch (const PortError& error)
    {
        disconnect(error.what());
        return;
    }
    const std::lock_guard lock(mutex_);
    counters_ = counters_of_past_ + device_->counters();
}

void RtobRplidar::disconnect(const std::string& problem)
{
    MRPT_LOG_ERROR_STREAM(problem);
    counters_of_past_ = counters_of_past_ + device_->counters();
    device_.reset();
    m_state = ssError;
    back_off_.succeeded();
    const std::lock_guard lock(mutex_);
    counters_ = counters_of_past_;
    status_.is_connected = false;
    status_.problem = problem;
}

void RtobRplidar::tryToReconnect()
{
    const auto now = BackOff::Clock::now();
    if (!back_off_.mayTry(now))
    {
        std::this_thread::sleep_for(
            std::min<BackOff::Clock::duration>(back_off_.untilNext(now), kReadPatience));
        return;
    }
    try
    {
        connect();
        back_off_.succeeded();
        const std::lock_guard lock(mutex_);
        ++status_.reconnects;
    }
    catch (const PortError& error)
    {
        back_off_.failed(BackOff::Clock::now());
        const std::lock_guard lock(mutex_);
        status_.problem = error.what();
    }
}

void RtobRplidar::append(const RplidarRevolution& revolution)
{
    last_revolution_ = BackOff::Clock::now();
    const auto scan = maker_->make(revolution, deviceRange());
    appendObservation(timing_record(*scan, {revolution.sweep_s}));
    appendObservation(scan);
}

void RtobRplidar::checkSilence()
{
    const auto now = BackOff::Clock::now();
    if (const auto packets = device_->counters().packets; packets != packets_seen_)
    {
        packets_seen_ = packets;
        last_packet_ = now;
    }
    if (now - last_packet_ > kSilence)
        throw PortError(
            "RPLidar on " + options_.port + " sends nothing. Is its power strong enough?");
    if (now - last_revolution_ > kNoRevolution)
        throw PortError(
            "RPLidar on " + options_.port + " sent no whole revolution for " +
            std::to_string(kNoRevolution.count()) + " s. Is its head free, its cable good?");
}

/// Where the device does not tell: the range of its series.
double RtobRplidar::deviceRange() const
{
    if (device_->mode().max_range_m > 0) return device_->mode().max_range_m;
    switch (device_->info().series())
    {
        case 1:
        case 4:
            return 12;
        case 2:
            return 16;
        case 3:
            return 25;
        default:
            return 40;
    }
}

SensorStatus RtobRplidar::status() const
{
    const std::lock_guard lock(mutex_);
    return status_;
}

RplidarCounters RtobRplidar::counters() const
{
    const std::lock_guard lock(mutex_);
    return counters_;
}

std::string RtobRplidar::modesText() const
{
    if (!device_) return "not connected";
    std::string text;
    for (const auto& mode : device_->modes()) text += (text.empty() ? "" : ", ") + mode.name;
    return text;
}
}  // namespace rtob

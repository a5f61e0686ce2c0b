// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/drivers/rplidar_device.h>
#include <rtob/drivers/unix_time.h>

#include <algorithm>
#include <thread>

namespace rtob
{
namespace
{
using std::chrono::milliseconds;

constexpr milliseconds kReplyPatience{400};
/// Some devices spin up before they answer the request for a scan.
constexpr milliseconds kScanPatience{2000};
constexpr milliseconds kPauseAfterStop{20};
constexpr milliseconds kPauseAfterReset{1000};
constexpr double kBitsPerByte = 10;  // 8N1

std::string lower(std::string text)
{
    std::transform(
        text.begin(), text.end(), text.begin(),
        [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 'a' - 'A') : c; });
    return text;
}

bool can_read(RplidarAnswer type)
{
    return type == RplidarAnswer::Standard || type == RplidarAnswer::Express ||
           type == RplidarAnswer::Ultra || type == RplidarAnswer::Dense;
}

std::string names_of(const std::vector<RplidarMode>& modes)
{
    std::string names;
    for (const auto& mode : modes) names += (names.empty() ? "" : ", ") + mode.name;
    return names;
}
}  // namespace

RplidarDevice::RplidarDevice(const RplidarWish& wish) : max_gap_deg_(wish.max_gap_deg)
{
    findBaud(wish);
    checkHealth();
    readModes();
    chooseMode(wish.mode);
    startMotor(wish.motor_rpm);
    startScan();
}

RplidarDevice::~RplidarDevice()
{
    try
    {
        send(RplidarCommand::Stop);
        std::this_thread::sleep_for(kPauseAfterStop);
        stopMotor();
    }
    catch (const PortError&)  // unplugged: it stops by itself
    {
    }
}

/// A device that hears another speed stays silent or answers rubbish.
void RplidarDevice::findBaud(const RplidarWish& wish)
{
    std::vector<unsigned> bauds{115200, 256000, 1000000, 460800};
    if (wish.baud > 0) bauds = {wish.baud};
    for (const unsigned baud : bauds)
    {
        port_ = std::make_unique<SerialPort>(wish.port, baud);
        parser_ = RplidarParser(kBitsPerByte / baud, max_gap_deg_);
        send(RplidarCommand::Stop);
        std::this_thread::sleep_for(kPauseAfterStop);
        port_->drain();
        for (int attempt = 0; attempt < 2; ++attempt)
        {
            const auto reply =
                ask(rplidar_request(RplidarCommand::GetInfo), RplidarAnswer::Info, kReplyPatience);
            const auto info = reply ? read_info(reply->payload) : std::nullopt;
            if (!info) continue;
            info_ = *info;
            return;
        }
        port_.reset();
    }
    throw PortError(
        "RPLidar on " + wish.port + " does not answer at " +
        (wish.baud > 0 ? std::to_string(wish.baud) + " baud. Try COM_baudRate = 0, which tries all"
                       : "any usual speed. Check the port's name, the cable and the power") +
        ".");
}

void RplidarDevice::checkHealth()
{
    for (int attempt = 0; attempt < 2; ++attempt)
    {
        const auto reply =
            ask(rplidar_request(RplidarCommand::GetHealth), RplidarAnswer::Health, kReplyPatience);
        const auto health = reply ? read_health(reply->payload) : std::nullopt;
        if (!health) continue;
        health_ = *health;
        if (health_.health != RplidarHealth::Error) return;
        send(RplidarCommand::Reset);  // clears what is not broken for good
        std::this_thread::sleep_for(kPauseAfterReset);
        port_->drain();
    }
    if (health_.health == RplidarHealth::Error)
        throw PortError(
            "RPLidar " + info_.modelName() + " on " + port_->device() +
            " reports that it is broken, error code " + std::to_string(health_.error_code) +
            ". Free its head, check its power, unplug it and plug it in again.");
}

void RplidarDevice::readModes()
{
    modes_.clear();
    const auto count = info_.tellsModes() ? askConfig(RplidarConfig::ModeCount) : std::nullopt;
    if (count && count->size() >= 2)
    {
        constexpr std::uint16_t most_modes = 16;
        const std::uint16_t modes = std::min(u16_at(*count, 0), most_modes);
        for (std::uint16_t id = 0; id < modes; ++id)
            if (auto mode = readMode(id); can_read(mode.type)) modes_.push_back(std::move(mode));
    }
    if (!modes_.empty()) return;
    RplidarSampleTimes times;
    if (const auto reply =
            ask(rplidar_request(RplidarCommand::GetSampleRate), RplidarAnswer::SampleRate,
                kReplyPatience))
        times = read_sample_times(reply->payload).value_or(times);
    modes_ = {{0, "Standard", RplidarAnswer::Standard, times.standard_s, 0, times.express_s == 0}};
    if (times.express_s > 0)
        modes_.push_back({0, "Express", RplidarAnswer::Express, times.express_s, 0, true});
}

RplidarMode RplidarDevice::readMode(std::uint16_t id)
{
    RplidarMode mode;
    mode.id = id;
    mode.type = static_cast<RplidarAnswer>(0);
    if (const auto type = askConfig(RplidarConfig::AnswerType, id); type && !type->empty())
        mode.type = static_cast<RplidarAnswer>((*type)[0]);
    if (const auto name = askConfig(RplidarConfig::ModeName, id))
        for (const auto letter : *name)
            if (letter != 0) mode.name += static_cast<char>(letter);
    if (const auto us = askConfig(RplidarConfig::SampleTime, id); us && us->size() >= 4)
        mode.sample_s = 1e-6 * u32_at(*us, 0) / 256;
    if (const auto metres = askConfig(RplidarConfig::MaxDistance, id);
        metres && metres->size() >= 4)
        mode.max_range_m = u32_at(*metres, 0) / 256.0;
    if (const auto typical = askConfig(RplidarConfig::TypicalMode); typical && typical->size() >= 2)
        mode.is_typical = u16_at(*typical, 0) == id;
    return mode;
}

void RplidarDevice::chooseMode(const std::string& wanted)
{
    const std::string name = lower(wanted);
    for (const auto& mode : modes_)
        if (name == "auto" ? mode.is_typical : name == lower(mode.name))
        {
            mode_ = mode;
            return;
        }
    if (name != "auto")
        throw PortError(
            "RPLidar " + info_.modelName() + " on " + port_->device() + " has no scan mode '" +
            wanted + "'. It has: " + names_of(modes_) + ".");
    mode_ = modes_.back();  // the maker's own speaks a language unknown here
}

void RplidarDevice::startMotor(unsigned rpm)
{
    constexpr std::uint16_t usual_pwm = 660;
    port_->setDtr(false);
    if (info_.hasPwmControl())
    {
        Bytes pwm;
        append_u16(pwm, usual_pwm);
        send(RplidarCommand::MotorPwm, pwm);
    }
    else if (info_.hasSpeedControl() && rpm > 0)
    {
        Bytes speed;
        append_u16(speed, static_cast<std::uint16_t>(std::min(rpm, 65535U)));
        send(RplidarCommand::MotorRpm, speed);
    }
}

void RplidarDevice::stopMotor()
{
    if (info_.hasPwmControl()) send(RplidarCommand::MotorPwm, {0, 0});
    if (info_.hasSpeedControl()) send(RplidarCommand::MotorRpm, {0, 0});
    port_->setDtr(true);
}

void RplidarDevice::startScan()
{
    const bool is_standard = mode_.type == RplidarAnswer::Standard;
    const Bytes request = is_standard ? rplidar_request(RplidarCommand::Scan)
                                      : rplidar_request(
                                            RplidarCommand::ExpressScan,
                                            {static_cast<std::uint8_t>(mode_.id), 0, 0, 0, 0});
    parser_.setSampleTime(mode_.sample_s);
    if (!ask(request, mode_.type, kScanPatience))
        throw PortError(
            "RPLidar " + info_.modelName() + " on " + port_->device() +
            " does not start to scan in mode " + mode_.name +
            ". Is its head free? Try scan_mode = standard.");
}

std::vector<RplidarRevolution> RplidarDevice::read(milliseconds timeout)
{
    receive(timeout);
    std::vector<RplidarRevolution> revolutions;
    while (auto revolution = parser_.takeRevolution())
        revolutions.push_back(std::move(*revolution));
    return revolutions;
}

std::optional<RplidarReply> RplidarDevice::ask(
    const Bytes& request, RplidarAnswer type, milliseconds timeout)
{
    parser_.expectReply();
    port_->write(request);
    const auto end = std::chrono::steady_clock::now() + timeout;
    while (std::chrono::steady_clock::now() < end)
    {
        receive(milliseconds(20));
        while (auto reply = parser_.takeReply())
            if (reply->type == type) return reply;
    }
    return std::nullopt;
}

std::optional<Bytes> RplidarDevice::askConfig(
    RplidarConfig question, std::optional<std::uint16_t> mode)
{
    const auto reply =
        ask(rplidar_config_request(question, mode), RplidarAnswer::Config, kReplyPatience);
    return reply ? read_config(reply->payload, question) : std::nullopt;
}

void RplidarDevice::send(RplidarCommand command, const Bytes& payload)
{
    port_->write(rplidar_request(command, payload));
}

void RplidarDevice::receive(milliseconds timeout)
{
    if (const Bytes bytes = port_->read(timeout); !bytes.empty())
        parser_.push(bytes, unix_time_s());
}
}  // namespace rtob

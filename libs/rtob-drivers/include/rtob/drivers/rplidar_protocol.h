// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/drivers/byte_view.h>

#include <cstdint>
#include <optional>
#include <string>

/// The words of Slamtec's serial protocol (LR001): requests, and the answers that are no scan.
namespace rtob
{
enum class RplidarCommand : std::uint8_t
{
    Stop = 0x25,
    Reset = 0x40,
    Scan = 0x20,
    ExpressScan = 0x82,
    GetInfo = 0x50,
    GetHealth = 0x52,
    GetSampleRate = 0x59,
    GetConfig = 0x84,
    MotorRpm = 0xA8,
    MotorPwm = 0xF0
};

/// The type byte of an answer's descriptor.
enum class RplidarAnswer : std::uint8_t
{
    Info = 0x04,
    Health = 0x06,
    SampleRate = 0x15,
    Config = 0x20,
    Standard = 0x81,  ///< 5 bytes a beam
    Express = 0x82,   ///< 84 bytes, 32 beams, each with an angle of its own
    Ultra = 0x84,     ///< 132 bytes, 96 beams with packed ranges
    Dense = 0x85      ///< 84 bytes, 40 beams
};

/// Questions to GetConfig.
enum class RplidarConfig : std::uint32_t
{
    ModeCount = 0x70,
    SampleTime = 0x71,   ///< us, 8 bits after the point
    MaxDistance = 0x74,  ///< m, 8 bits after the point
    AnswerType = 0x75,
    TypicalMode = 0x7C,
    ModeName = 0x7F
};

constexpr std::uint8_t kRplidarRequestStart = 0xA5;
constexpr std::uint8_t kRplidarAnswerStart = 0x5A;  ///< after the request's start byte
constexpr std::size_t kRplidarDescriptor_bytes = 7;

[[nodiscard]] Bytes rplidar_request(RplidarCommand command, const Bytes& payload = {});
[[nodiscard]] Bytes rplidar_config_request(
    RplidarConfig question, std::optional<std::uint16_t> mode = std::nullopt);

/// What follows "A5 5A" in an answer.
struct RplidarDescriptor
{
    std::uint32_t payload_bytes = 0;
    bool is_stream = false;  ///< payloads follow one another until a stop
    RplidarAnswer type = RplidarAnswer::Info;
};

/// Of seven bytes; nothing where they are no descriptor of this protocol.
[[nodiscard]] std::optional<RplidarDescriptor> read_descriptor(ByteView bytes);

/// An answer without its descriptor; of a stream only the fact that it began.
struct RplidarReply
{
    RplidarAnswer type = RplidarAnswer::Info;
    bool is_stream = false;
    Bytes payload;
};

struct RplidarInfo
{
    std::uint8_t model = 0, firmware_major = 0, firmware_minor = 0, hardware = 0;
    std::string serial;  ///< 32 hexadecimal digits

    [[nodiscard]] int series() const { return model >> 4; }
    /// "A1M8", or "model 0x9a" for one that this file does not know.
    [[nodiscard]] std::string modelName() const;
    /// From this series on a command sets the speed; before, a voltage or nothing does.
    [[nodiscard]] bool hasSpeedControl() const { return series() >= 6; }
    [[nodiscard]] bool hasPwmControl() const { return series() == 2 || series() == 3; }
    /// Firmware 1.24 was the first that tells its scan modes.
    [[nodiscard]] bool tellsModes() const
    {
        return firmware_major > 1 || (firmware_major == 1 && firmware_minor >= 24);
    }
};

enum class RplidarHealth
{
    Good,
    Warning,
    Error
};

struct RplidarHealthReport
{
    RplidarHealth health = RplidarHealth::Good;
    unsigned error_code = 0;
};

struct RplidarSampleTimes
{
    double standard_s = 0, express_s = 0;  ///< between two beams
};

/// Nothing where the payload has another length or an unknown value.
[[nodiscard]] std::optional<RplidarInfo> read_info(ByteView payload);
[[nodiscard]] std::optional<RplidarHealthReport> read_health(ByteView payload);
[[nodiscard]] std::optional<RplidarSampleTimes> read_sample_times(ByteView payload);
/// What follows the echoed question.
[[nodiscard]] std::optional<Bytes> read_config(ByteView payload, RplidarConfig question);
}  // namespace rtob

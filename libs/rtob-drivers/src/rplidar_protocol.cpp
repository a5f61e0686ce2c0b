// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/drivers/rplidar_protocol.h>

#include <array>
#include <cstdio>

namespace rtob
{
namespace
{
constexpr std::uint8_t kHasPayload = 0x80;
constexpr std::uint32_t kLongestAnswer_bytes = 1024;

bool is_known(std::uint8_t type)
{
    switch (static_cast<RplidarAnswer>(type))
    {
        case RplidarAnswer::Info:
        case RplidarAnswer::Health:
        case RplidarAnswer::SampleRate:
        case RplidarAnswer::Config:
        case RplidarAnswer::Standard:
        case RplidarAnswer::Express:
        case RplidarAnswer::Ultra:
        case RplidarAnswer::Dense:
            return true;
    }
    return false;
}

std::string hexadecimal(ByteView bytes)
{
    std::string text;
    for (std::size_t i = 0; i < bytes.size; ++i)
    {
        std::array<char, 3> digits{};
        std::snprintf(digits.data(), digits.size(), "%02X", bytes[i]);
        text += digits.data();
    }
    return text;
}
}  // namespace

Bytes rplidar_request(RplidarCommand command, const Bytes& payload)
{
    const auto code = static_cast<std::uint8_t>(command);
    Bytes request{kRplidarRequestStart, code};
    if ((code & kHasPayload) == 0) return request;
    request.push_back(static_cast<std::uint8_t>(payload.size()));
    request.insert(request.end(), payload.begin(), payload.end());
    std::uint8_t checksum = 0;
    for (const auto byte : request) checksum = static_cast<std::uint8_t>(checksum ^ byte);
    request.push_back(checksum);
    return request;
}

Bytes rplidar_config_request(RplidarConfig question, std::optional<std::uint16_t> mode)
{
    Bytes payload;
    append_u32(payload, static_cast<std::uint32_t>(question));
    if (mode) append_u16(payload, *mode);
    return rplidar_request(RplidarCommand::GetConfig, payload);
}

std::optional<RplidarDescriptor> read_descriptor(ByteView bytes)
{
    if (bytes.size < kRplidarDescriptor_bytes || bytes[0] != kRplidarRequestStart ||
        bytes[1] != kRplidarAnswerStart || !is_known(bytes[6]))
        return std::nullopt;
    const std::uint32_t word = u32_at(bytes, 2);
    const std::uint32_t send_mode = word >> 30;
    const std::uint32_t length = word & 0x3FFFFFFF;
    if (send_mode > 1 || length == 0 || length > kLongestAnswer_bytes) return std::nullopt;
    return RplidarDescriptor{length, send_mode == 1, static_cast<RplidarAnswer>(bytes[6])};
}

std::string RplidarInfo::modelName() const
{
    struct Name
    {
        std::uint8_t model;
        const char* name;
    };
    constexpr std::array<Name, 9> names{
        {{0x18, "A1M8"},
         {0x24, "A2M4"},
         {0x28, "A2M8"},
         {0x2C, "A2M12"},
         {0x31, "A3M1"},
         {0x41, "C1M1"},
         {0x61, "S1M1"},
         {0x71, "S2M1"},
         {0x81, "S3M1"}}};
    for (const auto& known : names)
        if (known.model == model) return known.name;
    std::array<char, 16> text{};
    std::snprintf(text.data(), text.size(), "model 0x%02x", model);
    return text.data();
}

std::optional<RplidarInfo> read_info(ByteView payload)
{
    if (payload.size != 20) return std::nullopt;
    RplidarInfo info;
    info.model = payload[0];
    info.firmware_minor = payload[1];
    info.firmware_major = payload[2];
    info.hardware = payload[3];
    info.serial = hexadecimal(payload.from(4));
    return info;
}

std::optional<RplidarHealthReport> read_health(ByteView payload)
{
    if (payload.size != 3 || payload[0] > 2) return std::nullopt;
    return RplidarHealthReport{static_cast<RplidarHealth>(payload[0]), u16_at(payload, 1)};
}

std::optional<RplidarSampleTimes> read_sample_times(ByteView payload)
{
    if (payload.size != 4) return std::nullopt;
    return RplidarSampleTimes{1e-6 * u16_at(payload, 0), 1e-6 * u16_at(payload, 2)};
}

std::optional<Bytes> read_config(ByteView payload, RplidarConfig question)
{
    if (payload.size < 4 || u32_at(payload, 0) != static_cast<std::uint32_t>(question))
        return std::nullopt;
    return Bytes(payload.data + 4, payload.data + payload.size);
}
}  // namespace rtob

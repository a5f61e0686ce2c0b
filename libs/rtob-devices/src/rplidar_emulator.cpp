// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/devices/rplidar_emulator.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace rtob::devices
{
namespace
{
constexpr double kPi = 3.14159265358979323846;
constexpr std::uint8_t kStart = 0xA5;

std::uint32_t little_endian(const std::vector<std::uint8_t>& bytes, std::size_t at, int count)
{
    std::uint32_t value = 0;
    for (int i = 0; i < count; ++i)
        value |= static_cast<std::uint32_t>(bytes[at + static_cast<std::size_t>(i)]) << (8 * i);
    return value;
}

void put_u32(Packet& packet, std::uint32_t value)
{
    for (int i = 0; i < 4; ++i) packet.push_back(static_cast<std::uint8_t>(value >> (8 * i)));
}

void put_u16(Packet& packet, std::size_t value)
{
    for (int i = 0; i < 2; ++i) packet.push_back(static_cast<std::uint8_t>(value >> (8 * i)));
}

Packet descriptor(std::uint8_t type, std::size_t length, bool is_stream)
{
    Packet bytes{kStart, 0x5A};
    put_u32(bytes, static_cast<std::uint32_t>(length) | (is_stream ? 1U << 30 : 0U));
    bytes.push_back(type);
    return bytes;
}
}  // namespace

RplidarModel model_a1()
{
    RplidarModel model;
    model.modes = {
        {"Standard", RplidarScanKind::Standard, 508e-6},
        {"Express", RplidarScanKind::Express, 252e-6}};
    model.typical_mode = 1;
    return model;
}

RplidarModel model_a2()
{
    RplidarModel model = model_a1();
    model.model = 0x28;
    model.turns_hz = 10;
    model.max_range_m = 16;
    return model;
}

RplidarModel model_a3()
{
    RplidarModel model;
    model.model = 0x31;
    model.baud = 256000;
    model.turns_hz = 10;
    model.max_range_m = 25;
    model.modes = {
        {"Standard", RplidarScanKind::Standard, 252e-6},
        {"Express", RplidarScanKind::Express, 252e-6},
        {"Sensitivity", RplidarScanKind::Ultra, 63e-6}};
    model.typical_mode = 2;
    return model;
}

RplidarModel model_s2()
{
    RplidarModel model;
    model.model = 0x71;
    model.baud = 1000000;
    model.turns_hz = 10;
    model.max_range_m = 30;
    model.modes = {
        {"Standard", RplidarScanKind::Standard, 63e-6},
        {"DenseBoost", RplidarScanKind::Dense, 31.25e-6}};
    model.typical_mode = 1;
    return model;
}

RplidarEmulator::RplidarEmulator(RplidarModel model, RangeSource ranges)
    : model_(std::move(model)), ranges_(std::move(ranges))
{
}

void RplidarEmulator::restart()
{
    received_.clear();
    replies_.clear();
    is_scanning_ = false;
}

void RplidarEmulator::breakDown()
{
    restart();
    has_error_ = true;
}

void RplidarEmulator::receive(const Packet& bytes, double now_s)
{
    received_.insert(received_.end(), bytes.begin(), bytes.end());
    while (!received_.empty())
    {
        if (received_[0] != kStart)
        {
            received_.erase(received_.begin());
            continue;
        }
        const std::size_t length = requestLength();
        if (received_.size() < length) return;
        const auto end = received_.begin() + static_cast<std::ptrdiff_t>(length);
        const std::vector<std::uint8_t> request(received_.begin(), end);
        received_.erase(received_.begin(), end);
        answer(request, now_s);
    }
}

/// Two bytes; with a payload its length, itself and a checksum follow. Long while not known yet.
std::size_t RplidarEmulator::requestLength() const
{
    if (received_.size() < 2) return 2;
    if ((received_[1] & 0x80) == 0) return 2;
    return received_.size() < 3 ? 3 : 4U + received_[2];
}

void RplidarEmulator::answer(const std::vector<std::uint8_t>& request, double now_s)
{
    const auto checksum = std::accumulate(
        request.begin(), request.end(), 0U, [](unsigned a, std::uint8_t b) { return a ^ b; });
    if (request.size() > 2 && checksum != 0) return;  // the sum over all, its own byte included
    switch (request[1])
    {
        case 0x25:  // stop
            is_scanning_ = false;
            return;
        case 0x40:  // reset
            restart();
            has_error_ = false;
            return;
        case 0x50:  // who are you
        {
            Packet info(20, 0x5E);
            info[0] = model_.model;
            info[1] = model_.firmware_minor;
            info[2] = model_.firmware_major;
            return reply(0x04, info);
        }
        case 0x52:  // how are you
            return reply(0x06, has_error_ ? Packet{2, 0x01, 0x80} : Packet{0, 0, 0});
        case 0x59:  // sample times
        {
            Packet times;
            for (const double sample_s : {model_.modes.front().sample_s, model_.modes[1].sample_s})
                put_u16(times, static_cast<std::size_t>(std::lround(1e6 * sample_s)));
            return reply(0x15, times);
        }
        case 0x84:
            return answerConfig(request);
        case 0x20:
            return startScan(model_.modes.front(), now_s);
        case 0x82:
            return startScan(
                model_.modes[std::min<std::size_t>(request[3], model_.modes.size() - 1)], now_s);
        default:  // the motor; what it does is not looked at
            return;
    }
}

void RplidarEmulator::answerConfig(const std::vector<std::uint8_t>& request)
{
    if (request.size() < 8) return;
    const std::uint32_t question = little_endian(request, 3, 4);
    const std::size_t id = request.size() >= 10 ? little_endian(request, 7, 2) : 0;
    if (id >= model_.modes.size()) return;
    const EmulatedMode& mode = model_.modes[id];
    Packet payload;
    put_u32(payload, question);
    const auto fixed_point = [&](double value)
    { put_u32(payload, static_cast<std::uint32_t>(std::lround(value * 256))); };
    switch (question)
    {
        case 0x70:
            put_u16(payload, model_.modes.size());
            break;
        case 0x71:
            fixed_point(1e6 * mode.sample_s);
            break;
        case 0x74:
            fixed_point(model_.max_range_m);
            break;
        case 0x75:
            payload.push_back(static_cast<std::uint8_t>(mode.kind));
            break;
        case 0x7C:
            put_u16(payload, model_.typical_mode);
            break;
        case 0x7F:
            for (const char letter : mode.name)
                payload.push_back(static_cast<std::uint8_t>(letter));
            payload.push_back(0);
            break;
        default:
            break;
    }
    reply(0x20, payload);
}

void RplidarEmulator::reply(std::uint8_t type, const Packet& payload)
{
    Packet whole = descriptor(type, payload.size(), false);
    for (const auto byte : payload) whole.push_back(byte);
    replies_.push_back(whole);
}

void RplidarEmulator::startScan(const EmulatedMode& mode, double now_s)
{
    mode_ = mode;
    is_scanning_ = is_first_packet_ = true;
    scan_start_s_ = line_free_s_ = now_s;
    beams_sent_ = 0;
    replies_.push_back(
        descriptor(static_cast<std::uint8_t>(mode.kind), packet_bytes(mode.kind), true));
}

double RplidarEmulator::shaftDeg(double time_s) const
{
    return 360 * model_.turns_hz * (time_s - scan_start_s_);
}

std::vector<Packet> RplidarEmulator::send(double now_s)
{
    std::vector<Packet> packets = std::move(replies_);
    replies_.clear();
    while (is_scanning_)
    {
        // A packet leaves when its last beam is taken and the one before it has left.
        const auto beams = beams_sent_ + beams_of_packet(mode_.kind);
        const double taken_s = scan_start_s_ + static_cast<double>(beams) * mode_.sample_s;
        const double sending_s = 10.0 * static_cast<double>(packet_bytes(mode_.kind)) / model_.baud;
        const double sent_s = std::max(taken_s, line_free_s_) + sending_s;
        if (sent_s > now_s) break;
        packets.push_back(nextPacket());
        line_free_s_ = sent_s;
    }
    return packets;
}

Packet RplidarEmulator::nextPacket()
{
    const auto time_of = [this](std::size_t beam)
    { return scan_start_s_ + static_cast<double>(beams_sent_ + beam) * mode_.sample_s; };
    const std::size_t count = beams_of_packet(mode_.kind);
    PacketContent content;
    // An Ultra packet refers to the first beam of the next one.
    for (std::size_t i = 0; i <= count; ++i) content.shaft_deg.push_back(shaftDeg(time_of(i)));
    content.range_mm = [&](std::size_t beam, double bearing_deg)
    {
        const double range_m = ranges_(-bearing_deg * kPi / 180, time_of(beam));
        return range_m > model_.max_range_m ? 0 : static_cast<int>(std::lround(1000 * range_m));
    };
    const auto turn_of = [](double shaft_deg) { return std::floor(shaft_deg / 360); };
    const bool is_first_of_turn =
        beams_sent_ == 0 || turn_of(content.shaft_deg[0]) != turn_of(last_shaft_deg_);
    content.begins = mode_.kind == RplidarScanKind::Standard ? is_first_of_turn : is_first_packet_;
    is_first_packet_ = false;
    beams_sent_ += count;
    last_shaft_deg_ = content.shaft_deg[count - 1];
    return encode_packet(mode_.kind, content);
}
}  // namespace rtob::devices

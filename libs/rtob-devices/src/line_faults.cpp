// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/devices/line_faults.h>

namespace rtob::devices
{
std::string_view name_of(LineFault fault)
{
    switch (fault)
    {
        case LineFault::Garbage:
            return "garbage";
        case LineFault::HalfPacket:
            return "half packet";
        case LineFault::WrongChecksum:
            return "wrong checksum";
        case LineFault::Stall:
            return "stall";
        case LineFault::WrongBaud:
            return "wrong baud";
        case LineFault::Unplug:
            return "unplug";
        case LineFault::Restart:
            return "restart";
        case LineFault::ErrorState:
            break;
    }
    return "error state";
}

void LineFaults::inject(LineFault fault, EmulatedDevice& device, double now_s, double duration_s)
{
    switch (fault)
    {
        case LineFault::Garbage:
        case LineFault::HalfPacket:
        case LineFault::WrongChecksum:
            waiting_.push_back(fault);
            return;
        case LineFault::Stall:
            silent_until_s_ = now_s + duration_s;
            return;
        case LineFault::WrongBaud:
            garbled_until_s_ = now_s + duration_s;
            return;
        case LineFault::Unplug:
            unplugged_until_s_ = now_s + duration_s;
            device.restart();
            return;
        case LineFault::Restart:
            device.restart();
            return;
        case LineFault::ErrorState:
            device.breakDown();
            return;
    }
}

Packet LineFaults::arriving(Packet packet, double now_s)
{
    if (now_s < silent_until_s_) return {};
    if (!isHeard(now_s))
        for (auto& byte : packet) byte = static_cast<std::uint8_t>(random_());
    else if (!packet.empty())
        spoil(packet);
    return packet;
}

void LineFaults::spoil(Packet& packet)
{
    if (waiting_.empty()) return;
    const LineFault fault = waiting_.back();
    waiting_.pop_back();
    if (fault == LineFault::HalfPacket)
        packet.resize(packet.size() / 2);
    else if (fault == LineFault::WrongChecksum)
        packet[random_() % packet.size()] ^= 0x55;
    else
        for (auto count = 1 + random_() % 300; count > 0; --count)
            packet.push_back(static_cast<std::uint8_t>(random_()));
}
}  // namespace rtob::devices

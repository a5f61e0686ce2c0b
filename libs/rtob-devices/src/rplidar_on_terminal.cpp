// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/devices/rplidar_on_terminal.h>

#include <chrono>

namespace rtob::devices
{
namespace
{
double now_s()
{
    return std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch())
        .count();
}
}  // namespace

RplidarOnTerminal::RplidarOnTerminal(
    const std::string& link, RplidarModel model, RangeSource ranges)
    : terminal_(link), emulator_(std::move(model), std::move(ranges)), thread_([this] { live(); })
{
}

RplidarOnTerminal::~RplidarOnTerminal()
{
    ends_ = true;
    thread_.join();
}

void RplidarOnTerminal::inject(LineFault fault, double duration_s)
{
    const std::lock_guard lock(mutex_);
    switch (fault)
    {
        case LineFault::Garbage:
        case LineFault::HalfPacket:
        case LineFault::WrongChecksum:
            waiting_.push_back(fault);
            return;
        case LineFault::Stall:
            silent_until_s_ = now_s() + duration_s;
            return;
        case LineFault::Unplug:
            unplugged_until_s_ = now_s() + duration_s;
            return;
        case LineFault::ErrorState:
            emulator_.setError(true);
            emulator_.restart();
            return;
        case LineFault::Restart:
            emulator_.restart();
            return;
    }
}

double RplidarOnTerminal::shaftDeg(double time_s) const
{
    const std::lock_guard lock(mutex_);
    return emulator_.shaftDeg(time_s);
}

void RplidarOnTerminal::live()
{
    while (!ends_) step();
}

void RplidarOnTerminal::step()
{
    constexpr int step_ms = 1;
    const auto request = terminal_.receive(step_ms);
    const std::lock_guard lock(mutex_);
    const double now = now_s();
    if (now < unplugged_until_s_)
    {
        terminal_.unplug();
        emulator_.restart();
        return;
    }
    terminal_.plug();
    const bool is_heard = terminal_.baud() == emulator_.model().baud;
    if (is_heard && !request.empty()) emulator_.receive(request, now);
    auto packets = emulator_.send(now);
    is_scanning_ = emulator_.isScanning();
    if (now < silent_until_s_ || !is_heard) return;
    for (auto& packet : packets)
    {
        spoil(packet);
        terminal_.send(packet);
    }
}

void RplidarOnTerminal::spoil(std::vector<std::uint8_t>& bytes)
{
    if (waiting_.empty() || bytes.empty()) return;
    const LineFault fault = waiting_.back();
    waiting_.pop_back();
    if (fault == LineFault::HalfPacket)
        bytes.resize(bytes.size() / 2);
    else if (fault == LineFault::WrongChecksum)
        bytes[random_() % bytes.size()] ^= 0x55;
    else
        for (auto count = 1 + random_() % 300; count > 0; --count)
            bytes.push_back(static_cast<std::uint8_t>(random_()));
}
}  // namespace rtob::devices

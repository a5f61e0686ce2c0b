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
    faults_.inject(fault, emulator_, now_s(), duration_s);
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
    if (faults_.isUnplugged(now))
    {
        terminal_.unplug();
        return;
    }
    terminal_.plug();
    const bool is_heard = faults_.isHeard(now) && terminal_.baud() == emulator_.model().baud;
    if (is_heard && !request.empty()) emulator_.receive(request, now);
    auto packets = emulator_.send(now);
    is_scanning_ = emulator_.isScanning();
    if (terminal_.baud() != emulator_.model().baud) return;
    for (auto& packet : packets) terminal_.send(faults_.arriving(std::move(packet), now));
}
}  // namespace rtob::devices

// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <string_view>

namespace rtob::devices
{
/// What can happen to a device and its line.
enum class LineFault
{
    Garbage,        ///< bytes that the device never sent
    HalfPacket,     ///< the rest of a packet is lost
    WrongChecksum,  ///< a byte of a packet is changed
    Stall,          ///< nothing comes for a while; what was measured is lost
    WrongBaud,  ///< for a while the two ends talk at different speeds: all that comes is rubbish
    Unplug,     ///< the port is gone, and back after a while
    Restart,    ///< the device lost its power for a moment and waits for commands
    ErrorState  ///< the device reports that it is broken, until it is set up anew
};

constexpr std::array<LineFault, 8> all_line_faults{
    LineFault::Garbage,   LineFault::HalfPacket, LineFault::WrongChecksum, LineFault::Stall,
    LineFault::WrongBaud, LineFault::Unplug,     LineFault::Restart,       LineFault::ErrorState};

[[nodiscard]] std::string_view name_of(LineFault fault);
}  // namespace rtob::devices

// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/drivers/serial_port.h>

#include <memory>

namespace rtob
{
/// A way for bytes to an autopilot and back. Calls throw PortError where it is broken.
class ByteLink
{
 public:
    virtual ~ByteLink() = default;
    /// What came; nothing after the timeout.
    [[nodiscard]] virtual Bytes read(std::chrono::milliseconds timeout) = 0;
    /// Datagrams that nobody takes are lost without a word.
    virtual void write(ByteView bytes) = 0;
};

/// "udp:HOST:PORT" sends there and hears what comes back, "udpin:ADDRESS:PORT" hears there and
/// answers the last who called, anything else is a serial port. Throws PortError.
[[nodiscard]] std::unique_ptr<ByteLink> open_link(const std::string& link, unsigned baud);
}  // namespace rtob

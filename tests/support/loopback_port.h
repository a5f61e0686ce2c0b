// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <arpa/inet.h>
#include <sys/socket.h>
#include <unistd.h>

namespace rtob::test
{
/// Binds a UDP socket to a port of the loopback address that nobody has.
/// @return the port
inline int bind_to_free_port(int udp_socket)
{
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof address;
    bind(udp_socket, reinterpret_cast<sockaddr*>(&address), size);
    getsockname(udp_socket, reinterpret_cast<sockaddr*>(&address), &size);
    return ntohs(address.sin_port);
}

/// A UDP port of this computer that nobody has.
[[nodiscard]] inline int free_udp_port()
{
    const int probe = socket(AF_INET, SOCK_DGRAM, 0);
    const int port = bind_to_free_port(probe);
    close(probe);
    return port;
}
}  // namespace rtob::test

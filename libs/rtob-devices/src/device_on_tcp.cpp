// SPDX-License-Identifier: BSD-3-Clause
#include <arpa/inet.h>
#include <poll.h>
#include <rtob/devices/device_on_tcp.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <stdexcept>

namespace rtob::devices
{
namespace
{
constexpr int kStep_ms = 1;

double now_s()
{
    return std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch())
        .count();
}
}  // namespace

DeviceOnTcp::DeviceOnTcp(std::unique_ptr<EmulatedDevice> device, int port)
    : device_(std::move(device)), port_(port)
{
    listenAtPort();
    thread_ = std::thread([this] { live(); });
}

DeviceOnTcp::~DeviceOnTcp()
{
    ends_ = true;
    thread_.join();
    unplug();
}

void DeviceOnTcp::inject(LineFault fault, double duration_s)
{
    const std::lock_guard lock(mutex_);
    faults_.inject(fault, *device_, now_s(), duration_s);
}

void DeviceOnTcp::listenAtPort()
{
    listener_ = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    const int on = 1;  // the port of a client that is gone is held back for minutes otherwise
    setsockopt(listener_, SOL_SOCKET, SO_REUSEADDR, &on, sizeof on);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    address.sin_port = htons(static_cast<std::uint16_t>(port_));
    socklen_t size = sizeof address;
    if (bind(listener_, reinterpret_cast<sockaddr*>(&address), size) != 0 ||
        listen(listener_, 1) != 0)
        throw std::runtime_error(
            "emulated device at port " + std::to_string(port_) + ": " + std::strerror(errno));
    getsockname(listener_, reinterpret_cast<sockaddr*>(&address), &size);
    port_ = ntohs(address.sin_port);
}

void DeviceOnTcp::live()
{
    while (!ends_) step();
}

void DeviceOnTcp::step()
{
    pollfd wait{client_ >= 0 ? client_ : listener_, POLLIN, 0};
    const bool is_ready = poll(&wait, 1, kStep_ms) > 0 && wait.fd >= 0;
    const std::lock_guard lock(mutex_);
    const double now = now_s();
    if (faults_.isUnplugged(now))
    {
        unplug();
        return;
    }
    if (listener_ < 0)
        listenAtPort();
    else if (is_ready)
        client_ < 0 ? accept() : receive();
    for (auto& packet : device_->send(now))
    {
        const Packet bytes = faults_.arriving(std::move(packet), now);
        if (client_ >= 0)
            static_cast<void>(
                send(client_, bytes.data(), bytes.size(), MSG_NOSIGNAL | MSG_DONTWAIT));
    }
}

void DeviceOnTcp::accept()
{
    client_ = accept4(listener_, nullptr, nullptr, SOCK_CLOEXEC);
}

void DeviceOnTcp::receive()
{
    Packet buffer(512);
    const auto count = recv(client_, buffer.data(), buffer.size(), 0);
    if (count <= 0)
    {
        hangUp();
        return;
    }
    buffer.resize(static_cast<std::size_t>(count));
    if (faults_.isHeard(now_s())) device_->receive(buffer, now_s());
}

/// The client is gone: the next one finds the device at rest.
void DeviceOnTcp::hangUp()
{
    if (client_ >= 0) close(client_);
    client_ = -1;
    device_->restart();
}

void DeviceOnTcp::unplug()
{
    hangUp();
    if (listener_ >= 0) close(listener_);
    listener_ = -1;
}
}  // namespace rtob::devices

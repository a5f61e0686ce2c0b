// SPDX-License-Identifier: BSD-3-Clause
#include "state_stream.h"

#include <arpa/inet.h>
#include <rtob/core/enum_names.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace rtob
{
namespace
{
sockaddr_in address_of(const std::string& host, unsigned port, const char* key)
{
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(static_cast<std::uint16_t>(port));
    if (inet_pton(AF_INET, host.c_str(), &address.sin_addr) != 1)
        throw std::runtime_error(
            "section [StateStream], key " + std::string(key) + ": '" + host +
            "' is no address such as 127.0.0.1");
    return address;
}

[[noreturn]] void refuse(int socket, const std::string& what)
{
    const std::string reason = std::strerror(errno);
    close(socket);
    throw std::runtime_error("section [StateStream]: " + what + ": " + reason);
}
}  // namespace

std::string state_line(const LiveState& state)
{
    const auto& report = state.report;
    const auto& pose = report.pose_map_vehicle;
    const auto& c = report.covariance;
    const nlohmann::ordered_json json{
        {"stamp_s", report.stamp_s},
        {"x_m", pose.x},
        {"y_m", pose.y},
        {"yaw_rad", pose.yaw},
        {"state", std::string(name_of(report.state))},
        {"covariance_xx_xy_xa_yy_ya_aa", {c(0, 0), c(0, 1), c(0, 2), c(1, 1), c(1, 2), c(2, 2)}},
        {"compute_ms", 1e3 * report.times.total()},
        {"latency_ms", 1e3 * state.latency_s},
        {"scans", state.scans},
        {"dropped", state.dropped}};
    return json.dump() + "\n";
}

StateStream::StateStream(const StateStreamOptions& options)
{
    if (options.udp_port > 0)
    {
        const auto address = address_of(options.udp_host, options.udp_port, "udp_host");
        udp_ = socket(AF_INET, SOCK_DGRAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
        if (connect(udp_, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0)
            refuse(udp_, "cannot send to " + options.udp_host);
    }
    if (options.tcp_port > 0)
    {
        const auto address = address_of(options.tcp_bind, options.tcp_port, "tcp_bind");
        tcp_ = socket(AF_INET, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
        const int on = 1;
        setsockopt(tcp_, SOL_SOCKET, SO_REUSEADDR, &on, sizeof on);
        if (bind(tcp_, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0 ||
            listen(tcp_, 4) != 0)
            refuse(
                tcp_,
                "cannot listen at " + options.tcp_bind + ":" + std::to_string(options.tcp_port));
    }
}

StateStream::~StateStream()
{
    for (const int client : clients_) close(client);
    if (udp_ >= 0) close(udp_);
    if (tcp_ >= 0) close(tcp_);
}

void StateStream::acceptClients()
{
    constexpr std::size_t most_clients = 16;
    while (tcp_ >= 0 && clients_.size() < most_clients)
    {
        const int client = accept4(tcp_, nullptr, nullptr, SOCK_NONBLOCK | SOCK_CLOEXEC);
        if (client < 0) return;
        clients_.push_back(client);
    }
}

void StateStream::publish(const std::string& line)
{
    constexpr int flags = MSG_DONTWAIT | MSG_NOSIGNAL;
    if (udp_ >= 0) static_cast<void>(send(udp_, line.data(), line.size(), flags));
    acceptClients();
    const auto is_gone = [&](int client)
    {
        // Half a line would garble all that follow.
        if (send(client, line.data(), line.size(), flags) == static_cast<ssize_t>(line.size()))
            return false;
        close(client);
        return true;
    };
    clients_.erase(std::remove_if(clients_.begin(), clients_.end(), is_gone), clients_.end());
}
}  // namespace rtob

// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <chrono>
#include <mutex>
#include <nlohmann/json.hpp>
#include <thread>
#include <vector>

#include "loopback_port.h"

namespace rtob::test
{
/// Hears the state stream of rtob-onboard at a UDP port of the loopback address.
class StateListener
{
 public:
    StateListener()
    {
        port_ = bind_to_free_port(socket_);
        thread_ = std::thread([this] { live(); });
    }
    ~StateListener()
    {
        ends_ = true;
        thread_.join();
        close(socket_);
    }
    StateListener(const StateListener&) = delete;
    StateListener& operator=(const StateListener&) = delete;

    [[nodiscard]] int port() const { return port_; }
    [[nodiscard]] std::vector<nlohmann::json> states() const
    {
        const std::lock_guard lock(mutex_);
        return states_;
    }
    [[nodiscard]] std::size_t count() const
    {
        const std::lock_guard lock(mutex_);
        return states_.size();
    }
    /// Until as many more came; false where they did not within the limit.
    [[nodiscard]] bool waitForMore(std::size_t more, double limit_s = 120) const
    {
        const std::size_t wanted = count() + more;
        const auto end = Clock::now() + std::chrono::duration<double>(limit_s);
        while (count() < wanted && Clock::now() < end)
            std::this_thread::sleep_for(std::chrono::milliseconds(10));
        return count() >= wanted;
    }

 private:
    using Clock = std::chrono::steady_clock;

    void live()
    {
        std::array<char, 2048> line;
        while (!ends_)
        {
            pollfd wait{socket_, POLLIN, 0};
            if (poll(&wait, 1, 20) <= 0) continue;
            const auto size = recv(socket_, line.data(), line.size(), 0);
            if (size <= 0) continue;
            auto state = nlohmann::json::parse(line.data(), line.data() + size);
            const std::lock_guard lock(mutex_);
            states_.push_back(std::move(state));
        }
    }

    int socket_ = socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0), port_ = 0;
    mutable std::mutex mutex_;
    std::vector<nlohmann::json> states_;
    std::atomic<bool> ends_{false};
    std::thread thread_;
};
}  // namespace rtob::test

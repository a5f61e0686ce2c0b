// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/drivers/autopilot.h>
#include <rtob/slam/scan_report.h>

#include <atomic>
#include <functional>
#include <mutex>
#include <string>
#include <thread>

namespace rtob
{
/// Talks with the flight controller in a thread of its own, and looks for the link when it is lost.
class AutopilotThread
{
 public:
    using Sink = std::function<void(mrpt::obs::CObservation::Ptr)>;

    struct Report
    {
        std::string problem;
        MavlinkCounters counters;
        std::uint64_t poses_sent = 0;
        bool is_connected = false, is_synchronised = false;
    };

    AutopilotThread(const AutopilotOptions& options, Sink sink);
    ~AutopilotThread();
    AutopilotThread(const AutopilotThread&) = delete;
    AutopilotThread& operator=(const AutopilotThread&) = delete;

    /// @param pose_s the moment of the report's pose
    void tell(const ScanReport& report, double pose_s);
    void say(int severity, const std::string& text);
    /// Where there is a link now: an old command must not be sent when it comes back.
    template <class Message>
    void send(const Message& message)
    {
        const std::lock_guard lock(mutex_);
        if (is_open_) autopilot_.send(message);
    }
    [[nodiscard]] AutopilotNews news() const;
    [[nodiscard]] Report report() const;

 private:
    void live();
    void talk();

    AutopilotOptions options_;
    Sink sink_;
    mutable std::mutex mutex_;  ///< guards what follows
    Autopilot autopilot_;
    std::string problem_;
    bool is_open_ = false;
    std::atomic<bool> ends_{false};
    std::thread thread_;
};
}  // namespace rtob

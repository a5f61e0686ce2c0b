// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <atomic>
#include <mutex>
#include <thread>

#include "autopilot_thread.h"
#include "command_watch.h"
#include "onboard_config.h"
#include "run/guard_feed.h"

namespace rtob
{
/// The pilot's sticks fly the vehicle as far as the obstacle guard allows it. One thread decides;
/// another one, the watchdog, sends the newest decision, or zero when there is none; neither waits
/// for the localisation.
class GuardedPilot
{
 public:
    struct Report
    {
        std::array<std::uint64_t, enum_names(GuardReason{}).size()> reasons{};
        std::uint64_t decisions = 0, stalls = 0;
        double slowest_decision_ms = 0;  ///< of the processor
    };

    /// @param config and autopilot outlive this object
    GuardedPilot(const OnboardConfig& config, AutopilotThread& autopilot);
    ~GuardedPilot();
    GuardedPilot(const GuardedPilot&) = delete;
    GuardedPilot& operator=(const GuardedPilot&) = delete;

    /// A scan and what the pipeline made of it.
    /// @param sweep_s from the first beam to the last @param pose_s the moment of the pose
    void take(
        const mrpt::obs::CObservation2DRangeScan& scan, double sweep_s, const ScanReport& report,
        double pose_s);

    /// Leaves the vehicle with a command to stand still.
    void end();

    [[nodiscard]] Report report() const;

 private:
    void decideOnAndOn();
    void sendOnAndOn();
    [[nodiscard]] GuardCommand decide(double now_s);
    [[nodiscard]] GuardDecision ask(const PilotWish& wish, const AutopilotNews& news, double now_s);
    void send(const GuardCommand& command, double now_s);

    const OnboardConfig& config_;
    AutopilotThread& autopilot_;
    CommandWatch watch_;
    mutable std::mutex mutex_;  ///< guards what follows
    GuardFeed feed_;
    VelocityGuard guard_;
    Report report_;
    std::string told_state_;  ///< of the sending thread alone
    double next_text_s_ = 0;
    std::atomic<bool> ends_{false};
    std::thread deciding_, sending_;
};
}  // namespace rtob

// SPDX-License-Identifier: BSD-3-Clause
#include "guarded_pilot.h"

#include <mrpt/system/thread_name.h>
#include <rtob/core/enum_names.h>
#include <rtob/core/option_checks.h>
#include <rtob/core/processor_time.h>
#include <rtob/drivers/unix_time.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <limits>

#include "guard_messages.h"

namespace rtob
{
namespace
{
using Clock = std::chrono::steady_clock;

constexpr double kBetweenTexts_s = 0.5;  // a slow radio has other things to carry

/// Calls `work` so often until `ends`; what it misses is not made up for.
template <class Work>
void every(double period_s, const std::atomic<bool>& ends, Work&& work)
{
    const auto period =
        std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(period_s));
    for (auto next = Clock::now(); !ends; std::this_thread::sleep_until(next))
    {
        work();
        next = std::max(next + period, Clock::now());
    }
}

/// The guard counts on a decision in each of its periods; a stop that takes its place is sent one
/// round later at most.
double longest_stall_s(const OnboardConfig& config)
{
    return config.run.vehicle.period_s - 1 / config.pilot.command_hz;
}

std::string detail_of(const GuardDecision& decision)
{
    if (decision.limiting_distance_m <= 0) return {};
    const double left_deg = decision.limiting_bearing_rad * 180 / M_PI;
    std::array<char, 40> text{};
    std::snprintf(
        text.data(), text.size(), ", %.1f m at %.0f deg %s", decision.limiting_distance_m,
        std::abs(left_deg), left_deg < 0 ? "right" : "left");
    return text.data();
}

bool is_warning(GuardReason reason)
{
    return reason != GuardReason::Free && reason != GuardReason::Guided &&
           reason != GuardReason::Slowed;
}
}  // namespace

void PilotOptions::validate() const
{
    require(command_hz >= 2 && command_hz <= 100, "command_hz", command_hz, "2 to 100");
    require(
        max_motion_age_s >= 0.05 && max_motion_age_s <= 1, "max_motion_age_s", max_motion_age_s,
        "0.05 to 1");
}

GuardedPilot::GuardedPilot(const OnboardConfig& config, AutopilotThread& autopilot)
    : config_(config),
      autopilot_(autopilot),
      watch_(longest_stall_s(config)),
      feed_(config.run.slam),
      guard_(config.run.vehicle, config.run.guard)
{
    if (!config_.pilot.enabled) return;
    deciding_ = std::thread([this] { decideOnAndOn(); });
    sending_ = std::thread([this] { sendOnAndOn(); });
}

GuardedPilot::~GuardedPilot()
{
    end();
}

void GuardedPilot::end()
{
    ends_ = true;
    if (deciding_.joinable()) deciding_.join();
    if (sending_.joinable()) sending_.join();
}

void GuardedPilot::take(
    const mrpt::obs::CObservation2DRangeScan& scan, double sweep_s, const ScanReport& report,
    double pose_s)
{
    if (!config_.pilot.enabled) return;
    mavlink::ObstacleDistance obstacles;
    {
        const std::lock_guard lock(mutex_);
        const MapPose pose = GuardFeed::poseOf(report, pose_s);
        const GuardScan& taken = feed_.scanOf(scan, sweep_s);
        feed_.add(pose);
        guard_.observe(taken, pose);
        obstacles = obstacle_distance(taken, config_.run.guard.no_return_is_free);
    }
    autopilot_.send(obstacles);
}

GuardedPilot::Report GuardedPilot::report() const
{
    const std::lock_guard lock(mutex_);
    Report report = report_;
    report.stalls = watch_.stalls();
    return report;
}

void GuardedPilot::decideOnAndOn()
{
    mrpt::system::thread_name("guard");
    every(
        1 / config_.pilot.command_hz, ends_,
        [this]
        {
            const double now_s = unix_time_s();
            watch_.put(decide(now_s), now_s);
        });
}

void GuardedPilot::sendOnAndOn()
{
    mrpt::system::thread_name("guard_watchdog");
    every(
        1 / config_.pilot.command_hz, ends_,
        [this]
        {
            const double now_s = unix_time_s();
            send(watch_.take(now_s), now_s);
        });
    autopilot_.send(velocity_target({0, 0}, 0, 0, unix_time_s()));
}

GuardCommand GuardedPilot::decide(double now_s)
{
    const AutopilotNews news = autopilot_.news();
    const auto wish = pilot_wish(news, config_.stick, now_s);
    const bool knows_north = news.attitude.isYoungerThan(config_.pilot.max_motion_age_s, now_s);
    const bool can_fly = wish && knows_north;
    const GuardDecision decision = ask(can_fly ? *wish : PilotWish(), news, now_s);
    GuardCommand command;
    if (can_fly)
    {
        command.target = velocity_target(
            decision.velocity_vehicle, wish->yaw_rate_radps, news.attitude.message.yaw, now_s);
        command.state = name_of(decision.reason);
        command.detail = detail_of(decision);
        command.is_warning = is_warning(decision.reason);
    }
    else
    {
        command.target = velocity_target({0, 0}, 0, 0, now_s);
        command.state = wish ? "NO_ATTITUDE" : "NO_STICK";
    }
    return command;
}

/// Asked in any case, so that the guard knows the motion; without one it says NO_DATA.
GuardDecision GuardedPilot::ask(const PilotWish& wish, const AutopilotNews& news, double now_s)
{
    VehicleMotion unknown;
    unknown.yaw_rate_radps = std::numeric_limits<double>::quiet_NaN();
    const std::lock_guard lock(mutex_);
    auto motion = motion_of(news, config_.pilot.max_motion_age_s, now_s);
    if (!motion) motion = feed_.motion(now_s);
    const double began_s = thread_processor_time_s();
    const GuardDecision decision =
        guard_.decide(now_s, wish.velocity_vehicle, motion.value_or(unknown));
    report_.slowest_decision_ms =
        std::max(report_.slowest_decision_ms, 1e3 * (thread_processor_time_s() - began_s));
    ++report_.reasons[static_cast<std::size_t>(decision.reason)];
    ++report_.decisions;
    return decision;
}

void GuardedPilot::send(const GuardCommand& command, double now_s)
{
    autopilot_.send(command.target);
    if (command.state == told_state_ || now_s < next_text_s_) return;
    constexpr int warning = 4, information = 6;
    autopilot_.say(
        command.is_warning ? warning : information, "Guard: " + command.state + command.detail);
    told_state_ = command.state;
    next_text_s_ = now_s + kBetweenTexts_s;
}
}  // namespace rtob

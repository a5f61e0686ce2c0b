// SPDX-License-Identifier: BSD-3-Clause
#include "autopilot_thread.h"

#include <mrpt/system/thread_name.h>
#include <rtob/drivers/back_off.h>
#include <rtob/drivers/byte_link.h>
#include <rtob/drivers/unix_time.h>

#include "run/run_counters.h"

namespace rtob
{
namespace
{
constexpr std::chrono::milliseconds kLinkStep{5};

}  // namespace

AutopilotThread::AutopilotThread(const AutopilotOptions& options, Sink sink)
    : options_(options), sink_(std::move(sink)), autopilot_(options)
{
    if (!options_.link.empty()) thread_ = std::thread([this] { live(); });
}

AutopilotThread::~AutopilotThread()
{
    ends_ = true;
    if (thread_.joinable()) thread_.join();
}

void AutopilotThread::tell(const ScanReport& report, double pose_s)
{
    const std::lock_guard lock(mutex_);
    if (report.state == TrackingState::Tracking)
        autopilot_.matched(pose_s, report.pose_map_vehicle, report.covariance);
    else if (is_lost(report.state))
        autopilot_.lost();
}

void AutopilotThread::say(int severity, const std::string& text)
{
    const std::lock_guard lock(mutex_);
    if (!options_.link.empty()) autopilot_.say(severity, text);
}

AutopilotNews AutopilotThread::news() const
{
    const std::lock_guard lock(mutex_);
    return autopilot_.news();
}

AutopilotThread::Report AutopilotThread::report() const
{
    const std::lock_guard lock(mutex_);
    return {
        problem_, autopilot_.counters(), autopilot_.posesSent(),
        autopilot_.hearsHeartbeat(unix_time_s()), autopilot_.timeSync().isSynchronised()};
}

void AutopilotThread::live()
{
    mrpt::system::thread_name("autopilot");
    BackOff back_off;
    while (!ends_)
    {
        try
        {
            talk();
        }
        catch (const PortError& error)
        {
            const std::lock_guard lock(mutex_);
            problem_ = error.what();
            is_open_ = false;
            static_cast<void>(autopilot_.takeBytes());
        }
        back_off.failed(BackOff::Clock::now());
        while (!ends_ && !back_off.mayTry(BackOff::Clock::now()))
            std::this_thread::sleep_for(kLinkStep);
    }
}

/// Until the end, or until the link breaks.
void AutopilotThread::talk()
{
    const auto link = open_link(options_.link, options_.baud);
    {
        const std::lock_guard lock(mutex_);
        problem_.clear();
        is_open_ = true;
    }
    while (!ends_)
    {
        const Bytes received = link->read(kLinkStep);
        Bytes to_send;
        std::vector<mrpt::obs::CObservation::Ptr> observations;
        {
            const std::lock_guard lock(mutex_);
            autopilot_.receive(received, unix_time_s());
            autopilot_.poll(unix_time_s());
            to_send = autopilot_.takeBytes();
            observations = autopilot_.takeObservations();
        }
        for (auto& observation : observations) sink_(std::move(observation));
        link->write(to_send);
    }
    const std::lock_guard lock(mutex_);
    link->write(autopilot_.takeBytes());  // what was said last
}
}  // namespace rtob

// SPDX-License-Identifier: BSD-3-Clause
#include "live_run.h"

#include <mrpt/system/thread_name.h>
#include <rtob/core/enum_names.h>
#include <rtob/core/processor_time.h>
#include <rtob/drivers/unix_time.h>

#include <cstdlib>

#include "run/peak_memory.h"
#include "state_stream.h"

namespace rtob
{
namespace
{
using Clock = std::chrono::steady_clock;

/// Beside the scans, the fast small things: a second of an IMU at 1 kHz.
constexpr std::size_t kMostObservations = 1000;
constexpr std::chrono::milliseconds kMainStep{50};
constexpr std::chrono::milliseconds kPatienceAtEnd{3000};

double seconds(Clock::duration duration)
{
    return std::chrono::duration<double>(duration).count();
}

/// Everything that lives while the program flies. What comes later in this list hands to what comes
/// before it, and ends before it.
class LiveRun
{
 public:
    LiveRun(
        const OnboardConfig& config, const mrpt::config::CConfigFileBase& ini, std::string folder)
        : config_(config),
          folder_(std::move(folder), true),
          capture_(config.capture, folder_.path()),
          scan_files_(folder_),
          stream_(config.stream),
          localiser_(config.run),
          queue_(
              static_cast<std::size_t>(config.onboard.max_waiting_scans), kMostObservations,
              [this](const QueuedObservation& item) { capture_.add(item); }),
          autopilot_(
              config.autopilot,
              [this](auto observation)
              {
                  if (!ends_) queue_.push(observation);  // or the queue would never be empty
              }),
          pilot_(config, autopilot_),
          localising_([this] { localise(); })
    {
        for (const auto& section : config.sensors)
            sensors_.push_back(SensorRunner::start(
                ini, section, [this](auto observation) { queue_.push(observation); }));
    }

    /// @return whether every driver has ended
    bool end()
    {
        pilot_.end();
        for (const auto& sensor : sensors_) sensor->askToEnd();
        bool all_ended = true;
        for (const auto& sensor : sensors_) all_ended &= sensor->waitForEnd(kPatienceAtEnd);
        ends_ = true;
        localising_.join();
        capture_.finish();
        return all_ended;
    }

    void report(std::ostream& log)
    {
        for (const auto& sensor : sensors_) announce(log, sensor->report());
        announce(log, "capture", capture_.state().problem);
        announce(log, "autopilot", autopilot_.report().problem);
    }
    void status(std::ostream& log)
    {
        const std::lock_guard lock(mutex_);
        log << name_of(summary_.final_state) << ", " << summary_.counters.scans()
            << " scans localised, " << queue_.droppedScans() << " dropped, "
            << 1e-6 * static_cast<double>(capture_.state().bytes) << " MB captured" << std::endl;
    }

    LiveSummary results()
    {
        LiveSummary& summary = summary_;
        summary.folder = folder_.path();
        summary.dropped_scans = queue_.droppedScans();
        summary.capture = capture_.state();
        summary.autopilot = autopilot_.report();
        if (config_.pilot.enabled) summary.pilot = pilot_.report();
        for (const auto& sensor : sensors_) summary.sensors.push_back(sensor->report());
        summary.fusion = sensor_figures(localiser_.slam().motion());
        summary.map_points = localiser_.slam().map().size();
        summary.map_scans = localiser_.slam().map().scans().size();
        summary.run_s = seconds(Clock::now() - begin_);
        summary.cpu_s = process_processor_time_s();
        summary.memory_mb = peak_memory_mb();
        write_live_results(folder_, config_, localiser_, scan_files_, summary);
        return summary;
    }

 private:
    /// Until the end, and until the queue is empty then.
    void localise()
    {
        mrpt::system::thread_name("localise");
        for (;;)
        {
            const bool ends = ends_;
            const auto item = queue_.pop(kMainStep);
            if (item)
                take(*item);
            else if (ends)
                return;
        }
    }

    /// First the log: what is in it has been used, or is marked as dropped.
    void take(const QueuedObservation& item)
    {
        capture_.add(item);
        if (item.is_dropped) return;
        const ScanReport* report = localiser_.take(*item.observation);
        if (report == nullptr) return;
        const double latency_s = unix_time_s() - localiser_.lastBeamTime();
        autopilot_.tell(*report, localiser_.poseTime());
        if (const auto* scan =
                dynamic_cast<const mrpt::obs::CObservation2DRangeScan*>(item.observation.get()))
            pilot_.take(*scan, localiser_.sweep(), *report, localiser_.poseTime());
        tellState(*report);
        const std::lock_guard lock(mutex_);
        summary_.counters.add(*report);
        summary_.final_state = report->state;
        summary_.latencies_ms.push_back(static_cast<float>(1e3 * latency_s));
        stream_.publish(
            state_line({*report, latency_s, summary_.counters.scans(), queue_.droppedScans()}));
        capture_.add(pose_observation(*report, localiser_.poseTime()));
        scan_files_.add(*report);
    }

    void tellState(const ScanReport& report)
    {
        if (report.state == told_state_) return;
        constexpr int warning = 4, information = 6;
        const bool is_bad = is_lost(report.state) || report.state == TrackingState::Degraded;
        autopilot_.say(
            is_bad ? warning : information, "RTOB-SLAM: " + std::string(name_of(report.state)));
        told_state_ = report.state;
    }

    void announce(std::ostream& log, const SensorReport& sensor)
    {
        auto& known = known_devices_[sensor.name];
        if (sensor.device != known)
            log << sensor.name << ": " << (known = sensor.device) << std::endl;
        announce(log, sensor.name, sensor.problem);
    }
    void announce(std::ostream& log, const std::string& who, const std::string& problem)
    {
        std::string& known = known_problems_[who];
        if (problem == known) return;
        known = problem;
        log << who << ": " << (problem.empty() ? "all is well again" : problem) << std::endl;
        if (!problem.empty()) autopilot_.say(4, who + ": " + problem);
    }

    const OnboardConfig& config_;
    Clock::time_point begin_ = Clock::now();
    OutputFolder folder_;
    Capture capture_;
    ScanFiles scan_files_;
    StateStream stream_;
    Localiser localiser_;
    std::mutex mutex_;  ///< guards the summary, which the status shows
    LiveSummary summary_;
    TrackingState told_state_ = TrackingState::Init;
    std::map<std::string, std::string> known_problems_, known_devices_;
    std::atomic<bool> ends_{false};
    ObservationQueue queue_;
    AutopilotThread autopilot_;
    GuardedPilot pilot_;
    std::thread localising_;
    std::vector<std::shared_ptr<SensorRunner>> sensors_;
};
}  // namespace

LiveSummary run_live(
    const OnboardConfig& config, const mrpt::config::CConfigFileBase& ini, std::ostream& log,
    const std::function<bool()>& stop)
{
    const auto run =
        std::make_shared<LiveRun>(config, ini, make_flight_folder(config.onboard.output_folder));
    auto next_status = Clock::now();
    while (!stop())
    {
        run->report(log);
        if (config.onboard.status_period_s > 0 && Clock::now() >= next_status)
        {
            run->status(log);
            next_status +=
                std::chrono::milliseconds(std::lround(1000 * config.onboard.status_period_s));
        }
        std::this_thread::sleep_for(kMainStep);
    }
    const bool all_ended = run->end();
    LiveSummary summary = run->results();
    if (!all_ended)
    {
        log << "a driver does not end; going without it\n" << live_line(summary) << std::endl;
        std::_Exit(is_lost(summary.final_state) ? 3 : 0);
    }
    return summary;
}
}  // namespace rtob

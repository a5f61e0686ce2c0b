// SPDX-License-Identifier: BSD-3-Clause
#include "run/offline_run.h"

#include <mrpt/obs/CObservationOdometry.h>
#include <rtob/io/scan_timing.h>

namespace rtob
{
namespace
{
using mrpt::obs::CObservation2DRangeScan;
using mrpt::obs::CObservationOdometry;

class LogFeed
{
 public:
    LogFeed(Slam& slam, const RunLimits& limits, const ScanDone& done, OfflineRun& run)
        : slam_(slam), sensor_(slam.options().sensor), limits_(limits), done_(done), run_(run)
    {
    }

    [[nodiscard]] bool full() const { return run_.scans >= limits_.first_scans; }

    void take(const LogEntry& entry)
    {
        if (entry.motion)
            takeMotion(*entry.motion);
        else if (wasDropped(*entry.observation))
            return;
        else if (
            const auto* scan =
                dynamic_cast<const CObservation2DRangeScan*>(entry.observation.get()))
            takeScan(*scan);
        else
            takeOther(*entry.observation);
    }

 private:
    [[nodiscard]] bool skipping() const { return run_.scans_skipped < limits_.skip_scans; }

    /// What a live program had no time for, it did not use: nor does a replay.
    [[nodiscard]] bool wasDropped(const mrpt::obs::CObservation& observation)
    {
        const bool next_was_dropped = next_was_dropped_;
        next_was_dropped_ = is_dropped_record(observation);
        run_.dropped_live += next_was_dropped_;
        return next_was_dropped || next_was_dropped_;
    }

    void takeMotion(const mrpt::obs::CActionRobotMovement2D& motion)
    {
        if (limits_.use_odometry && !skipping()) slam_.observe(motion);
    }

    void takeScan(const CObservation2DRangeScan& scan)
    {
        constexpr std::size_t labels_kept = 8;
        if (!sensor_.uses(scan))
        {
            ++run_.scans_of_other_lasers;
            if (run_.other_labels.size() < labels_kept) run_.other_labels.insert(scan.sensorLabel);
        }
        else if (skipping())
            ++run_.scans_skipped;
        else
        {
            const ScanReport& report = slam_.process(scan);
            ++run_.scans;
            done_(scan, report);
        }
    }

    void takeOther(const mrpt::obs::CObservation& observation)
    {
        ++run_.other_observations;
        const bool is_odometry = dynamic_cast<const CObservationOdometry*>(&observation) != nullptr;
        if (skipping() || (is_odometry && !limits_.use_odometry)) return;
        static_cast<void>(slam_.observe(observation));
    }

    Slam& slam_;
    SensorChoice sensor_;
    const RunLimits& limits_;
    const ScanDone& done_;
    OfflineRun& run_;
    bool next_was_dropped_ = false;
};
}  // namespace

OfflineRun run_log(
    LogReader& log, Slam& slam, const RunLimits& limits, const ScanDone& done,
    const std::function<bool()>& stop)
{
    OfflineRun run;
    LogFeed feed(slam, limits, done, run);
    while (run.end == RunEnd::LogEnd)
    {
        std::optional<LogEntry> entry;
        try
        {
            entry = log.next();
        }
        catch (const LogError& error)
        {
            run.end = RunEnd::DamagedLog;
            run.damage = error.what();
            break;
        }
        if (!entry) break;
        feed.take(*entry);
        if (feed.full())
            run.end = RunEnd::Limit;
        else if (stop())
            run.end = RunEnd::Stopped;
    }
    return run;
}

std::string no_scans_message(const std::string& log, const OfflineRun& run)
{
    if (run.end == RunEnd::DamagedLog) return run.damage;
    if (run.end == RunEnd::Stopped) return log + ": stopped before its first scan.";
    if (run.scans_skipped > 0)
        return log + ": --skip leaves nothing, the log has only " +
               std::to_string(run.scans_skipped) + " scans.";
    if (run.scans_of_other_lasers > 0)
    {
        std::string labels;
        for (const auto& label : run.other_labels)
            labels += (labels.empty() ? "'" : ", '") + label + "'";
        return log + ": none of its " + std::to_string(run.scans_of_other_lasers) +
               " scans is of a laser that [Sensor] labels names. The log's lasers: " + labels + ".";
    }
    return log + ": the log holds no 2D laser scan (" + std::to_string(run.other_observations) +
           " other observations). Name a log with CObservation2DRangeScan entries, or FLASER or "
           "ROBOTLASER1 lines.";
}
}  // namespace rtob

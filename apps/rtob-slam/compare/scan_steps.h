// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/core/map_clock.h>
#include <rtob/io/log_reader.h>
#include <rtob/map/angle_mask.h>
#include <rtob/slam/sensor_choice.h>

#include <memory>
#include <optional>
#include <string>

#include "compare/variant.h"
#include "run/offline_run.h"
#include "run/run_options.h"

namespace rtob
{
/// Reads a log as the comparison gives it to each program: the chosen lasers' scans, in the order
/// of the log, with the configured mount; beams that our own filter would drop are invalid for
/// everybody; the newest odometry comes with the scan that follows it.
class ScanSteps
{
 public:
    /// Throws LogError for a log that cannot be opened.
    ScanSteps(const std::string& log, const RunConfig& config, const RunLimits& limits);

    /// Nothing at the end: of the log, of as many scans as asked, or where the log is damaged.
    [[nodiscard]] std::optional<ScanStep> next();

    /// What was read so far, and how it ended.
    [[nodiscard]] const OfflineRun& read() const { return read_; }

 private:
    void takeOdometry(const LogEntry& entry);
    [[nodiscard]] std::optional<ScanStep> takeScan(
        const mrpt::obs::CObservation2DRangeScan::Ptr& scan);
    void prepare(mrpt::obs::CObservation2DRangeScan& scan) const;
    [[nodiscard]] bool skipping() const { return read_.scans_skipped < limits_.skip_scans; }

    std::unique_ptr<LogReader> log_;
    RunLimits limits_;
    ScanFilterOptions filter_;
    AngleMask mask_;
    SensorChoice sensor_;
    MapClock clock_;
    std::optional<Pose2> pose_odom_vehicle_;
    bool odometry_is_new_ = false;
    OfflineRun read_;
};
}  // namespace rtob

// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/obs/CObservationOdometry.h>
#include <rtob/io/log_contents.h>
#include <rtob/io/log_writer.h>
#include <rtob/io/text_file.h>

namespace rtob
{
/// A CARMEN text log: each scan a ROBOTLASER1 line (of the log's first laser) or a ROBOTLASER2 line
/// (of its second), each odometry an ODOM line. A laser line carries the last odometry before it,
/// as far as there is any, and through it the laser's mount.
///
/// CARMEN's beams run counter-clockwise, so the beams of clockwise scans are turned round. It has
/// no validity: invalid beams within the range are written as 0.
class CarmenWriter : public LogWriter
{
 public:
    /// `contents` is what will be written. Throws std::runtime_error where CARMEN cannot hold it:
    /// no scans, more than two lasers, a laser that is tilted or moves on the vehicle.
    CarmenWriter(const std::string& file, LogContents contents);

    void write(const LogEntry& entry) override;
    void commit() override { out_.commit(); }

 private:
    void writeHeader();
    void writeScan(const mrpt::obs::CObservation2DRangeScan& scan);
    void writeOdometry(const mrpt::obs::CObservationOdometry& odometry);
    void writeEnd(std::int64_t stamp_100ns);
    [[nodiscard]] std::int64_t stampOf(const mrpt::obs::CObservation& observation);

    LogContents contents_;
    TextFile out_;
    Pose2 pose_odom_vehicle_;
    bool odometry_is_known_ = false;
    std::optional<std::int64_t> first_stamp_100ns_;
    std::int64_t last_stamp_100ns_ = 0;
};
}  // namespace rtob

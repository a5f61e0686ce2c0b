// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/check/check_log.h>

#include <functional>

#include "drive_log.h"
#include "house.h"
#include "log_files.h"

/// Logs of a drive through house(), ten scans a second, clean but for what a test spoils.
namespace rtob::test
{
struct CheckDrive
{
    int scans = house_lap_scans;
    std::function<int(int scan)> place = [](int scan) { return scan; };  ///< on the lap
    std::function<void(mrpt::obs::CObservation2DRangeScan&, int scan)> spoil_scan;
    /// What the odometry makes of a true step; 2 % too much turn, as wheels do.
    std::function<Pose2(const Pose2& step)> odometry = [](const Pose2& step) {
        return Pose2{step.x, step.y, 1.02 * step.yaw};
    };
    bool has_odometry = true;
    int odometry_ahead_scans = 0;  ///< it is that much newer than the scan
};

/// 5 mm on each range, so that no scan repeats another.
inline void add_noise(mrpt::obs::CObservation2DRangeScan& scan, Random& random)
{
    for (std::size_t i = 0; i < scan.getScanSize(); ++i)
        if (scan.getScanRangeValidity(i))
            scan.setScanRange(
                i, scan.getScanRange(i) + static_cast<float>(gaussian(random, 0.005)));
}

[[nodiscard]] inline LogObjects objects_of(const CheckDrive& drive)
{
    LogObjects objects;
    const auto pose = [&](int scan) { return pose_in_house(drive.place(std::max(0, scan))); };
    Random random(1);
    Pose2 pose_odom_vehicle;
    for (int k = 0; k < drive.scans; ++k)
    {
        const double stamp_s = 1000 + 0.1 * k;
        const int now = k + drive.odometry_ahead_scans;
        pose_odom_vehicle =
            compose(pose_odom_vehicle, drive.odometry(between(pose(now - 1), pose(now))));
        auto odometry = mrpt::obs::CObservationOdometry::Create();
        odometry->timestamp = mrpt::Clock::fromDouble(stamp_s);
        odometry->odometry = {pose_odom_vehicle.x, pose_odom_vehicle.y, pose_odom_vehicle.yaw};
        if (drive.has_odometry) objects.push_back(odometry);
        auto scan = mrpt::obs::CObservation2DRangeScan::Create(
            scan_observation(house(), pose(k), stamp_s, mrpt_laser()));
        add_noise(*scan, random);
        if (drive.spoil_scan) drive.spoil_scan(*scan, k);
        objects.push_back(scan);
    }
    return objects;
}

[[nodiscard]] inline CheckReport check_objects(const LogObjects& objects)
{
    const TemporaryFile log(".rawlog", rawlog_bytes(objects));
    return check_log(log.path());
}

[[nodiscard]] inline CheckReport check_drive(const CheckDrive& drive)
{
    return check_objects(objects_of(drive));
}

/// "FAIL id, WARN id, ..." of all that is not PASS.
[[nodiscard]] inline std::string troubles(const CheckReport& report)
{
    std::string text;
    for (const auto& finding : report.findings)
        if (finding.severity != Severity::Pass)
            text += std::string(text.empty() ? "" : ", ") +
                    (finding.severity == Severity::Fail ? "FAIL " : "WARN ") + finding.id;
    return text;
}

/// A figure of a finding; fails the test where there is none.
[[nodiscard]] inline double figure(
    const CheckReport& report, const std::string& id, const std::string& name)
{
    const Finding* finding = report.find(id);
    if (finding)
        for (const auto& [key, value] : finding->values)
            if (key == name) return value;
    ADD_FAILURE() << "no figure " << name << " of a finding " << id;
    return 0;
}
}  // namespace rtob::test

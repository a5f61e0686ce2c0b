// SPDX-License-Identifier: BSD-3-Clause
#include "odometry_findings.h"

#include <algorithm>
#include <cmath>

#include "figures.h"

namespace rtob
{
namespace
{
constexpr double kLate_scans = 0.8;
constexpr double kAgrees = 0.5;  // correlation of turns that speak of one drive
constexpr double kScaleOff = 0.04, kScaleWrong = 0.4;
constexpr double kSure = 3;                      // standard deviations
constexpr double kDrift_deg = 5, kWild_deg = 5;  // over 10 m
constexpr double kMissingReverse_m = 0.3;        // more than single mismatches
constexpr double kMountOff_deg = 5;

/// "4.1 % more than", "2.0 % less than"
std::string against(double scale)
{
    return percent(std::abs(scale - 1)) + (scale >= 1 ? " more than" : " less than");
}

bool is_off(const Estimate& scale)
{
    const double off = std::abs(scale.value - 1);
    return off > kScaleOff && off > kSure * scale.deviation;
}

void suggest_mount(
    CheckReport& report, const Pose2& pose_vehicle_laser, const char* key, const std::string& value,
    const std::string& reason)
{
    const std::string kept = "as in the log";
    report.suggestions.push_back({"Sensor", "override_mount", "true", reason});
    report.suggestions.push_back({"Sensor", key, value, reason});
    report.suggestions.push_back({"Sensor", "mount_x_m", fixed(pose_vehicle_laser.x, 3), kept});
    report.suggestions.push_back({"Sensor", "mount_y_m", fixed(pose_vehicle_laser.y, 3), kept});
}
}  // namespace

void report_time_shift(
    CheckReport& report, const std::optional<TimeShift>& shift, double interval_s)
{
    if (!shift) return;
    Finding finding;
    finding.id = "odometry.lag";
    finding.values = {
        {"laser_after_odometry_scans", shift->scans},
        {"laser_after_odometry_s", shift->scans * interval_s},
        {"agreement", shift->agreement}};
    const std::string amount = fixed(std::abs(shift->scans), 1) + " scans (" +
                               fixed(std::abs(shift->scans) * interval_s, 2) + " s)";
    if (std::abs(shift->scans) < 0.05)
        finding.text = "odometry and laser show turns at the same time";
    else
        finding.text = "the laser shows a turn " + amount +
                       (shift->scans > 0 ? " after" : " before") + " the odometry";
    if (shift->agreement < kAgrees)
    {
        finding.severity = Severity::Fail;
        finding.text = "the turns of odometry and laser have nothing in common (correlation " +
                       fixed(shift->agreement, 2) + ")";
        finding.fix =
            "Odometry and scans are not of one drive, or the odometry is broken: leave "
            "it aside, see the suggested .ini";
        report.suggestions.push_back(
            {"Run", "use_odometry", "false", "its turns are not those of the laser"});
    }
    else if (std::abs(shift->scans) > kLate_scans)
    {
        finding.severity = Severity::Warn;
        finding.fix =
            "Guesses from this odometry are off in every turn. Correct the stamps at the "
            "source; run bridges it by matching each scan, steps by odometry alone do not";
    }
    report.findings.push_back(std::move(finding));
}

bool is_mirrored(const TimeShift& shift)
{
    return shift.sign < 0 && shift.agreement >= kAgrees;
}

void report_mirror(CheckReport& report, const Pose2& pose_vehicle_laser)
{
    Finding finding;
    finding.severity = Severity::Fail;
    finding.id = "odometry.sign";
    finding.text = "the laser turns left when the odometry turns right";
    finding.fix =
        "The beams run clockwise and the log does not say so, or the laser hangs upside "
        "down: see the suggested .ini. Otherwise the odometry counts yaw clockwise";
    suggest_mount(
        report, pose_vehicle_laser, "upside_down", "true", "laser and odometry turn opposite ways");
    report.findings.push_back(std::move(finding));
}

void report_turns(CheckReport& report, const std::optional<TurnFit>& fit)
{
    if (!fit) return;
    const Estimate& scale = fit->scale;
    Finding finding;
    finding.id = "odometry.rotation_scale";
    finding.values = {
        {"scale", scale.value},
        {"deviation", scale.deviation},
        {"drift_deg_per_10_m", fit->drift_rad_per_m * 10 * kRadToDeg}};
    finding.text = "the odometry turns " + against(scale.value) + " the laser (+- " +
                   percent(scale.deviation) + ")";
    if (is_off(scale))
    {
        finding.severity = Severity::Warn;
        finding.fix = "Calibrate the distance between the wheels (or the gyro's scale)";
    }
    if (std::abs(scale.value - 1) > kScaleWrong)
    {
        finding.severity = Severity::Fail;
        finding.fix =
            "One of the two is in a wrong unit, or the beams have a wrong aperture: twice "
            "the laser's turn means half the true aperture";
    }
    report.findings.push_back(std::move(finding));
}

void report_travel(CheckReport& report, const std::optional<Estimate>& scale)
{
    if (!scale) return;
    Finding finding;
    finding.id = "odometry.travel_scale";
    finding.values = {{"scale", scale->value}, {"deviation", scale->deviation}};
    finding.text = "the odometry travels " + against(scale->value) + " the laser (+- " +
                   percent(scale->deviation) + ")";
    if (is_off(*scale))
    {
        finding.severity = Severity::Warn;
        finding.fix = "Calibrate the wheels' diameter";
    }
    if (std::abs(scale->value - 1) > kScaleWrong)
    {
        finding.severity = Severity::Fail;
        finding.fix =
            "One of the two is in a wrong unit, or the laser looks another way than its "
            "mount says: see odometry.mount";
    }
    report.findings.push_back(std::move(finding));
}

void report_heading(CheckReport& report, const std::optional<HeadingErrors>& errors)
{
    if (!errors) return;
    const double steady_deg = errors->steady_rad * kRadToDeg;
    const double random_deg = errors->random_rad * kRadToDeg;
    const double worst_deg = errors->worst_rad * kRadToDeg;
    const bool drifts = std::abs(steady_deg) > kDrift_deg, is_wild = random_deg > kWild_deg;
    Finding finding;
    finding.id = "odometry.heading";
    finding.values = {
        {"steady_deg_per_10_m", steady_deg},
        {"random_deg_per_10_m", random_deg},
        {"worst_deg_per_10_m", worst_deg}};
    finding.text = "over 10 m the odometry's heading leaves the laser's by " +
                   fixed(steady_deg, 1) + " deg steadily and " + fixed(random_deg, 1) +
                   " deg at random, at worst " + fixed(worst_deg, 1);
    if (drifts || is_wild)
    {
        finding.severity = Severity::Warn;
        finding.text += is_wild ? ": it drifts wildly" : ": it drifts";
        finding.fix = "Good from scan to scan, not over a path: never judge a map by this odometry";
        finding.fix += drifts ? "; a steady part can be calibrated away (the wheels' diameters "
                                "against each other, or the gyro's zero)"
                              : ", nor bridge lost stretches with it";
    }
    report.findings.push_back(std::move(finding));
}

void report_reverse(CheckReport& report, const ReverseDriving& reverse)
{
    Finding finding;
    finding.id = "odometry.reverse";
    finding.values = {
        {"laser_steps_back", static_cast<double>(reverse.laser)},
        {"odometry_agrees", static_cast<double>(reverse.odometry)},
        {"odometry_says_forward", static_cast<double>(reverse.forward)},
        {"wrong_m", reverse.forward_m}};
    finding.text = "the laser sees " + counted(reverse.laser, "step") +
                   " back, the odometry agrees in " + std::to_string(reverse.odometry);
    const bool is_missing =
        reverse.forward_m > kMissingReverse_m && 10 * reverse.odometry_ever < reverse.forward;
    if (is_missing)
    {
        finding.severity = Severity::Warn;
        finding.text = "the odometry never drives backwards: it reports " +
                       counted(reverse.forward, "step") + " back (" + fixed(reverse.forward_m, 1) +
                       " m) as steps ahead";
        finding.fix =
            "Repair the sign of the odometry at the source; programs that step by "
            "odometry between matched scans fail there, run matches every scan";
    }
    report.findings.push_back(std::move(finding));
}

void report_mount(
    CheckReport& report, const std::optional<Estimate>& turn, const Pose2& pose_vehicle_laser)
{
    if (!turn) return;
    const double turn_deg = turn->value * kRadToDeg;
    Finding finding;
    finding.id = "odometry.mount";
    finding.values = {{"turn_deg", turn_deg}, {"deviation_deg", turn->deviation * kRadToDeg}};
    finding.text = "straight drives agree with the mount's direction to " +
                   fixed(std::abs(turn_deg), 1) + " deg";
    const bool is_turned =
        std::abs(turn_deg) > kMountOff_deg && std::abs(turn->value) > kSure * turn->deviation;
    if (is_turned)
    {
        finding.severity = Severity::Fail;
        finding.text = "where the odometry drives straight ahead the laser drives " +
                       fixed(std::abs(turn_deg), 1) + " deg to the " +
                       (turn_deg > 0 ? "right" : "left") + ": its mount is turned";
        finding.fix = "Turn the mount, see the suggested .ini";
        suggest_mount(
            report, pose_vehicle_laser, "mount_yaw_deg", fixed(turn_deg, 1),
            "straight drives say that the mount is turned by this");
    }
    report.findings.push_back(std::move(finding));
}

void report_origin(CheckReport& report, const OdometryFigures& figures)
{
    constexpr double long_path_m = 30;
    constexpr double in_step_scans = 0.15, exact_scale = 0.01, exact_deg = 1.5;
    const auto& [shift, turns, travel, heading, path_m] = figures;
    if (!turns || !travel || !heading || path_m < long_path_m) return;
    const bool is_exact = std::abs(shift.scans) < in_step_scans &&
                          std::abs(turns->scale.value - 1) < exact_scale &&
                          std::abs(travel->value - 1) < exact_scale &&
                          std::abs(heading->steady_rad) * kRadToDeg < exact_deg &&
                          heading->random_rad * kRadToDeg < exact_deg;
    Finding finding;
    finding.id = "odometry.origin";
    finding.text = "the odometry errs as wheels do";
    if (is_exact)
    {
        finding.severity = Severity::Warn;
        finding.text =
            "the odometry is as good as the laser itself: poses that a SLAM program or "
            "a simulator made, not wheels";
        finding.fix =
            "Such a log proves nothing of a SLAM program that is given them: run with "
            "--no-odometry, too";
    }
    report.findings.push_back(std::move(finding));
}
}  // namespace rtob

// SPDX-License-Identifier: BSD-3-Clause
#include "carmen_survey.h"

#include <cmath>
#include <optional>

#include "line_source.h"

namespace rtob
{
namespace
{
constexpr double telling_distance_m = 1.0;
constexpr double same_distance_m = 0.005;
constexpr double same_angle_rad = 0.005;
constexpr double farthest_mount_m = 3.0;
constexpr double pi = 3.14159265358979323846;

double distance(const Pose2& a, const Pose2& b)
{
    return std::hypot(a.x - b.x, a.y - b.y);
}

/// The laser as seen from the odometry, watched over a stretch of the log.
class MountWatch
{
 public:
    void see(const Pose2& pose_odom_laser_seen)
    {
        if (!first_)
            first_ = pose_odom_laser_seen;
        else if (
            distance(*first_, pose_odom_laser_seen) > same_distance_m ||
            std::abs(wrap_angle(first_->yaw - pose_odom_laser_seen.yaw)) > same_angle_rad)
            constant_ = false;
    }

    [[nodiscard]] bool changed() const { return !constant_; }

    [[nodiscard]] std::optional<Pose2> mount() const
    {
        const bool plausible = first_ && distance(*first_, Pose2{}) < farthest_mount_m;
        return constant_ && plausible ? first_ : std::nullopt;
    }

 private:
    std::optional<Pose2> first_;
    bool constant_ = true;
};

class Survey
{
 public:
    /// False when enough is known.
    bool take(std::string_view line)
    {
        TextFields fields(line);
        const auto name = fields.next_word();
        if (name == "PARAM")
            take_parameter(fields);
        else if (laser_of_line(name, scan_.laser))
            take_scan(fields);
        return farthest_m_ < telling_distance_m;
    }

    [[nodiscard]] CarmenSurvey result() const
    {
        CarmenSurvey survey;
        survey.lasers_carry_odometry = lasers_carry_odometry_;
        for (const auto& watch : watches_) survey.is_corrected |= watch.changed();
        for (std::size_t i = 0; i < carmen_laser_count; ++i)
            survey.poses_vehicle_laser[i] = mount(static_cast<CarmenLaser>(i));
        return survey;
    }

 private:
    void take_parameter(TextFields& fields)
    {
        const auto name = fields.next_word();
        if (name == "robot_frontlaser_offset") front_offset_m_ = fields.finite_number("offset");
        if (name == "robot_rearlaser_offset") rear_offset_m_ = fields.finite_number("offset");
    }

    void take_scan(TextFields& fields)
    {
        parse_scan(fields, scan_);
        const Pose2& pose = scan_.pose_odom_vehicle;
        // A logger without odometry writes zeros to the end.
        if (pose.x != 0 || pose.y != 0 || pose.yaw != 0) lasers_carry_odometry_ = true;
        watches_[static_cast<std::size_t>(scan_.laser)].see(between(pose, scan_.pose_log_laser));
        if (!first_pose_) first_pose_ = pose;
        farthest_m_ = std::max(farthest_m_, distance(*first_pose_, pose));
    }

    [[nodiscard]] Pose2 mount(CarmenLaser laser) const
    {
        const auto seen = watches_[static_cast<std::size_t>(laser)].mount();
        if (laser == CarmenLaser::RobotFront || laser == CarmenLaser::RobotRear)
            return seen.value_or(Pose2{});
        // By convention the rear laser looks back; not all loggers turn its pose accordingly.
        const bool rear = laser == CarmenLaser::Rear;
        Pose2 pose_vehicle_laser{0, 0, rear ? -pi : 0};
        const auto& offset_m = rear ? rear_offset_m_ : front_offset_m_;
        if (seen) pose_vehicle_laser = {seen->x, seen->y, pose_vehicle_laser.yaw};
        if (offset_m) pose_vehicle_laser = {*offset_m, 0, pose_vehicle_laser.yaw};
        return pose_vehicle_laser;
    }

    CarmenScan scan_;
    std::array<MountWatch, carmen_laser_count> watches_;
    std::optional<double> front_offset_m_, rear_offset_m_;
    std::optional<Pose2> first_pose_;
    double farthest_m_ = 0;
    bool lasers_carry_odometry_ = false;
};
}  // namespace

CarmenSurvey survey_carmen_log(const std::string& file)
{
    Survey survey;
    try
    {
        LineSource lines(file);
        while (const auto line = lines.next())
            if (!survey.take(*line)) break;
    }
    catch (const ByteSourceError&)
    {
    }
    catch (const FieldError&)
    {
    }
    return survey.result();
}
}  // namespace rtob

// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/core/icp.h>
#include <rtob/core/pose2.h>
#include <rtob/fusion/motion_state.h>
#include <Eigen/Core>

#include <array>
#include <limits>
#include <optional>
#include <string_view>
#include <utility>

namespace rtob
{
/// Where a scan's first guess comes from, sec. 2.1.2.
enum class PrealignSource
{
    Auto,              ///< fusion once a gyro or optical flow is there, else odometry while it
                       ///< arrives, else constant velocity
    LastPose,          ///< the paper's first way
    ConstantVelocity,  ///< the last scan's motion goes on
    Odometry,          ///< odometry while it arrives, else the last pose
    Fusion             ///< the paper's second way: a Kalman filter of all motion sensors
};

constexpr auto enum_names(PrealignSource)
{
    return std::array<std::pair<PrealignSource, std::string_view>, 5>{
        {{PrealignSource::Auto, "auto"},
         {PrealignSource::LastPose, "last_pose"},
         {PrealignSource::ConstantVelocity, "constant_velocity"},
         {PrealignSource::Odometry, "odometry"},
         {PrealignSource::Fusion, "fusion"}}};
}

struct PrealignOptions
{
    PrealignSource source = PrealignSource::Auto;
    double max_speed_mps = 5;
    double max_turn_degps = 360;
    bool hold_to_odometry = true;

    template <class Self, class Visit>
    static void fields(Self& s, Visit&& visit)
    {
        visit("source", s.source, "what the first guess of a scan's pose comes from [sec. 2.1.2]");
        visit(
            "max_speed_mps", s.max_speed_mps,
            "constant velocity: a faster motion is not carried on; > 0");
        visit(
            "max_turn_degps", s.max_turn_degps,
            "constant velocity: a faster turn is not carried on; > 0");
        visit(
            "hold_to_odometry", s.hold_to_odometry,
            "stay where odometry that has been right so far says, as long as the scan fits there "
            "about as well as where it was matched");
    }
    void validate() const;
};

/// How much of the velocity that a match shows is to be believed, by direction in map: all of it,
/// but nothing along a bare corridor, where the pairs say nothing.
[[nodiscard]] Eigen::Matrix3d velocity_shown(const IcpResult& fit);

/// Predicts the pose of the next scan: pose_map_vehicle_init of eq. 2 and 3.
class Prealignment
{
 public:
    explicit Prealignment(const PrealignOptions& options = {});

    /// Odometry as a pose in its own frame (CObservationOdometry). What is no number is passed
    /// over.
    void addOdometry(const Pose2& pose_odom_vehicle);
    /// Odometry as the motion since the last one (CActionRobotMovement2D).
    void addMotion(const Pose2& pose_prev_now);

    /// @param stamp_s the scan's own.
    [[nodiscard]] Pose2 predict(double stamp_s) const;

    /// Of the vehicle from the last scan to this one, as predict() has it.
    [[nodiscard]] Twist2 twist(double stamp_s) const;

    /// To be called after each scan with the pose that was settled on.
    /// @param matched the pose was measured: only then does it give a velocity.
    /// @param believed how much of that velocity is new, by direction in map; the rest goes on as
    /// before.
    void settle(
        double stamp_s, const Pose2& pose_map_vehicle, bool matched,
        const Eigen::Matrix3d& believed = Eigen::Matrix3d::Identity());

    /// The last scan was elsewhere in the map, as old scans told; the velocity goes on.
    void correct(const Pose2& pose_map_vehicle) { pose_map_last_ = pose_map_vehicle; }

    /// Starts from here, at rest.
    void reset(const Pose2& pose_map_vehicle);

    /// Where the last scan was settled.
    [[nodiscard]] const Pose2& last() const { return pose_map_last_; }

    [[nodiscard]] bool hasOdometry() const { return odometry_now_.has_value(); }
    /// Whether predict() goes by odometry.
    [[nodiscard]] bool goesByOdometry() const;

    /// From the last scan to this one [s], as far as stamps are to be believed.
    [[nodiscard]] double stepTo(double stamp_s) const;

 private:
    void advanceTime(double stamp_s);
    [[nodiscard]] Pose2 carriedOn(double step_s) const;
    [[nodiscard]] Pose2 blended(const Pose2& measured, const Eigen::Matrix3d& believed) const;
    [[nodiscard]] Pose2 velocityOver(double step_s, const Pose2& pose_map_vehicle) const;

    PrealignOptions options_;
    Pose2 pose_map_last_;
    /// The last scan's own stamp, or later where stamps step back a little.
    double time_s_ = std::numeric_limits<double>::quiet_NaN();
    double usual_step_s_ = 0;  ///< the mean; 0: not known yet
    bool started_ = false;     ///< a scan or a reset has said where the vehicle is
    std::optional<Pose2> odometry_at_last_, odometry_now_;
    bool odometry_is_new_ = false;
    Pose2 velocity_;  ///< in the vehicle frame, per second
};
}  // namespace rtob

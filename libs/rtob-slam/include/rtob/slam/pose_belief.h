// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/fusion/fusion_options.h>
#include <Eigen/Core>

namespace rtob
{
/// How far off the pose may be: the covariance of a Kalman filter whose means are kept elsewhere.
///
/// Its state is the error of the pose, of the velocity, and of the local map, which is as far off
/// as the poses that its scans were written with. A scan says where the vehicle is in the local
/// map, not where that is. So along a bare corridor, where a match says nothing, the velocity is
/// carried on, the pose becomes uncertain, and the map with it; features that turn up then tell the
/// place in the local map again, but only scans from before the corridor tell the place in the map.
///
///     belief.advance(step_s, way_map, by_odometry);
///     belief.matched(covariance);
///     if (scan was written) belief.inserted();
///
/// All in the frame and units of the map: x, y [m], yaw [rad].
class PoseBelief
{
 public:
    /// @param noises of velocities that change, and of odometry
    explicit PoseBelief(const FusionOptions& noises = {});

    /// Nothing is as certain as where a map begins; how fast the vehicle moves is not known.
    void begin();

    /// The vehicle was lost: only matches to come say where it is in the local map.
    /// @param covariance_map of that itself (MapBelief)
    void forget(const Eigen::Matrix3d& covariance_map = Eigen::Matrix3d::Zero());

    /// The vehicle has moved on.
    /// @param way_map since the last scan: what an error of yaw makes of it counts
    /// @param by_odometry else at the velocity of before
    void advance(double step_s, const Eigen::Vector2d& way_map, bool by_odometry);

    /// A scan was matched against the local map.
    /// @param covariance of the match alone
    void matched(const Eigen::Matrix3d& covariance);

    /// A scan was matched against the map as it was before the vehicle can have drifted. However
    /// often that is done, the pose is no more certain than these old scans are.
    /// @param covariance of the match alone
    /// @param covariance_old of the old scans in the map (MapBelief)
    void held(const Eigen::Matrix3d& covariance, const Eigen::Matrix3d& covariance_old);

    /// The scan has become part of the local map.
    void inserted();

    /// Of the pose relative to the local map.
    [[nodiscard]] Eigen::Matrix3d inLocalMap() const;
    /// Of the pose relative to the beginning of the map, or to what last held it.
    [[nodiscard]] Eigen::Matrix3d inMap() const { return p_.topLeftCorner<3, 3>(); }

 private:
    using State = Eigen::Matrix<double, 9, 9>;  ///< pose, velocity, local map
    using Seen = Eigen::Matrix<double, 3, 9>;

    /// Variances of the velocity after 1 s.
    [[nodiscard]] Eigen::Vector3d change() const;
    void update(const Seen& seen, const Eigen::Matrix3d& covariance);
    void raiseTo(const Eigen::Matrix3d& least);

    FusionOptions noises_;
    State p_ = State::Zero();
};
}  // namespace rtob

// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/fusion/fusion_options.h>
#include <rtob/fusion/measurement.h>
#include <rtob/fusion/motion_state.h>

#include <boost/circular_buffer.hpp>
#include <optional>

namespace rtob
{
/// How a vehicle may move of which nothing is known; one sigma. Wide, or the gate would keep a true
/// reading out.
struct UnknownMotion
{
    double speed_mps = 2, turn_radps = 6;
};

/// The paper's second way of pre-aligning (sec. 2.1.2): an extended Kalman filter of the vehicle's
/// motion in the plane, fed by whatever sensors there are, with scan poses as updates.
///
/// Readings come in any order. The filter keeps those of the last history_s with the state after
/// each; one that is late is put in its place, and those after it are applied anew. Allocates
/// nothing after construction.
class MotionFilter
{
 public:
    explicit MotionFilter(const FusionOptions& options = {});

    /// Forgets all: the vehicle is here, and moves in no known way.
    void start(
        double time_s, const Pose2& pose_map_vehicle, const Eigen::Matrix3d& covariance,
        const UnknownMotion& motion = {});
    void stop() { started_ = false; }
    [[nodiscard]] bool started() const { return started_; }

    /// Finite, with a positive covariance.
    /// @return nothing where the reading is older than all that is kept; it is not used then.
    std::optional<Innovation> add(const Measurement& measurement);

    /// A scan's pose. Who gives it has looked at map and scan: where the filter's gate would refuse
    /// it, as after a loop was closed, the vehicle is placed there.
    std::optional<Innovation> addPose(const Measurement& pose);

    /// What is known of this time by all readings up to it; the oldest kept state for what is
    /// older.
    [[nodiscard]] MotionState at(double time_s) const;

    [[nodiscard]] double newest() const;  ///< time of the newest reading [s]
    [[nodiscard]] double oldest() const { return oldest_.time_s; }  ///< an older one is refused

 private:
    struct Step
    {
        Measurement measurement;
        MotionState after;
    };
    using Steps = boost::circular_buffer<Step>;

    [[nodiscard]] const MotionState& before(Steps::const_iterator step) const;
    [[nodiscard]] Steps::iterator insert(const Measurement& measurement);
    Innovation replay(Steps::iterator from);
    void forget(std::size_t count);
    void forgetOld();

    double history_s_;
    MotionNoise noise_;
    NisGate gate_;
    double gyro_bias_radps_;
    MotionState oldest_;  ///< before all steps
    Steps steps_;         ///< by time
    bool started_ = false;
};
}  // namespace rtob
